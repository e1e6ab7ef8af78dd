--  SPDX-License-Identifier: Apache-2.0

with Host.Complaints;   use Host.Complaints;
with Host.Text_Input;
with Host.Text_Numbers; use Host.Text_Numbers;

package body Host.Scripts is

   use type Number;

   Time_Column : constant String := "time_ms";
   Longest_Time : constant := 10_000_000_000;
   Largest_Word : constant Number := Number (Converter_Value'Last);

   --  The contents of a column of the file.
   type Column_Kind is (Time, A_Word, Nothing);
   type Column is record
      Kind  : Column_Kind := Nothing;
      Which : Item        := Item'First;
   end record;

   --  Each column at most once: time, every item and the one without effect.
   Most_Columns : constant Positive := Neutral'Length + 2;
   type Column_List is array (1 .. Most_Columns) of Column;

   --  Returns the fields of a line one by one.
   type Field_Cursor is record
      Next : Positive;
      More : Boolean;
   end record;

   procedure Next_Field
     (Line   : String;
      Cursor : in out Field_Cursor;
      First  : out Positive;
      Last   : out Natural);

   --  The names from that one on, each after a comma.
   function Names_From (Which : Item) return String;

   --  Sets the kind of a column from its name in the header.
   procedure Find_Column
     (From  : Text_Input.Reader;
      Title : String;
      Found : out Column);

   procedure Read_Header
     (From    : in out Text_Input.Reader;
      Columns : out Column_List;
      Count   : out Natural);

   procedure Read_Row
     (From    : Text_Input.Reader;
      Columns : Column_List;
      Count   : Natural;
      Row     : out Timed_Words);

   procedure Next_Field
     (Line   : String;
      Cursor : in out Field_Cursor;
      First  : out Positive;
      Last   : out Natural) is
   begin
      First := Cursor.Next;
      Last  := Cursor.Next - 1;
      while Last < Line'Last and then Line (Last + 1) /= ',' loop
         Last := Last + 1;
      end loop;
      Cursor.More := Last < Line'Last;
      Cursor.Next := Last + 2;
   end Next_Field;

   function Names_From (Which : Item) return String is
     (", " & Name (Which)
      & (if Which = Item'Last then "" else Names_From (Item'Succ (Which))));

   procedure Find_Column
     (From  : Text_Input.Reader;
      Title : String;
      Found : out Column) is
   begin
      if Title = Time_Column then
         Found := (Kind => Time, others => <>);
         return;
      elsif Title /= "" and then Title = Column_Without_Effect then
         Found := (Kind => Nothing, others => <>);
         return;
      end if;

      for Which in Item loop
         if Name (Which) = Title then
            Found := (A_Word, Which);
            return;
         end if;
      end loop;
      Text_Input.Refuse
        (From,
         "unknown column " & Quoted (Title) & "; there are " & Time_Column
         & Names_From (Item'First)
         & (if Column_Without_Effect = "" then ""
            else ", " & Column_Without_Effect));
   end Find_Column;

   procedure Read_Header
     (From    : in out Text_Input.Reader;
      Columns : out Column_List;
      Count   : out Natural)
   is
      Found    : Boolean;
      Has_Time : Boolean := False;
   begin
      Columns := (others => <>);
      Count   := 0;
      Text_Input.Next_Line (From, Found);
      if not Found then
         Text_Input.Refuse (From, "the file is empty");
      end if;

      declare
         Line        : constant String := Text_Input.Line (From);
         Cursor      : Field_Cursor := (Line'First, True);
         First       : Positive;
         Last        : Natural;
         This_Column : Column;
      begin
         while Cursor.More loop
            Next_Field (Line, Cursor, First, Last);
            declare
               Title : constant String :=
                 Text_Input.Trimmed (Line (First .. Last));
            begin
               Find_Column (From, Title, This_Column);
               for Earlier in 1 .. Count loop
                  if Columns (Earlier) = This_Column then
                     Text_Input.Refuse
                       (From, "column " & Quoted (Title) & " comes twice");
                  end if;
               end loop;
            end;
            Count           := Count + 1;
            Columns (Count) := This_Column;
            Has_Time        := Has_Time or else This_Column.Kind = Time;
         end loop;
      end;

      if not Has_Time then
         Text_Input.Refuse
           (From, "there is no column " & Quoted (Time_Column));
      end if;
   end Read_Header;

   procedure Read_Row
     (From    : Text_Input.Reader;
      Columns : Column_List;
      Count   : Natural;
      Row     : out Timed_Words)
   is
      Line     : constant String := Text_Input.Line (From);
      Cursor   : Field_Cursor := (Line'First, True);
      First    : Positive;
      Last     : Natural;
      Fields   : Natural := 1;
      Value    : Number;
      Is_Valid : Boolean;
   begin
      for Char of Line loop
         if Char = ',' then
            Fields := Fields + 1;
         end if;
      end loop;
      if Fields /= Count then
         Text_Input.Refuse
           (From,
            "the row has" & Fields'Image & " fields, the header has"
            & Count'Image);
      end if;

      Row := (Time => 0, Value => Neutral);
      for This_Column of Columns (1 .. Count) loop
         Next_Field (Line, Cursor, First, Last);
         declare
            Field : constant String :=
              Text_Input.Trimmed (Line (First .. Last));
         begin
            if This_Column.Kind = Time then
               Read_Decimal (Field, 3, Value, Is_Valid);
               if not Is_Valid or else Value > Longest_Time * 1_000 then
                  Text_Input.Refuse
                    (From,
                     Time_Column & ": " & Quoted (Field)
                     & " is not a time from 0 to"
                     & Longest_Time'Image & " ms"
                     & " with at most three decimals");
               end if;
               Row.Time := Microseconds (Value);
            else
               Read_Either (Field, Value, Is_Valid);
               if not Is_Valid or else Value > Largest_Word then
                  Text_Input.Refuse
                    (From,
                     (if This_Column.Kind = A_Word
                      then Name (This_Column.Which)
                      else Column_Without_Effect)
                     & ": " & Quoted (Field)
                     & " is not a word from 0 to" & Largest_Word'Image);
               end if;
               if This_Column.Kind = A_Word then
                  Row.Value (This_Column.Which) := Word (Value);
               end if;
            end if;
         end;
      end loop;
   end Read_Row;

   procedure Load (Loaded : in out Script; File : String) is
      From    : Text_Input.Reader;
      Columns : Column_List;
      Count   : Natural;
      Found   : Boolean;
      Row     : Timed_Words;

      Head : Block_Access;
      Tail : Block_Access;
      Used : Natural := Rows_A_Block;
      Rows : Long_Long_Integer := 0;

      --  The first of the blank lines, which only the end may follow.
      Blank : Natural := 0;
   begin
      Text_Input.Open (From, File);
      Read_Header (From, Columns, Count);
      for This_Column of Columns (1 .. Count) loop
         if This_Column.Kind = A_Word then
            Loaded.Given (This_Column.Which) := True;
         end if;
      end loop;

      loop
         Text_Input.Next_Line (From, Found);
         exit when not Found;

         if Text_Input.Trimmed (Text_Input.Line (From)) = "" then
            if Blank = 0 then
               Blank := Text_Input.Line_Number (From);
            end if;
         else
            if Blank /= 0 then
               Text_Input.Refuse
                 (From, Blank, "the line is blank, but rows follow");
            end if;

            Read_Row (From, Columns, Count, Row);
            if Rows > 0 and then Row.Time <= Loaded.Last then
               Text_Input.Refuse
                 (From,
                  Time_Column & ": the row's time is not after that of"
                  & " the row before");
            end if;

            if Used = Rows_A_Block then
               if Head = null then
                  Head := new Block;
                  Tail := Head;
               else
                  Tail.Next := new Block;
                  Tail      := Tail.Next;
               end if;
               Used := 0;
            end if;

            Used := Used + 1;
            Tail.Rows (Row_Index (Used)) := Row;
            Rows        := Rows + 1;
            Loaded.Last := Row.Time;
         end if;
      end loop;

      if Rows = 0 then
         Text_Input.Refuse
           (From,
            (if Blank = 0 then Text_Input.Line_Number (From) else Blank),
            "there is no row after the header");
      end if;

      Loaded.Present := Head;
      Loaded.Index   := Row_Index'First;
      Loaded.Left    := Rows;
      Loaded.Next    := Head.Rows (Row_Index'First).Time;
      Loaded.Any     := True;
   end Load;

   procedure Advance (From : in out Script; Row : out Words) is
   begin
      Row       := From.Present.Rows (From.Index).Value;
      From.Left := From.Left - 1;

      if From.Left = 0 then
         From.Next := Never;
         return;
      elsif From.Index = Row_Index'Last then
         From.Present := From.Present.Next;
         From.Index   := Row_Index'First;
      else
         From.Index := From.Index + 1;
      end if;
      From.Next := From.Present.Rows (From.Index).Time;
   end Advance;

end Host.Scripts;
