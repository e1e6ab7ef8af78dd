--  SPDX-License-Identifier: Apache-2.0

with URVOS;           use URVOS;
with URV.Errors;      use URV.Errors;
with URV.GDCIN_Steps; use URV.GDCIN_Steps;
with URV.Spare_Bits;  use URV.Spare_Bits;
with URV.Type_Codes;  use URV.Type_Codes;

package body URV.GDCIN_Task with SPARK_Mode is

   --  In place of a block of another kind: the last message.
   procedure Take_Last (Item : in out Downlink_Buffer; Fresh : Boolean);

   procedure Reset is
   begin
      Previous.Write (Neutral_Downlink);
   end Reset;

   procedure Take_Last (Item : in out Downlink_Buffer; Fresh : Boolean) is
      Last : constant Downlink_Buffer := Previous.Contents;
   begin
      Item := Passed_On (Item, Fresh, Last);
   end Take_Last;

   procedure Run_Transaction is
      Message : Framed_Downlink;
      Next    : Piece;
      Fresh   : Boolean;
      Success : Boolean;
      Unused_Success : Boolean;
   begin
      TELIN_Variable.Receive (Message.Words, Fresh);
      if not Fresh then
         Errors.Report (No_Input, 0);
      end if;
      if Is_Unknown (Message.Words, Fresh) then
         Errors.Report (Unknown_Code, Kind_Of (Message.Words));
      end if;
      if Has_Out_Of_Range (Message.Words, Fresh) then
         Errors.Report
           (Input_Out_Of_Range,
            Word (Place_Out_Of_Range (Message.Words, Fresh)));
      end if;
      if Is_Of_Recorder (Message.Words, Fresh) then
         Recorder_Blocks.Send (Without_Frame (Message.Words), Unused_Success);
      end if;

      --  The message for CORE, in place.
      if Is_Other_Kind (Message.Words) then
         Take_Last (Message.Words, Fresh);
      else
         Pass_On (Message.Words, Fresh);
      end if;
      Take_Off (Message.Words, Next);
      Previous.Write (Message.Words);
      Unpack (Message.Words, Message.Frame);

      Downlink_Variable.Send (Message, Success);
      if not Success then
         Errors.Report (Downlink_Not_Consumed, 0);
      end if;
      if Has_Piece (Message.Words) then
         Take_Piece (Next);
      else
         Miss_Piece;
      end if;
   end Run_Transaction;

end URV.GDCIN_Task;
