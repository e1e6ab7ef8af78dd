--  SPDX-License-Identifier: Apache-2.0

--  The other ends of a variable of a task under test: the test gives the
--  task's inputs and takes its outputs.

with URVOS; use URVOS;
with URVOS.Shared_Mailboxes;

generic
   with package Messages is new URVOS.Shared_Mailboxes (<>);
package Variable_Ends is

   --  Sends to a box whose message, if any, has been consumed.
   procedure Give (Box : in out Messages.Variable; Item : Messages.Message);

   --  Expects a fresh message and takes it.
   function Taken
     (What : String;
      Box  : in out Messages.Variable) return Messages.Message;

   --  Expects the box's counts since its reset. An overwritten message is not
   --  counted.
   procedure Expect_Counts
     (What               : String;
      Box                : Messages.Variable;
      Produced, Consumed : Count;
      Misses             : Count := 0);

end Variable_Ends;
