--  SPDX-License-Identifier: Apache-2.0

--  A test of RAM that finds stuck cells, cells that cannot change, cells that
--  disturb each other, and wrong address decoding (report, 2.4; TST-1, D-17).
--
--  The test is March LR (14 accesses a word) over all zeros, which treats
--  each bit of the memory as a cell of its own; and before it, for bits of
--  one word, which that march always writes alike, five accesses a word with
--  each of four backgrounds. Any two bits of a word differ in one of them.
--  That makes 34 accesses a word.
--
--  It destroys what was in the RAM and leaves it all zeros. It ends at the
--  first fault.

with URVOS.Memories; use URVOS.Memories;
with URVOS.RAM_Models;

generic
   Last : Word_Address;

   with procedure Write (Where : Word_Address; Data : Word);
   with procedure Read (Where : Word_Address; Data : out Word);

   --  For proof alone: whether Write and Read are those of a sound memory,
   --  and that a word of it holds some data. An instance for a real memory
   --  leaves both out: nothing is known of it.
   Is_Model : Boolean := False;
   with function Holds (Where : Word_Address; Data : Word) return Boolean
     is RAM_Models.Not_Known;
package URVOS.RAM_Tests with SPARK_Mode is

   --  Where is the word at which the first fault showed.
   procedure Run (Sound : out Boolean; Where : out Word_Address)
   with
     Post =>
       Where <= Last
       and then (if Sound then Where = 0)

       --  A sound memory passes, and is all zeros after it.
       and then
         (if Is_Model
          then Sound
            and then (for all Place in 0 .. Last => Holds (Place, 0)));

end URVOS.RAM_Tests;
