--  SPDX-License-Identifier: Apache-2.0

with Host.Names; use Host.Names;

package body Partitions.Columns is

   --  A group of columns: all words of one array.
   generic
      type Item is (<>);
      type Word_List is array (Item) of URVOS.Word;
      with function Name (Which : Item) return String is <>;
   package Groups is
      function Names (Group : String) return String;
      procedure Append_All (To : in out Row; Words : Word_List);
   end Groups;

   package body Groups is

      function Names_From (Group : String; First : Item) return String is
        ("," & Group & "." & Name (First)
         & (if First = Item'Last then ""
            else Names_From (Group, Item'Succ (First))));

      function Names (Group : String) return String is
        (Names_From (Group, Item'First));

      procedure Append_All (To : in out Row; Words : Word_List) is
      begin
         for Each of Words loop
            Append (To, Number (Each));
         end loop;
      end Append_All;

   end Groups;

   package Console  is new Groups (Command_Item, Console_Words);
   package Uplink   is new Groups (Uplink_Item, Uplink_Buffer);
   package PWM      is new Groups (PWM_Item, PWM_Buffer);
   package Downlink is new Groups (Downlink_Item, Downlink_Buffer);
   package Frame    is new Groups (Frame_Item, Frame_Words);

   function Console_Names (Group : String) return String
     renames Console.Names;
   function Uplink_Names (Group : String) return String
     renames Uplink.Names;
   function PWM_Names (Group : String) return String
     renames PWM.Names;
   function Downlink_Names (Group : String) return String
     renames Downlink.Names;
   function Frame_Names (Group : String) return String
     renames Frame.Names;

   procedure Append_Console (To : in out Row; Words : Console_Words)
     renames Console.Append_All;
   procedure Append_Uplink (To : in out Row; Words : Uplink_Buffer)
     renames Uplink.Append_All;
   procedure Append_PWM (To : in out Row; Words : PWM_Buffer)
     renames PWM.Append_All;
   procedure Append_Downlink (To : in out Row; Words : Downlink_Buffer)
     renames Downlink.Append_All;
   procedure Append_Frame (To : in out Row; Words : Frame_Words)
     renames Frame.Append_All;

   procedure Append_Counts (To : in out Row; Counts : Link_Counts) is
   begin
      for Each of Counts loop
         Append (To, Number (Each));
      end loop;
   end Append_Counts;

end Partitions.Columns;
