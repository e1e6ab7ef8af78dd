--  SPDX-License-Identifier: Apache-2.0

--  A mailbox that two tasks share (report, section 3.4; MBX-1 to MBX-5).
--
--  The protected object takes the place of the mailbox's semaphore: a
--  message is read and written whole, for any interleaving. Nobody waits
--  here for a message. What each operation does, URVOS.Mailboxes says.

with URVOS.Mailboxes;

generic
   type Message is private;

   --  What a consumer gets that receives before anything was sent (INI-8).
   Neutral : Message;
package URVOS.Shared_Mailboxes with SPARK_Mode is

   package Boxes is new URVOS.Mailboxes (Message, Neutral);

   protected type Variable is

      procedure Send (Item : Message; Success : out Boolean);

      --  Receive, except that a look in vain is not counted as a miss.
      procedure Look (Item : out Message; Fresh : out Boolean);

      procedure Receive (Item : out Message; Fresh : out Boolean);

      --  Puts the box in its first state (INI-8).
      procedure Reset;

      --  Reset, except that the message stays: a warm start.
      procedure Restart;

      --  The box as it stands, for whoever watches over the node.
      function Snapshot return Boxes.Mailbox;

   private
      Contents : Boxes.Mailbox;
   end Variable;

end URVOS.Shared_Mailboxes;
