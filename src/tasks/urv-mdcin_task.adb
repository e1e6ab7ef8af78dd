--  SPDX-License-Identifier: Apache-2.0

with URVOS;           use URVOS;
with URV.Errors;      use URV.Errors;
with URV.MDCIN_Steps; use URV.MDCIN_Steps;
with URV.Routing;     use URV.Routing;
with URV.Type_Codes;  use URV.Type_Codes;

package body URV.MDCIN_Task with SPARK_Mode is

   procedure Reset is
   begin
      Previous.Write (Neutral_Uplink);
   end Reset;

   procedure Run_Transaction is
      Last    : constant Uplink_Buffer := Previous.Contents;
      Item    : Uplink_Buffer;
      Message : Uplink_Buffer;
      Fresh   : Boolean;
      Success : Boolean;
      Unused_Success : Boolean;
   begin
      TELIN_Variable.Receive (Item, Fresh);
      Message := Passed_On (Item, Fresh, Last);
      Previous.Write (Message);

      if not Fresh then
         Errors.Report (No_Input, 0);
      end if;
      if Is_Unknown (Item, Fresh) then
         Errors.Report (Unknown_Code, Kind_Of (Item));
      end if;
      if Place_Out_Of_Range (Item, Fresh) > 0 then
         Errors.Report
           (Input_Out_Of_Range, Word (Place_Out_Of_Range (Item, Fresh)));
      end if;

      if Is_For_Laws (Item, Fresh) then
         Configuration_Variable.Send (Item, Unused_Success);
      end if;
      if Is_For_Recorder (Item, Fresh) then
         Recorder_Requests.Send (Item, Unused_Success);
      end if;
      Uplink_Variable.Send (Message, Success);
      if not Success then
         Errors.Report (Uplink_Not_Consumed, 0);
      end if;
      Commands_Variable.Send (Message, Success);
      if not Success then
         Errors.Report (Commands_Not_Consumed, 0);
      end if;
   end Run_Transaction;

end URV.MDCIN_Task;
