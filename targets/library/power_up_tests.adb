--  SPDX-License-Identifier: Apache-2.0

with Interfaces;              use Interfaces;
with Machine_Texts;           use Machine_Texts;
with System.Storage_Elements; use System.Storage_Elements;
with Targets;
with URVOS;                   use URVOS;
with URVOS.Memories;          use URVOS.Memories;
with URVOS.RAM_Tests;

package body Power_Up_Tests is

   procedure Run (First, After : System.Address) is
      Last : constant Word_Address := Word_Address ((After - First) / 2 - 1);

      RAM : array (0 .. Last) of Word
      with Volatile, Import, Address => First;

      procedure Write (Where : Word_Address; Data : Word) with Inline;

      procedure Read (Where : Word_Address; Data : out Word) with Inline;

      procedure Write (Where : Word_Address; Data : Word) is
      begin
         RAM (Where) := Data;
      end Write;

      procedure Read (Where : Word_Address; Data : out Word) is
      begin
         Data := RAM (Where);
      end Read;

      package Test is new URVOS.RAM_Tests (Last, Write, Read);

      Sound : Boolean;
      Where : Word_Address;
   begin
      Test.Run (Sound, Where);
      if not Sound then
         Targets.Open_Console;
         Put ("no start: RAM is faulty,");
         Put_Labelled
           ("byte", Unsigned_32 (2 * Where) +
            Unsigned_32 (To_Integer (First)));
         Put_Line;
         Targets.Stop;
      end if;
   end Run;

end Power_Up_Tests;
