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
--  The backgrounds concern each word alone, so they may be written to several
--  words at once, as may the zeros before the march, and they may be read so
--  after it. The march may not: a word's effect on the next one is lost when
--  both are written together.
--
--  The test destroys the RAM's contents and leaves zeros. It ends at the first
--  fault.

generic
   --  The words are at First, First + Step, and so on up to Last. Addresses of
   --  bytes are the cheapest.
   type Address is range <>;
   First : Address;
   Last  : Address;
   Step  : Address;

   with procedure Write (Where : Address; Data : Word);
   with procedure Read (Where : Address; Data : out Word);

   --  One word or more at once, from Where on: their number times Step is
   --  Wide_Step. They fill the memory.
   type Wide is mod <>;
   Wide_Step : Address;

   with procedure Write_Wide (Where : Address; Data : Wide);
   with procedure Read_Wide (Where : Address; Data : out Wide);

   --  For proof alone: Is_Model says that both steps are 1 and that all four
   --  procedures are those of a sound memory, and Holds that a word has this
   --  value. An instance for a real memory omits Is_Model; see RAM_Models.
   Is_Model : Boolean := False;
   with function Holds (Where : Address; Data : Word) return Boolean is <>;
package URVOS.RAM_Tests with SPARK_Mode is

   --  Tests the RAM. Where becomes the first faulty word, or the first one
   --  written or read with it.
   procedure Run (Sound : out Boolean; Where : out Address)
   with
     Post =>
       Where in First .. Last
       and then (if Sound then Where = First)

       --  A sound memory passes, and is all zeros after it.
       and then
         (if Is_Model
          then Sound
            and then (for all Place in First .. Last => Holds (Place, 0)));

end URVOS.RAM_Tests;
