--  A mailbox that two tasks share (report, section 3.4; MBX-1 to MBX-5).
--
--  The protected object takes the place of the mailbox's semaphore: a
--  message is read and written whole, for any interleaving. Nobody waits
--  here for a message.

with URVOS.Mailboxes;

generic
   with package Boxes is new URVOS.Mailboxes (<>);
package URVOS.Shared_Mailboxes
  with
    SPARK_Mode,
    Abstract_State =>
      (Box with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => Box
is

   subtype Message is Boxes.Message;

   procedure Send (Item : Message; Success : out Boolean)
   with Global => (In_Out => Box);

   --  Receive, but that a look in vain is not counted as a miss.
   procedure Look (Item : out Message; Fresh : out Boolean)
   with
     Global  => (In_Out => Box),
     Depends => ((Box, Item, Fresh) => Box);

   procedure Receive (Item : out Message; Fresh : out Boolean)
   with
     Global  => (In_Out => Box),
     Depends => ((Box, Item, Fresh) => Box);

   --  Puts the box in its first state (INI-8).
   procedure Reset
   with Global => (In_Out => Box);

   --  The same, but that the message stays: a warm start.
   procedure Restart
   with Global => (In_Out => Box);

   --  The box as it stands, for whoever watches over the node.
   procedure Inspect (Snapshot : out Boxes.Mailbox)
   with
     Global  => (Input => Box),
     Depends => (Snapshot => Box);

end URVOS.Shared_Mailboxes;
