--  SPDX-License-Identifier: Apache-2.0

with Ada.Characters.Handling; use Ada.Characters.Handling;

with Host.Names;        use Host.Names;
with Host.Text_Numbers; use Host.Text_Numbers;
with Host.Text_Output;  use Host.Text_Output;
with Host.Truth_Columns;
with URV.Law_Status;    use URV.Law_Status;
with URV.Test_Cards;    use URV.Test_Cards;
with URV.Test_Inputs;   use URV.Test_Inputs;

package body Sim.Flight_Record is

   --  A group of columns: all values of one array, words or counts.
   generic
      type Item is (<>);
      type Value is (<>);
      type Values is array (Item) of Value;
      with function Name (Which : Item) return String is <>;
   package Columns is
      procedure Put_Names (To : in out Writer; Group : String);
      procedure Put_Values (To : in out Writer; This : Values);
   end Columns;

   package body Columns is

      procedure Put_Names (To : in out Writer; Group : String) is
      begin
         for Which in Item loop
            Put (To, "," & Group & "." & Name (Which));
         end loop;
      end Put_Names;

      procedure Put_Values (To : in out Writer; This : Values) is
      begin
         for Each of This loop
            Put (To, ',');
            Put (To, Number (Value'Pos (Each)));
         end loop;
      end Put_Values;

   end Columns;

   package Console_Columns is new Columns
     (Command_Item, Word, Console_Words);
   package Uplink_Columns is new Columns
     (Uplink_Item, Word, Uplink_Buffer);
   package PWM_Columns is new Columns
     (PWM_Item, Word, PWM_Buffer);
   package Downlink_Columns is new Columns
     (Downlink_Item, Word, Downlink_Buffer);
   package Frame_Columns is new Columns
     (Frame_Item, Word, Frame_Words);
   package Link_Columns is new Columns
     (Link_Item, Count, Link_Counts);

   function Name (Which : Test_Surface) return String is
     (To_Lower (Test_Surface'Image (Which)));

   --  Inputs as the words that a centred servo has with them.
   type Added_Words is array (Test_Surface) of Word;
   package Added_Columns is new Columns
     (Test_Surface, Word, Added_Words);

   function Words_Of (Added : Increments) return Added_Words is
     (for Which in Test_Surface =>
        Word (Integer (Neutral_Value) + Added (Which)));

   --  The words of a report of the cards after the state, by their places.
   subtype Part_Item is URV.Card_Status.Report_Item
     range URV.Card_Status.Frame .. URV.Card_Status.Word_4;
   type Parts is array (Part_Item) of Word;

   function Name (Which : Part_Item) return String is
     (Character'Val (Character'Pos ('1') + Part_Item'Pos (Which)) & "");

   package Card_Columns is new Columns (Part_Item, Word, Parts);

   --  The state of the test cards.
   procedure Put_Run (To : in out Writer; This : URV.Test_Runs.Run);

   procedure Put_Run (To : in out Writer; This : URV.Test_Runs.Run) is
   begin
      Put (To, ',');
      Put (To, Number (This.Running));
      Put (To, ',');
      Put (To, Number (This.Frame));
      Put (To, ',');
      Put (To, Number (This.Last_Run));
      Put (To, ',');
      Put (To, Number (URV.Test_Runs.Verdict'Pos (This.Reason)));
   end Put_Run;

   --  Writes a time in milliseconds.
   procedure Put_Time (To : in out Writer; Time : Microseconds);

   procedure Put_Time (To : in out Writer; Time : Microseconds) is
      Rest : constant Microseconds := Time mod 1_000;
   begin
      Put (To, Number (Time / 1_000));
      if Rest /= 0 then
         Put (To, '.');
         Put (To, Number (Rest / 100));
         Put (To, Number (Rest / 10 mod 10));
         Put (To, Number (Rest mod 10));
      end if;
   end Put_Time;

   --  The columns of the laws except the last.
   procedure Put_Laws (To : in out Writer; Laws : Report);

   procedure Put_Laws (To : in out Writer; Laws : Report) is
      Rest : Word := Laws (Active);
   begin
      for Part in 1 .. 4 loop
         Put (To, ',');
         Put (To, Number (Rest mod 16));
         Rest := Rest / 16;
      end loop;
      for Which in Invalid_Low .. Silent loop
         Put (To, ',');
         Put (To, Number (Laws (Which)));
      end loop;
   end Put_Laws;

   procedure Write_Header
     (To         : in out Writer;
      Has_Truth  : Boolean;
      Has_Laws   : Boolean;
      Has_Orders : Boolean;
      Has_Cards  : Boolean) is
   begin
      Put (To, "frame,time_ms");
      Console_Columns.Put_Names (To, "console");
      Uplink_Columns.Put_Names (To, "gsc.uplink");
      Uplink_Columns.Put_Names (To, "mcs.uplink");
      PWM_Columns.Put_Names (To, "pwm");
      Downlink_Columns.Put_Names (To, "mcs.downlink");
      Downlink_Columns.Put_Names (To, "gsc.downlink");
      Link_Columns.Put_Names (To, "link");
      if Has_Truth then
         Truth_Columns.Put_Names (To);
      end if;
      if Has_Laws then
         Put (To, ",laws.lateral,laws.vertical,laws.power,laws.link"
              & ",laws.invalid_low,laws.invalid_high,laws.silent"
              & ",laws.told,laws.failed,laws.told_failed");
         if Has_Orders then
            Put (To, ",laws.configuration,laws.told_configuration");
         end if;
         if Has_Cards then
            Put (To, ",laws.card,laws.card_frame,laws.card_last"
                 & ",laws.card_ended,laws.told_card");
            Added_Columns.Put_Names (To, "laws.added");
            Card_Columns.Put_Names (To, "laws.told_card");
            Put (To, ",laws.card_place");
         end if;
      end if;
      Frame_Columns.Put_Names (To, "mcs.frame");
      Frame_Columns.Put_Names (To, "gsc.frame");
      New_Line (To);
   end Write_Header;

   procedure Write_Row (To : in out Writer; This : Row) is
   begin
      Put (To, Number (This.Frame));
      Put (To, ',');
      Put_Time (To, This.Time);
      Console_Columns.Put_Values (To, This.Console);
      Uplink_Columns.Put_Values (To, This.GSC_Uplink);
      Uplink_Columns.Put_Values (To, This.MCS_Uplink);
      PWM_Columns.Put_Values (To, This.PWM);
      Downlink_Columns.Put_Values (To, This.MCS_Downlink);
      Downlink_Columns.Put_Values (To, This.GSC_Downlink);
      Link_Columns.Put_Values (To, This.Link);
      if This.Has_Truth then
         Truth_Columns.Put_Values (To, This.Truth);
      end if;
      if This.Has_Laws then
         Put_Laws (To, This.Laws);
         Put (To, ',');
         Put (To, Number (This.Reported_Laws (Active)));
         Put (To, ',');
         Put (To, Number (This.Laws (Failed)));
         Put (To, ',');
         Put (To, Number (This.Reported_Laws (Failed)));
         if This.Has_Orders then
            Put (To, ',');
            Put (To, Number (This.Laws (Configuration)));
            Put (To, ',');
            Put (To, Number (This.Reported_Laws (Configuration)));
         end if;
         if This.Has_Cards then
            Put_Run (To, This.Cards.Run);
            Put (To, ',');
            Put (To, Number (This.Cards_Told (URV.Card_Status.State)));
            Added_Columns.Put_Values (To, Words_Of (This.Cards.Run.Added));
            Card_Columns.Put_Values
              (To, Parts (This.Cards_Told (Part_Item)));
            Put (To, ',');
            Put
              (To,
               Number (URV.Test_Cards.Input_Place'Pos (This.Cards.Run.Place)));
         end if;
      end if;
      Frame_Columns.Put_Values (To, This.MCS_Frame);
      Frame_Columns.Put_Values (To, This.GSC_Frame);
      New_Line (To);
   end Write_Row;

end Sim.Flight_Record;
