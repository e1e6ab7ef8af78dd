--  SPDX-License-Identifier: Apache-2.0

--  A memory without faults: an array of 16 KiB. With it GNATprove shows that
--  the RAM test raises no false alarm (TST-1). It is never run.

with URVOS;          use URVOS;
with URVOS.Memories; use URVOS.Memories;
with URVOS.RAM_Tests;

package Sound_Memory with SPARK_Mode is

   Last : constant Word_Address := 16#1FFF#;

   subtype Place is Word_Address range 0 .. Last;

   type Word_Array is array (Place) of Word;

   Cells : Word_Array := (others => 16#DEAD#);

   function Holds (Where : Word_Address; Data : Word) return Boolean is
     (Where in Place and then Cells (Where) = Data)
   with Global => Cells;

   procedure Write (Where : Word_Address; Data : Word)
   with
     Global => (In_Out => Cells),
     Pre    => Where in Place,
     Post   => Cells = (Cells'Old with delta Where => Data);

   procedure Read (Where : Word_Address; Data : out Word)
   with
     Global => (Input => Cells),
     Pre    => Where in Place,
     Post   => Data = Cells (Where);

   package Tests is new URVOS.RAM_Tests
     (Address    => Word_Address,
      First      => 0,
      Last       => Last,
      Step       => 1,
      Write      => Write,
      Read       => Read,
      Wide       => Word,
      Wide_Step  => 1,
      Write_Wide => Write,
      Read_Wide  => Read,
      Is_Model   => True,
      Holds      => Holds);

   --  The test passes for any contents of the memory, and leaves zeros.
   procedure Passes (Sound : out Boolean; Where : out Word_Address)
   with
     Global => (In_Out => Cells),
     Post   => Sound and then (for all Here in Place => Cells (Here) = 0);

end Sound_Memory;
