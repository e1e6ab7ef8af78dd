--  SPDX-License-Identifier: Apache-2.0

--  A mailbox that two tasks share (report, section 3.4; MBX-1 to MBX-5).
--
--  The protected object replaces the mailbox's semaphore: a message is read
--  and written whole, for any interleaving. No task waits here for a message.
--  URVOS.Mailboxes specifies each operation.

with URVOS.Mailboxes;

generic
   type Message is private;

   --  The message that a consumer gets before any was sent (INI-8).
   Neutral : Message;
package URVOS.Shared_Mailboxes with SPARK_Mode is

   package Boxes is new URVOS.Mailboxes (Message, Neutral);

   protected type Variable is

      procedure Send (Item : Message; Success : out Boolean);

      --  Receive, except that a look without a new message counts no miss.
      procedure Look (Item : out Message; Fresh : out Boolean);

      procedure Receive (Item : out Message; Fresh : out Boolean);

      --  Puts the box in its first state (INI-8).
      procedure Reset;

      --  Reset, except that the message remains: a warm start.
      procedure Restart;

      --  The present box, for monitors of the node.
      function Snapshot return Boxes.Mailbox;

   private
      Contents : Boxes.Mailbox;
   end Variable;

end URVOS.Shared_Mailboxes;
