--  SPDX-License-Identifier: Apache-2.0

with Expectations; use Expectations;

package body Variable_Ends is

   procedure Give (Box : in out Messages.Variable; Item : Messages.Message)
   is
      Success : Boolean;
   begin
      Box.Send (Item, Success);
      Expect ("given to an empty box", Success, True);
   end Give;

   function Taken
     (What : String;
      Box  : in out Messages.Variable) return Messages.Message
   is
      Fresh : Boolean;
   begin
      return Item : Messages.Message do
         Box.Look (Item, Fresh);
         Expect (What & ", produced", Fresh, True);
      end return;
   end Taken;

   procedure Expect_Counts
     (What               : String;
      Box                : Messages.Variable;
      Produced, Consumed : Count;
      Misses             : Count := 0)
   is
      State : constant Messages.Boxes.Mailbox := Box.Snapshot;
   begin
      Expect
        (What & ", produced", Count (Messages.Boxes.Produced (State)),
         Produced);
      Expect
        (What & ", consumed", Count (Messages.Boxes.Consumed (State)),
         Consumed);
      Expect (What & ", misses", Messages.Boxes.Misses (State), Misses);
   end Expect_Counts;

end Variable_Ends;
