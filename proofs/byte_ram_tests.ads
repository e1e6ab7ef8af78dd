--  SPDX-License-Identifier: Apache-2.0

--  The RAM test as start-up code of the bare machines has it (Power_Up_Tests;
--  TST-1), for the proof: by addresses of bytes, with two words at once for
--  the backgrounds, over 64 KiB at the place of the Cortex-M4's RAM. No check
--  fails, whatever the memory reads. It is never run.

with URVOS;          use URVOS;
with URVOS.Memories; use URVOS.Memories;
with URVOS.RAM_Tests;

package Byte_RAM_Tests with SPARK_Mode is

   type Byte_Address is range 0 .. 2 ** 30;

   First : constant Byte_Address := 16#2000_0000#;
   Last  : constant Byte_Address := 16#2000_FFFE#;

   --  The memory: nothing is known of what it reads.
   Cell      : Word := 0 with Volatile;
   Two_Cells : Long := 0 with Volatile;

   function Holds
     (Unused_Where : Byte_Address; Unused_Data : Word) return Boolean
   is (False)
   with Global => null;

   procedure Write (Where : Byte_Address; Data : Word)
   with
     Global => (Output => Cell),
     Pre    => Where in First .. Last and then Where mod 2 = 0;

   procedure Read (Where : Byte_Address; Data : out Word)
   with
     Global => (In_Out => Cell),
     Pre    => Where in First .. Last and then Where mod 2 = 0;

   procedure Write_Long (Where : Byte_Address; Data : Long)
   with
     Global => (Output => Two_Cells),
     Pre    => Where in First .. Last - 2 and then Where mod 2 = 0;

   procedure Read_Long (Where : Byte_Address; Data : out Long)
   with
     Global => (In_Out => Two_Cells),
     Pre    => Where in First .. Last - 2 and then Where mod 2 = 0;

   package Tests is new URVOS.RAM_Tests
     (Address    => Byte_Address,
      First      => First,
      Last       => Last,
      Step       => 2,
      Write      => Write,
      Read       => Read,
      Wide       => Long,
      Wide_Step  => 4,
      Write_Wide => Write_Long,
      Read_Wide  => Read_Long);

end Byte_RAM_Tests;
