--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Mailboxes with SPARK_Mode is

   procedure Send_Twice (Box : in out Mailbox; Item : Channel_Words) is
      First, Second : Boolean;
   begin
      Send (Box, Item, First);
      Send (Box, Item, Second);
      pragma Assert (not Second);
      pragma Unreferenced (First);
   end Send_Twice;

   procedure Receive_Twice (Box : in out Mailbox; Item : out Channel_Words) is
      Old_Item         : Channel_Words;
      Old_Fresh, Fresh : Boolean;
   begin
      Receive (Box, Old_Item, Old_Fresh);
      pragma Assert (not Is_Fresh (Box));
      Receive (Box, Item, Fresh);
      pragma Assert (not Fresh);
      pragma Unreferenced (Old_Item, Old_Fresh);
   end Receive_Twice;

end Canaries.Mailboxes;
