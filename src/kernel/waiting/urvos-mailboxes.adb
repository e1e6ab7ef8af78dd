--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Mailboxes with SPARK_Mode is

   procedure Send
     (Box     : in out Mailbox;
      Item    : Message;
      Success : out Boolean)
   is
   begin
      Success := not Is_Fresh (Box);
      Box.Data := Item;
      if Success then
         Box.Producer := Box.Producer + 1;
      end if;
   end Send;

   procedure Look
     (Box   : in out Mailbox;
      Item  : out Message;
      Fresh : out Boolean)
   is
   begin
      Item := Box.Data;
      Fresh := Is_Fresh (Box);
      Box.Consumer := Box.Producer;
   end Look;

   procedure Receive
     (Box   : in out Mailbox;
      Item  : out Message;
      Fresh : out Boolean)
   is
   begin
      Look (Box, Item, Fresh);
      if not Fresh then
         Box.Missed := Incremented (Box.Missed);
      end if;
   end Receive;

end URVOS.Mailboxes;
