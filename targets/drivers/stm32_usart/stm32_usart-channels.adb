--  SPDX-License-Identifier: Apache-2.0

package body STM32_USART.Channels with SPARK_Mode is

   procedure Set_Up
     (Port      : Port_Name;
      Bit_Time  : Divider;
      Interrupt : Boolean) is
   begin
      Write_Control_1 (Port, (others => False));
      Write_Control_2 (Port, (Stop => Two));
      Write_Divider (Port, Bit_Time);
      Write_Control_1 (Port, Line_Settings (Interrupt));
   end Set_Up;

   --  A character that arrives between the two accesses is lost and leaves
   --  the flag without a character. The data register is then read, too: else
   --  the flag would stay, and interrupt for ever.
   procedure Receive
     (Port   : Port_Name;
      Counts : in out Error_Counts;
      Result : out Reception)
   is
      Status : Port_Status;
      Data   : Byte;
   begin
      Result := (others => <>);
      Read_Status (Port, Status);
      if Status.Received or else Status.Overrun then
         Read_Data (Port, Data);
         Result.Overrun := Status.Overrun;
         if Status.Received then
            Result.Is_There := True;
            Result.Data := Data;
            Result.Wrong_Parity := Status.Wrong_Parity;
            Result.Wrong_Framing := Status.Wrong_Framing;
            Result.Noise := Status.Noise;
         end if;
         Counts := Counted (Counts, Result);
      end if;
   end Receive;

   --  A write of the data register would reset the shown flag of a wrong
   --  parity, and the character would seem good.
   procedure Look_At_Sender (Port : Port_Name; Is_Free : out Boolean) is
      Status : Port_Status;
   begin
      Read_Status (Port, Status);
      Is_Free :=
        Status.Takes_Character
        and then not (Status.Received and then Status.Wrong_Parity);
   end Look_At_Sender;

   procedure Send (Port : Port_Name; Data : Byte) is
   begin
      Write_Data (Port, Data);
   end Send;

end STM32_USART.Channels;
