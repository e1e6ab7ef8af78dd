--  SPDX-License-Identifier: Apache-2.0

with Host.Complaints;    use Host.Complaints;
with Host.Orders;
with Host.Text_Input;    use Host.Text_Input;
with Host.Text_Numbers;  use Host.Text_Numbers;
with URV.Configurations;

package body Host.Ground_Orders is

   use type Number;

   subtype Field is URV.Configurations.Field;
   subtype Serial_Number is URV.Configurations.Serial_Number;

   package Lines renames Host.Orders;

   Longest_Time : constant Number := 10_000_000_000 * 1_000;

   --  Times of a configuration are in tenths of a second.
   Milliseconds_A_Tenth : constant := 100;

   --  The words of a block after its kind.
   subtype Free_Item is Command_Item range Pitch .. Switch_8;

   function Image (Kind : Order_Kind) return String is
     (case Kind is
         when Configure => "configure",
         when Block     => "block");

   function Form_Of (Kind : Order_Kind) return String is
     ("TIME_MS "
      & (case Kind is
            when Configure => "configure TABLE ORBIT_MS END_MS",
            when Block     => "block KIND [WORD ...]"));

   procedure Read_Time
     (From : Reader; Word : String; Value : out Microseconds);

   --  Reads a number from 0 to Most.
   procedure Read_Field
     (From       : Reader;
      Field_Name : String;
      Word       : String;
      Most       : Number;
      Value      : out Number);

   procedure Read_Configuration
     (From   : Reader;
      Line   : String;
      Serial : Serial_Number;
      Block  : out Uplink_Buffer);

   procedure Read_Block
     (From : Reader; Line : String; Block : out Uplink_Buffer);

   procedure Read_Time
     (From : Reader; Word : String; Value : out Microseconds)
   is
      Amount   : Number;
      Is_Valid : Boolean;
   begin
      Read_Decimal (Word, 3, Amount, Is_Valid);
      if not Is_Valid or else Amount > Longest_Time then
         Refuse
           (From,
            "TIME_MS: " & Quoted (Word) & " is not a time from 0 to"
            & Number'Image (Longest_Time / 1_000)
            & " ms with at most three decimals");
      end if;
      Value := Microseconds (Amount);
   end Read_Time;

   procedure Read_Field
     (From       : Reader;
      Field_Name : String;
      Word       : String;
      Most       : Number;
      Value      : out Number)
   is
      Is_Valid : Boolean;
   begin
      Read_Either (Word, Value, Is_Valid);
      if not Is_Valid or else Value > Most then
         Refuse
           (From,
            Field_Name & ": " & Quoted (Word)
            & " is not a whole number from 0 to"
            & Number'Image (Most));
      end if;
   end Read_Field;

   procedure Read_Configuration
     (From   : Reader;
      Line   : String;
      Serial : Serial_Number;
      Block  : out Uplink_Buffer)
   is
      Table, Orbit, Finish : Number;
      Most : constant Number :=
        Number (Field'Last) * Milliseconds_A_Tenth;

      procedure Read_Tenths
        (Field_Name : String;
         Word       : String;
         Value      : out Number);

      procedure Read_Tenths
        (Field_Name : String;
         Word       : String;
         Value      : out Number) is
      begin
         Read_Field (From, Field_Name, Word, Most, Value);
         if Value mod Milliseconds_A_Tenth /= 0 then
            Refuse
              (From,
               Field_Name & ": " & Quoted (Word) & " is not a multiple of"
               & Integer'Image (Milliseconds_A_Tenth) & " ms");
         end if;
         Value := Value / Milliseconds_A_Tenth;
      end Read_Tenths;
   begin
      if Lines.Word_Count (Line) /= 5 then
         Refuse (From, "the form is " & Quoted (Form_Of (Configure)));
      end if;
      Read_Field
        (From, "TABLE", Lines.Word (Line, 3),
         Number (Field'Last), Table);
      Read_Tenths ("ORBIT_MS", Lines.Word (Line, 4), Orbit);
      Read_Tenths ("END_MS", Lines.Word (Line, 5), Finish);
      Block := URV.Configurations.Block_Of
        ((URV.Configurations.Serial     => Serial,
          URV.Configurations.Gains      => Field (Table),
          URV.Configurations.Orbit_From => Field (Orbit),
          URV.Configurations.End_From   => Field (Finish)));
   end Read_Configuration;

   procedure Read_Block
     (From : Reader; Line : String; Block : out Uplink_Buffer)
   is
      Count    : constant Natural := Lines.Word_Count (Line);
      Kind     : Number;
      Value    : Number;
      Is_Valid : Boolean;
   begin
      if Count not in 3 .. 3 + Free_Item'Pos (Free_Item'Last) then
         Refuse
           (From,
            "the form is " & Quoted (Form_Of (Ground_Orders.Block))
            & ", with" & Integer'Image (Free_Item'Pos (Free_Item'Last))
            & " words at most");
      end if;
      Read_Hexadecimal (Lines.Word (Line, 3), Kind, Is_Valid);
      if not Is_Valid or else Kind > Number (Field'Last) then
         Refuse
           (From,
            "KIND: " & Quoted (Lines.Word (Line, 3))
            & " is not hexadecimal from 0 to fff");
      end if;
      Block :=
        (Roll         => Word (Kind),
         Free_Item    => 0,
         Error_Status => Other_Kind);
      for Which in 4 .. Count loop
         Read_Field
           (From, "WORD", Lines.Word (Line, Which), Number (Field'Last),
            Value);
         Block (Uplink_Item'Val (Which - 3)) := Word (Value);
      end loop;
   end Read_Block;

   procedure Load (Loaded : in out Script; File : String) is

      Configurations_Read : Natural := 0;

      procedure Read (From : Reader; Line : String);

      procedure Read (From : Reader; Line : String) is
         Made : Order;
         Kind : constant String := Lines.Word (Line, 2);
      begin
         Read_Time (From, Lines.Word (Line, 1), Made.Time);
         if not Loaded.Orders.Is_Empty
           and then Made.Time <
                      Loaded.Orders.Last_Element.Time + Least_Between
         then
            Refuse
              (From,
               "TIME_MS: an order comes 100 ms after the one before, or"
               & " later");
         end if;
         if Kind = Image (Configure) then
            Configurations_Read := Configurations_Read + 1;
            if Configurations_Read > Natural (Serial_Number'Last) then
               Refuse
                 (From,
                  "there are more than" & Serial_Number'Last'Image
                  & " configurations");
            end if;
            Read_Configuration
              (From, Line, Serial_Number (Configurations_Read), Made.Block);
         elsif Kind = Image (Block) then
            Read_Block (From, Line, Made.Block);
         else
            Refuse
              (From,
               "unknown order " & Quoted (Kind) & "; there are "
               & Image (Configure) & ", " & Image (Block));
         end if;
         Loaded.Orders.Append (Made);
      end Read;

      procedure Read_File is new Host.Orders.Read_All (Read);
   begin
      Read_File (File);
   end Load;

   procedure Advance (From : in out Script; Block : out Uplink_Buffer) is
   begin
      Block := From.Orders (From.Next).Block;
      From.Next := From.Next + 1;
   end Advance;

end Host.Ground_Orders;
