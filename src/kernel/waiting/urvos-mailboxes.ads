--  SPDX-License-Identifier: Apache-2.0

--  A mailbox: one message from one producer to one consumer (report, section
--  3.4; MBX-1 to MBX-4, D-21).
--
--     Send    (Box, Command, Success);
--     Receive (Box, Command, Fresh);
--
--  The producer flag counts the messages produced, the consumer flag those
--  consumed. They differ, by one, exactly while the message in the box has not
--  been received. A message that overwrites an unconsumed one is not counted
--  again.
--
--  The message type fixes the size of the data. A message that does not fit
--  the box does not compile.
--
--  The counting flags wrap round; only whether they differ matters. The
--  count of misses stops at its last value.

generic
   type Message is private;

   --  The message that a consumer gets before any was sent (INI-8).
   Neutral : Message;
package URVOS.Mailboxes with Pure, SPARK_Mode is

   type Flag is mod 2 ** 32;

   type Mailbox is private;

   function Contents (Box : Mailbox) return Message
   with Global => null;

   function Produced (Box : Mailbox) return Flag
   with Global => null;

   function Consumed (Box : Mailbox) return Flag
   with Global => null;

   --  The number of Receives that found nothing new.
   function Misses (Box : Mailbox) return Count
   with Global => null;

   --  The message in the box has not been received yet.
   function Is_Fresh (Box : Mailbox) return Boolean is
     (Produced (Box) /= Consumed (Box))
   with
     Global => null,
     Post   => Is_Fresh'Result = (Produced (Box) = Consumed (Box) + 1);

   --  A box in its defined first state.
   function Empty_Mailbox return Mailbox
   with
     Global => null,
     Post   =>
       Contents (Empty_Mailbox'Result) = Neutral
       and then Produced (Empty_Mailbox'Result) = 0
       and then Consumed (Empty_Mailbox'Result) = 0
       and then Misses (Empty_Mailbox'Result) = 0;

   --  A box after a warm start: flags and count as in the first state; the old
   --  message remains as an acceptable previous one (INI-8).
   function Restarted (Box : Mailbox) return Mailbox
   with
     Global => null,
     Post   =>
       Contents (Restarted'Result) = Contents (Box)
       and then Produced (Restarted'Result) = 0
       and then Consumed (Restarted'Result) = 0
       and then Misses (Restarted'Result) = 0;

   --  Leaves Item in the box. Success is False if it replaced a message that
   --  the consumer had not received.
   procedure Send
     (Box     : in out Mailbox;
      Item    : Message;
      Success : out Boolean)
   with
     Global => null,
     Post   =>
       Contents (Box) = Item
       and then Is_Fresh (Box)
       and then Success = not Is_Fresh (Box'Old)

       --  The flag advances only if the message replaces no unconsumed one.
       and then Produced (Box) =
         (if Success then Produced (Box'Old) + 1 else Produced (Box'Old))
       and then Consumed (Box) = Consumed (Box'Old)
       and then Misses (Box) = Misses (Box'Old);

   --  Gives the message in the box, as Receive does, but counts no miss. A
   --  RECV that waits uses it for all looks but the last (MBX-3).
   procedure Look
     (Box   : in out Mailbox;
      Item  : out Message;
      Fresh : out Boolean)
   with
     Global => null,
     Post   =>
       Item = Contents (Box'Old)
       and then Contents (Box) = Contents (Box'Old)
       and then Fresh = Is_Fresh (Box'Old)
       and then not Is_Fresh (Box)
       and then Produced (Box) = Produced (Box'Old)
       and then Consumed (Box) = Produced (Box)
       and then Misses (Box) = Misses (Box'Old);

   --  Gives the message in the box. Fresh is True if the message was not given
   --  before. If it was, the miss is counted.
   procedure Receive
     (Box   : in out Mailbox;
      Item  : out Message;
      Fresh : out Boolean)
   with
     Global => null,
     Post   =>
       Item = Contents (Box'Old)
       and then Contents (Box) = Contents (Box'Old)
       and then Fresh = Is_Fresh (Box'Old)
       and then not Is_Fresh (Box)
       and then Produced (Box) = Produced (Box'Old)
       and then Consumed (Box) = Produced (Box)
       and then Misses (Box) =
         (if Fresh then Misses (Box'Old)
          else Incremented (Misses (Box'Old)));

private

   type Mailbox is record
      Data     : Message := Neutral;
      Producer : Flag    := 0;
      Consumer : Flag    := 0;
      Missed   : Count   := 0;
   end record
   with Predicate => Producer - Consumer <= 1;

   function Contents (Box : Mailbox) return Message is (Box.Data);

   function Produced (Box : Mailbox) return Flag is (Box.Producer);

   function Consumed (Box : Mailbox) return Flag is (Box.Consumer);

   function Misses (Box : Mailbox) return Count is (Box.Missed);

   function Empty_Mailbox return Mailbox is
     ((Data => Neutral, Producer => 0, Consumer => 0, Missed => 0));

   function Restarted (Box : Mailbox) return Mailbox is
     ((Data => Box.Data, Producer => 0, Consumer => 0, Missed => 0));

end URVOS.Mailboxes;
