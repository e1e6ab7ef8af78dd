--  SPDX-License-Identifier: Apache-2.0

with URVOS;           use URVOS;
with URV.Errors;      use URV.Errors;
with URV.GDCIN_Steps; use URV.GDCIN_Steps;
with URV.Routing;     use URV.Routing;
with URV.Type_Codes;  use URV.Type_Codes;

package body URV.GDCIN_Task with SPARK_Mode is

   procedure Reset is
   begin
      Previous.Write (Neutral_Downlink);
   end Reset;

   procedure Run_Transaction is
      Last    : constant Downlink_Buffer := Previous.Contents;
      Item    : Downlink_Buffer;
      Message : Downlink_Buffer;
      Fresh   : Boolean;
      Success : Boolean;
      Unused_Success : Boolean;
   begin
      TELIN_Variable.Receive (Item, Fresh);
      Message := Passed_On (Item, Fresh, Last);
      Previous.Write (To_Keep (Message));

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

      if Is_Of_Recorder (Item, Fresh) then
         Recorder_Blocks.Send (Without_Frame (Item), Unused_Success);
      end if;
      Downlink_Variable.Send (For_CORE (To_Keep (Message)), Success);
      if not Success then
         Errors.Report (Downlink_Not_Consumed, 0);
      end if;
      if Has_Piece (Message) then
         Take_Piece (Piece_Of (Message (Error_Status)));
      end if;
   end Run_Transaction;

end URV.GDCIN_Task;
