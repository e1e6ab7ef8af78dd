--  SPDX-License-Identifier: Apache-2.0

--  Claims about the real mailbox. If a contract of the flight software
--  promised too much, one of these would be proved.

with URVOS;       use URVOS;
with URV.Buffers; use URV.Buffers;
with URV.Mailboxes;

package Canaries.Mailboxes with SPARK_Mode is

   use URV.Mailboxes.For_Stick_Words.Boxes;

   --  MBX-2. False: of two messages sent, one is counted.
   procedure Send_Twice (Box : in out Mailbox; Item : Channel_Words)
   with
     Global => null,
     Post   =>
       Contents (Box) = Item
       and then Produced (Box) =  --  VC_POSTCONDITION
         Produced (Box'Old) + 1;

   --  MBX-3. False for a full count: a second look finds nothing new and
   --  counts a miss.
   procedure Receive_Twice (Box : in out Mailbox; Item : out Channel_Words)
   with
     Global => null,
     Post   =>
       Item = Contents (Box'Old)
       and then Misses (Box) > Misses (Box'Old);  --  VC_POSTCONDITION

end Canaries.Mailboxes;
