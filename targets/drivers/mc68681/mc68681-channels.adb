--  SPDX-License-Identifier: Apache-2.0

package body MC68681.Channels with SPARK_Mode is

   --  Errors are rare: the usual path is without this code.
   procedure Count_Errors
     (Counts        : in out Error_Counts;
      Overrun       : Boolean;
      Wrong_Parity  : Boolean;
      Wrong_Framing : Boolean)
   with
     Global => null,
     Post   =>
       Counts = Counted (Counts'Old, Overrun, Wrong_Parity, Wrong_Framing);
   pragma No_Inline (Count_Errors);

   procedure Set_Up (Port : Port_Name) is
   begin
      Write_Command (Port, Reset_Receiver);
      Write_Command (Port, Reset_Sender);
      Write_Command (Port, Reset_Errors);
      Write_Command (Port, Reset_Mode_Pointer);
      pragma Assert
        (Is_Off (State (Port)) and then not State (Port).Second_Is_Next);
      Write_Mode (Port, Line_Mode_1);
      Write_Mode (Port, Line_Mode_2);
      Write_Clocks (Port, Outside_Clocks);
      Write_Command (Port, Switch_On_Both);
   end Set_Up;

   procedure Count_Errors
     (Counts        : in out Error_Counts;
      Overrun       : Boolean;
      Wrong_Parity  : Boolean;
      Wrong_Framing : Boolean) is
   begin
      Counts := Counted (Counts, Overrun, Wrong_Parity, Wrong_Framing);
   end Count_Errors;

   --  The flag of an overrun is reset only when it was set: one that comes
   --  between the two accesses would else be lost. The reset also clears the
   --  errors of the oldest character: those of one that was not looked at
   --  would be lost.
   procedure Receive
     (Port   : Port_Name;
      Counts : in out Error_Counts;
      Result : out Reception)
   is
      Status : Channel_Status;
   begin
      Read_Status (Port, Status);
      Result :=
        (Is_There       => Status.Received,
         Data           => 0,
         Sender_Is_Free => Status.Takes_Character,
         others         => False);
      if Status.Received then
         if Status.Errors /= No_Errors then
            Result.Wrong_Parity := Has (Status.Errors, Wrong_Parity);
            Result.Wrong_Framing :=
              Has (Status.Errors, Wrong_Framing or Is_Break);
            if Has (Status.Errors, Overrun) then
               Result.Overrun := True;
               Write_Command (Port, Reset_Errors);
            end if;
            Count_Errors
              (Counts, Result.Overrun, Result.Wrong_Parity,
               Result.Wrong_Framing);
         end if;
         Read_Data (Port, Result.Data);
      end if;
   end Receive;

   procedure Look
     (Port           : Port_Name;
      Line           : out Arrival;
      Sender_Is_Free : out Boolean)
   is
      Status : Channel_Status;
   begin
      Read_Status (Port, Status);
      Line :=
        (if Status.Received
         then (if Status.Errors = No_Errors then Good else Faulty)
         else Nothing);
      Sender_Is_Free := Status.Takes_Character;
   end Look;

   procedure Take (Port : Port_Name; Data : out Byte) is
   begin
      Read_Data (Port, Data);
   end Take;

   procedure Look_At_Sender (Port : Port_Name; Is_Free : out Boolean) is
      Status : Channel_Status;
   begin
      Read_Status (Port, Status);
      Is_Free := Status.Takes_Character;
   end Look_At_Sender;

   procedure Send (Port : Port_Name; Data : Byte) is
   begin
      Write_Data (Port, Data);
   end Send;

end MC68681.Channels;
