--  SPDX-License-Identifier: Apache-2.0

--  A RAM test that finds stuck cells, cells that cannot change, cells that
--  disturb each other, and wrong address decoding (report, 2.4; TST-1, D-17).
--
--  The main part is March LR, 14 accesses a word, over all zeros; it treats
--  each bit as a cell of its own. It always writes the bits of one word alike.
--  Before it, therefore, each word gets five accesses with each of four
--  backgrounds; any two bits of a word differ in one of them. The total is 34
--  accesses a word.
--
--  The test destroys the RAM's contents and leaves zeros. It ends at the first
--  fault.

with URVOS.Memories; use URVOS.Memories;
with URVOS.RAM_Models;

generic
   Last : Word_Address;

   with procedure Write (Where : Word_Address; Data : Word);
   with procedure Read (Where : Word_Address; Data : out Word);

   --  For proof alone: Is_Model says that Write and Read are those of a sound
   --  memory, and Holds that a word has this value. An instance for a real
   --  memory omits both.
   Is_Model : Boolean := False;
   with function Holds (Where : Word_Address; Data : Word) return Boolean
     is RAM_Models.Not_Known;
package URVOS.RAM_Tests with SPARK_Mode is

   --  Tests the RAM. Where becomes the first faulty word.
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
