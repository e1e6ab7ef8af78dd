--  SPDX-License-Identifier: Apache-2.0

--  The wire log: every byte on the serial link as it leaves the sender's
--  DUART, before any fault on the line (--wire).

with Host.Text_Output;
with URVOS; use URVOS;

package Sim.Wire_Log is

   --  Writes the line with the names of the columns.
   procedure Write_Header (To : in out Text_Output.Writer)
     with Pre => Text_Output.Is_Open (To);

   --  Writes one byte.
   procedure Write_Byte
     (To   : in out Text_Output.Writer;
      Time : Microseconds;
      Path : Direction;
      Data : Byte)
     with Pre => Text_Output.Is_Open (To);

end Sim.Wire_Log;
