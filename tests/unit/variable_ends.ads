--  SPDX-License-Identifier: Apache-2.0

--  The ends of a variable that a task under test does not have: what it is
--  to consume is given, what it has produced is taken.

with URVOS; use URVOS;
with URVOS.Shared_Mailboxes;

generic
   with package Messages is new URVOS.Shared_Mailboxes (<>);
package Variable_Ends is

   --  Into a box whose message, if any, has been consumed.
   procedure Give (Box : in out Messages.Variable; Item : Messages.Message);

   --  Expects one that nobody has taken, and takes it.
   function Taken
     (What : String;
      Box  : in out Messages.Variable) return Messages.Message;

   --  What the box has counted since its reset. A message that was
   --  overwritten is not counted.
   procedure Expect_Counts
     (What               : String;
      Box                : Messages.Variable;
      Produced, Consumed : Count;
      Misses             : Count := 0);

end Variable_Ends;
