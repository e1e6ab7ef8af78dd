--  SPDX-License-Identifier: Apache-2.0

--  The order in which the task control blocks stand in their queues (report,
--  3.2; KRN-1).
--
--  All TCBs stand in one row, each at one place. The queues are stretches
--  of that row, so that a TCB is in exactly one queue, whatever happens:
--  putting it into another queue is moving it along the row.

package URVOS.Arrangements with Pure, SPARK_Mode is

   Number_Of_TCBs : constant := 16;

   --  A task control block.
   type TCB_Number is range 1 .. Number_Of_TCBs;

   --  A place in the row.
   type Place is range 1 .. Number_Of_TCBs;

   type Arrangement is private;

   function TCB_At (Row : Arrangement; Where : Place) return TCB_Number
   with Global => null;

   --  Only contracts ask for it.
   function Place_Of (Row : Arrangement; Which : TCB_Number) return Place
   with Global => null;

   --  Every TCB has one place and every place one TCB.
   function Is_Sound (Row : Arrangement) return Boolean is
     ((for all Which in TCB_Number =>
         TCB_At (Row, Place_Of (Row, Which)) = Which)
      and then
        (for all Where in Place =>
           Place_Of (Row, TCB_At (Row, Where)) = Where))
   with Global => null;

   --  Where a TCB stands after one was moved from a place to another.
   function Place_After_Move
     (Before, From, To : Place) return Place
   is
     (if Before = From then To
      elsif From < To and then Before in From .. To then Before - 1
      elsif To < From and then Before in To .. From then Before + 1
      else Before)
   with Global => null;

   --  Every TCB at the place of its own number.
   function Initial_Arrangement return Arrangement
   with
     Global => null,
     Post   =>
       Is_Sound (Initial_Arrangement'Result)
       and then
         (for all Which in TCB_Number =>
            Place_Of (Initial_Arrangement'Result, Which) = Place (Which));

   --  Moves one TCB. Those between move up by one, all others stay.
   procedure Move (Row : in out Arrangement; From, To : Place)
   with
     Global => null,
     Pre    => Is_Sound (Row),
     Post   =>
       Is_Sound (Row)
       and then
         (for all Which in TCB_Number =>
            Place_Of (Row, Which) =
              Place_After_Move (Place_Of (Row'Old, Which), From, To));

private

   type Arrangement is array (Place) of TCB_Number;

   function TCB_At (Row : Arrangement; Where : Place) return TCB_Number is
     (Row (Where));

   --  Contracts ask for the place of each of every pair of TCBs. Where they
   --  are executed, in tests, this one is not.
   pragma Assertion_Policy (Post => Ignore);

   --  The first place of a TCB.
   function Found (Row : Arrangement; Which : TCB_Number) return Place
   with
     Global => null,
     Post   =>
       (for all Where in Place =>
          (if Row (Where) = Which then Row (Found'Result) = Which));

   function Place_Of (Row : Arrangement; Which : TCB_Number) return Place is
     (Found (Row, Which));

end URVOS.Arrangements;
