--  SPDX-License-Identifier: Apache-2.0

--  The order in which the march in flight tests the RAM, cell by cell (report,
--  2.4; TST-5). A cell is a long word.
--
--     if Has_Cell (Walk) then
--        March (Place_Of (Walk.Next, Parts));
--        Walk := After_Cell (Walk, Parts);
--     end if;
--
--  The cells are numbered: first those of the scratchpad, as in the self-test
--  before a start, then those of the variables and the stack. After the last
--  one the walk begins again. A minor frame tests a limited number of cells:
--  if no minor frame is served, the walk comes to rest.

with URVOS.Memories; use URVOS.Memories;

package URVOS.RAM_Walks with Pure, SPARK_Mode is

   type Cell_Count is range 0 .. 2 ** 22;

   subtype Cell_Number is Cell_Count range 0 .. Cell_Count'Last - 1;

   type Part_Name is (Scratchpad, Variables);

   --  The number of cells of each part.
   type Part_Sizes is array (Part_Name) of Cell_Count
   with
     Predicate =>
       Part_Sizes (Scratchpad) in 1 .. 2 ** 21
       and then Part_Sizes (Variables) in 1 .. 2 ** 21;

   function Last_Cell (Parts : Part_Sizes) return Cell_Number is
     (Parts (Scratchpad) + Parts (Variables) - 1)
   with Global => null;

   --  A cell, by its number in its part.
   type Place is record
      Part : Part_Name   := Scratchpad;
      Cell : Cell_Number := 0;
   end record;

   function Place_Of (Number : Cell_Number; Parts : Part_Sizes) return Place
   is
     (if Number < Parts (Scratchpad) then (Scratchpad, Number)
      else (Variables, Number - Parts (Scratchpad)))
   with
     Global => null,
     Pre    => Number <= Last_Cell (Parts),
     Post   => Place_Of'Result.Cell < Parts (Place_Of'Result.Part);

   --  The address of a cell's first word, for the result of the self-test.
   function Word_Of (Number : Cell_Number) return Word_Address is
     (2 * Word_Address (Number))
   with Global => null;

   type Walk is record
      Next : Cell_Number := 0;

      --  Cells that may still be tested in this minor frame.
      Left : Cell_Count  := 0;
   end record;

   function Has_Cell (This : Walk) return Boolean is (This.Left > 0)
   with Global => null;

   --  The walk in the next minor frame.
   function After_Tick (This : Walk; Cells : Cell_Count) return Walk is
     ((This with delta Left => Cells))
   with Global => null;

   function Next_After
     (Number : Cell_Number;
      Parts  : Part_Sizes) return Cell_Number
   is (if Number < Last_Cell (Parts) then Number + 1 else 0)
   with
     Global => null,
     Post   => Next_After'Result <= Last_Cell (Parts);

   --  The walk after the test of its next cell.
   function After_Cell (This : Walk; Parts : Part_Sizes) return Walk is
     ((Next => Next_After (This.Next, Parts), Left => This.Left - 1))
   with
     Global => null,
     Pre    => Has_Cell (This);

end URVOS.RAM_Walks;
