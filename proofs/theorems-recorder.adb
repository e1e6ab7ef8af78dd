--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Recorder with SPARK_Mode is

   procedure Rows_Have_Their_Own_Places
     (Kept : Ring; One, Other : Row_Number) is null;

   procedure A_New_Row_Replaces_The_Oldest
     (Kept : Ring; Each : Row_Number) is null;

   procedure Three_Words_Arrive (One, Two, Three : Word) is null;

   procedure A_Row_Arrives (Item : Row; Which : Part; Three : Group) is
      First : constant Row_Word := First_Word (Which, Three);
   begin
      Three_Words_Arrive
        (Word_At (Item, First), Word_At (Item, First + 1),
         Word_At (Item, First + 2));
   end A_Row_Arrives;

   procedure A_Request_Arrives (Item : Request) is
   begin
      pragma Assert
        (Row_Number (High_Bits (Item.First)) = Item.First / 2 ** 12);
      pragma Assert
        (Row_Number (Low_Bits (Item.First)) = Item.First mod 2 ** 12);
      pragma Assert (Block_Of (Item) (Pitch) = High_Bits (Item.First));
      pragma Assert (Block_Of (Item) (Yaw) = Low_Bits (Item.First));
      pragma Assert (Request_Of (Block_Of (Item)).First = Item.First);
      pragma Assert (Request_Of (Block_Of (Item)).Rows = Item.Rows);
   end A_Request_Arrives;

   procedure Nothing_Goes_Down_In_Flight
     (Sending : Line; Kept : Ring; Item : Request; Sensors : Downlink_Buffer)
   is null;

   procedure Nothing_Goes_Down_Without_A_Request
     (Sending : Line; Kept : Ring; On_Ground : Boolean) is null;

   procedure Sensors_Have_Each_Fifth_Frame
     (Sending : Line; Kept : Ring; On_Ground : Boolean) is null;

end Theorems.Recorder;
