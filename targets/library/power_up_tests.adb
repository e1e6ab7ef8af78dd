--  SPDX-License-Identifier: Apache-2.0

with Interfaces;              use Interfaces;
with Machine_Texts;           use Machine_Texts;
with System.Storage_Elements; use System.Storage_Elements;
with Targets;
with URVOS;                   use URVOS;
with URVOS.Memories;          use URVOS.Memories;
with URVOS.RAM_Tests;

package body Power_Up_Tests is

   --  Checks would cost as much as the accesses. GNATprove shows that none
   --  fails in Byte_RAM_Tests, the same instance over constant addresses.
   pragma Suppress (All_Checks);

   --  Both machines have their RAM at such addresses.
   type Byte_Address is range 0 .. 2 ** 30;

   --  The proof's model is another instance.
   function Holds
     (Unused_Where : Byte_Address; Unused_Data : Word) return Boolean
   is (False);

   procedure Write (Where : Byte_Address; Data : Word) with Inline;
   procedure Read (Where : Byte_Address; Data : out Word) with Inline;

   procedure Write_Long (Where : Byte_Address; Data : Long) with Inline;
   procedure Read_Long (Where : Byte_Address; Data : out Long) with Inline;

   procedure Write (Where : Byte_Address; Data : Word) is
      Place : Word
      with Volatile, Import, Address => To_Address (Integer_Address (Where));
   begin
      Place := Data;
   end Write;

   procedure Read (Where : Byte_Address; Data : out Word) is
      Place : Word
      with Volatile, Import, Address => To_Address (Integer_Address (Where));
   begin
      Data := Place;
   end Read;

   procedure Write_Long (Where : Byte_Address; Data : Long) is
      Place : Long
      with Volatile, Import, Address => To_Address (Integer_Address (Where));
   begin
      Place := Data;
   end Write_Long;

   procedure Read_Long (Where : Byte_Address; Data : out Long) is
      Place : Long
      with Volatile, Import, Address => To_Address (Integer_Address (Where));
   begin
      Data := Place;
   end Read_Long;

   procedure Run (First, After : System.Address) is
      package Test is new URVOS.RAM_Tests
        (Address    => Byte_Address,
         First      => Byte_Address (To_Integer (First)),
         Last       => Byte_Address (To_Integer (After)) - 2,
         Step       => 2,
         Write      => Write,
         Read       => Read,
         Wide       => Long,
         Wide_Step  => 4,
         Write_Wide => Write_Long,
         Read_Wide  => Read_Long);

      Sound : Boolean;
      Where : Byte_Address;
   begin
      Test.Run (Sound, Where);
      if not Sound then
         Targets.Open_Console;
         Put ("no start: RAM is faulty,");
         Put_Labelled ("byte", Unsigned_32 (Where));
         Put_Line;
         Targets.Stop;
      end if;
   end Run;

end Power_Up_Tests;
