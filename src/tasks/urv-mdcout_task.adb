--  SPDX-License-Identifier: Apache-2.0

with Devices.PWM_Board; use Devices.PWM_Board;
with URVOS;             use URVOS;
with URVOS.Task_Trees;  use URVOS.Task_Trees;
with URV.Errors;        use URV.Errors;
with URV.MDCOUT_Steps;  use URV.MDCOUT_Steps;
with URV.Routing;       use URV.Routing;

package body URV.MDCOUT_Task with SPARK_Mode is

   procedure Run_Transaction (Now : Clock_Tick) is
      Bits    : constant Word          := Node_Status.Contents;
      Set     : constant Schedule_Name := Schedule.Contents;
      Card    : constant Word          := Card_Shown.Contents;
      Area    : constant Data_Area     := PWM_Board.Contents;
      Frame   : constant Frame_Words   := Frame_Of (Now, Set, Card, Area);
      Unknown : constant Unknown_Count := First_Unknown_Sensor (Codes);
      Image   : AD_Image;
      Message : Downlink_Buffer;
      Block   : Downlink_Buffer;
      Is_Sent : Boolean;
      Next    : Piece;
      Fresh   : Boolean;
      Success : Boolean;
      Unused_Success : Boolean;
   begin
      AD_Variable.Receive (Image, Fresh);
      Message := Message_Of (Image, Fresh, Codes, Bits);
      if Unknown > 0 then
         Errors.Report (Unknown_Code, Codes (Channel (Unknown - 1)));
      end if;
      if not Fresh then
         Errors.Report (No_Image, 0);
      end if;
      if Has_Out_Of_Range (Message, Fresh) then
         Errors.Report (Input_Out_Of_Range, Code_Out_Of_Range (Message));
      end if;

      Downlink_Variable.Send ((Words => Message, Frame => Frame), Success);
      if not Success then
         Errors.Report (Downlink_Not_Consumed, 0);
      end if;
      Sensors_Variable.Send (Message, Unused_Success);
      Next_Block (Message, Block, Is_Sent);
      if not Is_Sent then
         Next_Piece (Next);
         Block := For_Link (Message, Frame, Next);
      end if;
      TELOUT_Variable.Send (Block, Success);
      if not Success then
         Errors.Report (Output_Not_Consumed, 0);
      end if;
   end Run_Transaction;

end URV.MDCOUT_Task;
