--  SPDX-License-Identifier: Apache-2.0

with Host.Text_Numbers;
with Host.Text_Output; use Host.Text_Output;

package body Sim.Wire_Log is

   Hexadecimal : constant array (Byte range 0 .. 15) of Character :=
     "0123456789abcdef";

   procedure Write_Header (To : in out Writer) is
   begin
      Put (To, "time_us,direction,byte");
      New_Line (To);
   end Write_Header;

   procedure Write_Byte
     (To   : in out Writer;
      Time : Microseconds;
      Path : Direction;
      Data : Byte) is
   begin
      Put (To, Text_Numbers.Number (Time));
      Put (To, (case Path is when Up => ",up,", when Down => ",down,"));
      Put (To, Hexadecimal (Data / 16));
      Put (To, Hexadecimal (Data mod 16));
      New_Line (To);
   end Write_Byte;

end Sim.Wire_Log;
