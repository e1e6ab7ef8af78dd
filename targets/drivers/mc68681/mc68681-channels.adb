--  SPDX-License-Identifier: Apache-2.0

package body MC68681.Channels with SPARK_Mode is

   procedure Set_Up (Port : Port_Name) is
   begin
      Write_Command (Port, Reset_Receiver);
      Write_Command (Port, Reset_Sender);
      Write_Command (Port, Reset_Errors);
      Write_Command (Port, Reset_Mode_Pointer);
      Write_Mode (Port, Line_Mode_1);
      Write_Mode (Port, Line_Mode_2);
      Write_Clocks (Port, Outside_Clocks);
      Write_Command (Port, Switch_On_Both);
   end Set_Up;

   --  The flag of an overrun is reset only when it was set: one that comes
   --  between the two accesses would else be lost.
   procedure Receive
     (Port   : Port_Name;
      Counts : in out Error_Counts;
      Result : out Reception)
   is
      Status : Channel_Status;
   begin
      Result := (others => <>);
      Read_Status (Port, Status);
      if Status.Received then
         Result.Is_There := True;
         Result.Wrong_Parity := Status.Wrong_Parity;
         Result.Wrong_Framing :=
           Status.Wrong_Framing or else Status.Is_Break;
         Read_Data (Port, Result.Data);
      end if;
      if Status.Overrun then
         Result.Overrun := True;
         Write_Command (Port, Reset_Errors);
      end if;
      if Is_Damaged (Result) then
         Counts := Counted (Counts, Result);
      end if;
   end Receive;

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
