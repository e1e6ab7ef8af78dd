--  SPDX-License-Identifier: Apache-2.0

with Ada.Characters.Handling; use Ada.Characters.Handling;

with Host.Frame_Layout; use Host.Frame_Layout;
with Host.Names;        use Host.Names;
with URV.Buffers;       use URV.Buffers;
with URV.CORE_Memory;   use URV.CORE_Memory;
with URV.Errors;        use URV.Errors;
with URV.Law_Status;
with URV.Laws;          use URV.Laws;
with URV.Link_Loss;     use URV.Link_Loss;
with URV.Surfaces;      use URV.Surfaces;
with URVOS.Frames;      use URVOS.Frames;

package body Sim.Tables is

   procedure Print (To : in out Text_Output.Writer) is

      procedure Put_Name (Name : String);
      procedure Put (Name : String; Value : Natural);

      --  An array of the texts of a list, from its first.
      generic
         type Item is (<>);
         with function Text (Value : Item) return String;
      procedure Put_List (Name : String);

      Is_First : Boolean := True;

      procedure Put_Name (Name : String) is
      begin
         if Is_First then
            Text_Output.Put_Line (To, "{");
         else
            Text_Output.Put_Line (To, ",");
         end if;
         Is_First := False;
         Text_Output.Put (To, "  """ & Name & """: ");
      end Put_Name;

      procedure Put (Name : String; Value : Natural) is
         Image : constant String := Value'Image;
      begin
         Put_Name (Name);
         Text_Output.Put (To, Image (Image'First + 1 .. Image'Last));
      end Put;

      procedure Put_List (Name : String) is
      begin
         Put_Name (Name);
         for Value in Item loop
            Text_Output.Put (To, (if Value = Item'First then "[" else ", "));
            Text_Output.Put (To, """" & Text (Value) & """");
         end loop;
         Text_Output.Put (To, "]");
      end Put_List;

      function Name (Value : Link_Count) return String is
        (To_Lower (Value'Image));
      function Name (Value : Surface) return String is
        (To_Lower (Value'Image));

      procedure Put_Kinds is new Put_List (Error_Kind, Host.Names.Name);
      procedure Put_Status is new Put_List (Status_Item, Host.Names.Name);
      procedure Put_Counts is new Put_List (Link_Count, Name);
      procedure Put_Surfaces is new Put_List (Surface, Name);
      procedure Put_Lateral is new Put_List (Lateral_Mode, Label);
      procedure Put_Vertical is new Put_List (Vertical_Mode, Label);
      procedure Put_Power is new Put_List (Power_Mode, Label);
      procedure Put_Link is new Put_List (Link_State, Label);
      procedure Put_Frame is new Put_List (Frame_Item, Host.Names.Name);

   begin
      Put ("frame_us", Frame_Length);
      Put ("largest_word", Natural (Converter_Value'Last));
      Put ("neutral_word", Natural (Neutral_Value));
      Put_Kinds ("error_kinds");
      Put_Status ("status");
      Put ("log_rows", Natural (Log_Row_Number'Last));
      Put ("laws_row", Natural (URV.Law_Status.Row_Number));
      Put
        ("age_frames",
         URV.Law_Status.Ticks_Per_Age / Ticks_Per_Major_Frame);
      Put_Lateral ("lateral");
      Put_Vertical ("vertical");
      Put_Power ("power");
      Put_Link ("link");
      Put_Surfaces ("surfaces");
      Put_Counts ("link_counts");
      Put ("log_rows_of_version_1", Rows_Of_First);
      Put ("length_of_version_1", Length (1));
      Put ("length_of_version_2", Length (2));
      Put ("length_of_version_3", Length (3));
      Put_Frame ("frame_words");
      Put ("frame_numbers", Frame_Numbers);
      Put ("unknown_word", Natural (Unknown_Word));
      Text_Output.New_Line (To);
      Text_Output.Put_Line (To, "}");
   end Print;

end Sim.Tables;
