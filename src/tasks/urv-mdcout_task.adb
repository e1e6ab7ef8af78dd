--  SPDX-License-Identifier: Apache-2.0

with Devices.PWM_Board; use Devices.PWM_Board;
with URVOS;             use URVOS;
with URVOS.Task_Trees;  use URVOS.Task_Trees;
with URV.Errors;        use URV.Errors;
with URV.MDCOUT_Steps;  use URV.MDCOUT_Steps;
with URV.Routing;       use URV.Routing;

package body URV.MDCOUT_Task with SPARK_Mode is

   Unknown : constant Unknown_Count := First_Unknown_Sensor (Codes);

   --  The message of an image and its frame, to all consumers. It is changed
   --  in place: a message has no copy but its consumers'.
   procedure Pass_On (Now : Clock_Tick; Image : AD_Image; Fresh : Boolean);

   procedure Run_Transaction (Now : Clock_Tick) is
      Image : AD_Image;
      Fresh : Boolean;
   begin
      AD_Variable.Receive (Image, Fresh);
      Pass_On (Now, Image, Fresh);
   end Run_Transaction;

   procedure Pass_On (Now : Clock_Tick; Image : AD_Image; Fresh : Boolean) is
      Bits    : constant Word          := Node_Status.Contents;
      Set     : constant Schedule_Name := Schedule.Contents;
      Card    : constant Word          := Card_Shown.Contents;
      Area    : constant Data_Area     := PWM_Board.Contents;
      Message : Framed_Downlink        :=
        (Words => Sensors_Of (Image, Codes),
         Frame => Frame_Of (Now, Set, Card, Area));
      Block   : Downlink_Buffer;
      Is_Sent : Boolean;
      Next    : Piece;
      Success : Boolean;
      Unused_Success : Boolean;
   begin
      Mark (Message.Words, (if Fresh then Bits else Bits or Stale_Data));
      pragma Assert (Message.Words = Message_Of (Image, Fresh, Codes, Bits));
      if Unknown > 0 then
         Errors.Report (Unknown_Code, Codes (Channel (Unknown - 1)));
      end if;
      if not Fresh then
         Errors.Report (No_Image, 0);
      end if;
      if Has_Out_Of_Range (Message.Words, Fresh) then
         Errors.Report
           (Input_Out_Of_Range, Code_Out_Of_Range (Message.Words));
      end if;

      Downlink_Variable.Send (Message, Success);
      if not Success then
         Errors.Report (Downlink_Not_Consumed, 0);
      end if;
      Sensors_Variable.Send (Message.Words, Unused_Success);
      Next_Block (Message.Words, Block, Is_Sent);
      if not Is_Sent then
         Next_Piece (Next);
         Block := Message.Words;
         Add_Frame (Block, Message.Frame, Next);
      end if;
      TELOUT_Variable.Send (Block, Success);
      if not Success then
         Errors.Report (Output_Not_Consumed, 0);
      end if;
   end Pass_On;

end URV.MDCOUT_Task;
