--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Shared_Mailboxes with SPARK_Mode is

   protected body Variable is

      procedure Send (Item : Message; Success : out Boolean) is
      begin
         Boxes.Send (Contents, Item, Success);
      end Send;

      procedure Look (Item : out Message; Fresh : out Boolean) is
      begin
         Boxes.Look (Contents, Item, Fresh);
      end Look;

      procedure Receive (Item : out Message; Fresh : out Boolean) is
      begin
         Boxes.Receive (Contents, Item, Fresh);
      end Receive;

      procedure Reset is
      begin
         Contents := Boxes.Empty_Mailbox;
      end Reset;

      procedure Restart is
      begin
         Contents := Boxes.Restarted (Contents);
      end Restart;

      function Snapshot return Boxes.Mailbox is (Contents);

   end Variable;

end URVOS.Shared_Mailboxes;
