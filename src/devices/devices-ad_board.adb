--  SPDX-License-Identifier: Apache-2.0

package body Devices.AD_Board with SPARK_Mode is

   procedure Start (Board : in out Registers; Channel : Channel_Number) is
   begin
      Board.Channel := Channel;
      Board.Doing := Start_Wanted;
   end Start;

   procedure Begin_Conversion (Board : in out Registers) is
   begin
      if Board.Doing = Start_Wanted then
         Board.Doing := Converting;
      end if;
   end Begin_Conversion;

   procedure Finish (Board : in out Registers; Value : Word) is
   begin
      if Board.Doing = Converting then
         Board.Data := Value;
         Board.Doing := Idle;
      end if;
   end Finish;

end Devices.AD_Board;
