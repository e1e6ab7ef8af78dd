--  SPDX-License-Identifier: Apache-2.0

with Checks;             use Checks;
with Expect_Value;
with Expectations;       use Expectations;
with Law_Rig;
with URVOS;              use URVOS;
with URV.Buffers;        use URV.Buffers;
with URV.Card_Blocks;    use URV.Card_Blocks;
with URV.Card_Status;
with URV.Law_Axes;
with URV.Law_Inputs;
with URV.Law_Units;      use URV.Law_Units;
with URV.Laws;           use URV.Laws;
with URV.Laws.Frames;    use URV.Laws.Frames;
with URV.Link_Loss;
with URV.Sensor_Checks;  use URV.Sensor_Checks;
with URV.Signal_Tables;  use URV.Signal_Tables;
with URV.Test_Cards;     use URV.Test_Cards;
with URV.Test_Inputs;    use URV.Test_Inputs;
with URV.Test_Runs;      use URV.Test_Runs;

separate (Law_Suite)
package body Test_Cards_Tests is

   --  The tests, in order.
   procedure Blocks;
   procedure Ranges;
   procedure Slots;
   procedure Pulse_Shapes;
   procedure Sweeps;
   procedure Harmonics;
   procedure Rates;
   procedure Switch_Starts;
   procedure Keeps_Phase;
   procedure Ends_By;
   procedure Limits_Alone;
   procedure Next_Card;
   procedure Broken_Off;
   procedure Disconnect_Cuts;
   procedure Restart_Ends;
   procedure Servo_Words;
   procedure Read_Back;
   procedure Places;
   procedure Place_Remains;
   procedure Not_Followed_Ends;
   procedure Stick_Words_Move;
   procedure In_The_Laws;

   procedure Expect_Answer is new Expect_Value (Answer);
   procedure Expect_Verdict is new Expect_Value (Verdict);

   type Sensor_List is array (Positive range <>) of Sensor_Item;

   Doublet_Card : Card renames Law_Rig.Doublet_Card;

   --  A sweep of the ailerons from 0.5 to 2 Hz in 20 s.
   Sweep_Card : constant Card :=
     (Doublet_Card with delta
        Head     => 2 * 256 + Card_Kind'Pos (Linear_Sweep),
        Surfaces => 3,
        Time     => 2_000,
        First    => 50,
        Last     => 200);

   --  Three axes, six harmonics each, base 0.1 Hz, 10 s.
   Multisine_Card : constant Card :=
     (Doublet_Card with delta
        Head     => 3 * 256 + Card_Kind'Pos (Multisine),
        Surfaces => 63,
        Time     => 1_000,
        First    => 10,
        Last     => 2 * 16 + 6);

   Sticks  : Uplink_Buffer renames Law_Rig.Sticks;
   On_Word : Word renames Law_Rig.On_Word;

   Calm : constant Situation :=
     (Heard     => Sticks,
      Is_New    => True,
      Is_Cut    => False,
      Is_Linked => True,
      Failed    => False,
      Flown     => All_Direct,
      Checks    =>
        (for Item in Sensor_Item =>
           (Is_Valid => True,
            Used     =>
              (case Item is
                  when Altitude => 2_000,
                  when Airspeed => 2_240,
                  when Vertical_Acceleration => Neutral_Value + 250,
                  when others => Neutral_Value),
            others   => <>)));

   Switched : constant Situation :=
     (Calm with delta
        Heard => (Sticks with delta Switch_5 => On_Word));

   Stick_Card : constant Card :=
     (Doublet_Card with delta Surfaces => Stick_Place + 2#01_0101#);

   Command_Card : constant Card :=
     (Doublet_Card with delta Surfaces => Command_Place + 2#11_0101#);

   --  Switch 5 is on, and all laws fly that have a command.
   Holding_All : constant Situation :=
     (Switched with delta
        Flown => (Bank_By_Stick, Hold_Altitude, Hold_Airspeed));

   --  Takes a card with no card running.
   procedure Take (Item : in out Aboard; Source : Card);

   --  Frames of equal facts.
   procedure Fly
     (Item : in out Aboard; Frames : Natural; Sight : Situation := Calm);

   --  The card aboard, and switch 5 on for this number of frames.
   function Started (Source : Card; Frames : Positive := 1) return Aboard;

   procedure Take (Item : in out Aboard; Source : Card) is
   begin
      Expect_Answer
        ("a card", Answer_To (Block_Of (Source), Item, On => True), Taken);
      Item := After_Block (Block_Of (Source), Item, On => True);
   end Take;

   procedure Fly
     (Item : in out Aboard; Frames : Natural; Sight : Situation := Calm) is
   begin
      for Frame in 1 .. Frames loop
         Item.Run := Next (Item.Run, Item.Deck, Sight);
      end loop;
   end Fly;

   function Started (Source : Card; Frames : Positive := 1) return Aboard is
      Item : Aboard := Nothing_Aboard;
   begin
      Fly (Item, 1);
      Take (Item, Source);
      Fly (Item, Frames, Switched);
      return Item;
   end Started;

   procedure Blocks is
      Item  : Aboard := Nothing_Aboard;
      Wrong : Uplink_Buffer;
   begin
      Fly (Item, 1);
      for Source of Card_Deck'
        (Doublet_Card, Sweep_Card, Multisine_Card, others => Doublet_Card)
      loop
         Expect ("whole", Is_Whole (Block_Of (Source)), True);
         Expect ("the same", Card_Of (Block_Of (Source)) = Source, True);
         for Where in Command_Item loop
            for Bit in 0 .. 15 loop
               Wrong := Block_Of (Source);
               Wrong (Where) := Wrong (Where) xor 2 ** Bit;
               Expect_Answer
                 (Where'Image & Bit'Image,
                  Answer_To (Wrong, Item, On => True), Not_Whole);
               Expect
                 ("nothing changes",
                  After_Block (Wrong, Item, On => True) = Item, True);
            end loop;
         end loop;
      end loop;
   end Blocks;

   procedure Ranges is
      Item : Aboard := Nothing_Aboard;

      procedure Expect_Range (What : String; Source : Card; Good : Boolean);

      procedure Expect_Range (What : String; Source : Card; Good : Boolean) is
      begin
         Expect_Answer
           (What, Answer_To (Block_Of (Source), Item, On => True),
            (if Good then Taken else Not_In_Range));
      end Expect_Range;
   begin
      Fly (Item, 1);
      for Value in Field loop
         Expect_Range
           ("amplitude" & Value'Image,
            (Doublet_Card with delta Amplitude => Value),
            Value in 1 .. 800);
         Expect_Range
           ("surfaces" & Value'Image,
            (Doublet_Card with delta Surfaces => Value),
            Value in 1 .. 63
            or else Value in 64 + 1 | 64 + 4 | 64 + 5 | 64 + 16 | 64 + 17
                           | 64 + 20 | 64 + 21
            or else
              (Value in 128 + 1 .. 128 + 63
               and then (Value and 2#00_1010#) = 0));
         Expect_Range
           ("time" & Value'Image,
            (Doublet_Card with delta Time => Value), Value >= 2);
         Expect_Range
           ("first" & Value'Image,
            (Sweep_Card with delta First => Value), Value in 10 .. 1_000);
         Expect_Range
           ("last" & Value'Image,
            (Sweep_Card with delta Last => Value), Value in 10 .. 1_000);
         Expect_Range
           ("frequency of a pulse" & Value'Image,
            (Doublet_Card with delta First => Value), Value = 0);
         Expect_Range
           ("attitude" & Value'Image,
            (Doublet_Card with delta Attitude => Value),
            Value mod 64 > 0 and Value / 64 > 0);
         Expect_Range
           ("slowest" & Value'Image,
            (Doublet_Card with delta Slowest => Value), Value <= 3_200);
      end loop;
      Expect_Range
        ("harmonics beyond 10 Hz",
         (Multisine_Card with delta First => 60), False);
      Expect_Range
        ("a single surface",
         (Multisine_Card with delta Surfaces => 1), False);
      Expect_Range
        ("as a signal of its own",
         (Multisine_Card with delta
            Surfaces => 1, Head => Multisine_Card (Head) + 16), True);
      Expect_Range
        ("five signals",
         (Multisine_Card with delta
            Surfaces => 31, Head => Multisine_Card (Head) + 16), False);
      Expect_Range
        ("slot 9",
         (Doublet_Card with delta Head => 9 * 256 + 2), False);
   end Ranges;

   procedure Slots is
      Item   : Aboard := Nothing_Aboard;
      Choice : constant Card :=
        (Empty_Card with delta
           Head => 3 * 256 + Card_Kind'Pos (Choose));
      Clear  : constant Card := (Empty_Card with delta Head => 256);
   begin
      Expect_Answer
        ("before the first commands",
         Answer_To (Block_Of (Doublet_Card), Item, On => True), Card_Runs);
      Fly (Item, 1);
      Expect_Answer
        ("without laws",
         Answer_To (Block_Of (Doublet_Card), Item, On => False), No_Laws);
      Expect_Answer
        ("an empty slot", Answer_To (Block_Of (Choice), Item, On => True),
         Slot_Empty);
      Take (Item, Doublet_Card);
      Expect_Number ("the only one", Integer (Item.Run.Chosen), 1);
      Take (Item, Multisine_Card);
      Expect_Number ("still", Integer (Item.Run.Chosen), 1);
      Take (Item, Choice);
      Expect_Number ("the other one", Integer (Item.Run.Chosen), 3);
      Take (Item, Clear);
      Expect ("cleared", Item.Deck (1) = Empty_Card, True);
      Fly (Item, 1, Switched);
      Expect_Number ("it runs", Integer (Item.Run.Running), 3);
      Expect_Answer
        ("while one runs",
         Answer_To (Block_Of (Doublet_Card), Item, On => True), Card_Runs);
   end Slots;

   procedure Pulse_Shapes is
      Width : constant := 20;
      Wide  : constant Card :=
        (Doublet_Card with delta
           Head => 256 + Card_Kind'Pos (Three_Two_One_One));
   begin
      Expect_Number ("doublet", Length_Of (Doublet_Card), 2 * Width);
      Expect_Number ("3-2-1-1", Length_Of (Wide), 7 * Width);
      for Frame in 0 .. 2 * Width - 1 loop
         Expect_Number
           ("doublet" & Frame'Image,
            Signal (Doublet_Card, Frame, 0, Left_Elevator),
            (if Frame < Width then 100 else -100));
         Expect_Number
           ("another surface",
            Signal (Doublet_Card, Frame, 0, Left_Aileron), 0);
      end loop;
      for Frame in 0 .. 7 * Width - 1 loop
         Expect_Number
           ("3-2-1-1" & Frame'Image,
            Signal (Wide, Frame, 0, Right_Elevator),
            (case Frame / Width is
                when 0 | 1 | 2 | 5 => 100,
                when others        => -100));
      end loop;
   end Pulse_Shapes;

   procedure Sweeps is
      Octaves : constant Card :=
        (Sweep_Card with delta
           Head => 512 + Card_Kind'Pos (Exponential_Sweep), Last => 128);

      --  Whole cycles that a sweep passes.
      function Cycles (Source : Card) return Natural;

      function Cycles (Source : Card) return Natural is
         Sum : Long_Long_Integer := 0;
      begin
         for Frame in 0 .. Length_Of (Source) - 1 loop
            Sum := Sum + Long_Long_Integer (Frequency_At (Source, Frame));
         end loop;
         return Natural (Sum / Cycle);
      end Cycles;
   begin
      Expect_Number ("begin", Frequency_At (Sweep_Card, 0), 50 * 64);
      Expect_Number ("middle", Frequency_At (Sweep_Card, 500), 125 * 64);
      Expect_Number ("cycles, 1.25 Hz for 20 s", Cycles (Sweep_Card), 24);
      Expect_Number ("begin", Frequency_At (Octaves, 0), 50 * 64);
      Expect_Number ("an octave later", Frequency_At (Octaves, 500), 100 * 64);
      --  20 s * (2 - 0.5) Hz / ln 4.
      Expect_Number ("cycles", Cycles (Octaves), 21);
      for Phase in 0 .. 63 loop
         Expect
           ("sine" & Phase'Image,
            abs (Sine (Phase * (Cycle / 64))
                 - Sines (Phase * 4)) <= 1, True);
      end loop;
      Expect_Number ("quarter", Sine (Cycle / 4), Unit);
   end Sweeps;

   --  The signals of a multisine are orthogonal over a period: none has a
   --  frequency of another.
   procedure Harmonics is
      Length : constant Positive := Length_Of (Multisine_Card);
      Most   : Natural := 0;
      Powers : array (Test_Surface) of Long_Long_Integer := (others => 0);
      Cross  : Long_Long_Integer := 0;
      Phase  : Phase_Number := 0;
      Value  : Increments;
   begin
      for Frame in 0 .. Length - 1 loop
         for Which in Test_Surface loop
            Value (Which) := Signal (Multisine_Card, Frame, Phase, Which);
            Most := Natural'Max (Most, abs Value (Which));
            Powers (Which) :=
              Powers (Which) + Long_Long_Integer (Value (Which)) ** 2;
         end loop;
         Expect_Number
           ("both ailerons", Value (Left_Aileron), Value (Right_Aileron));
         Cross := Cross
           + Long_Long_Integer (Value (Left_Aileron))
           * Long_Long_Integer (Value (Left_Elevator));
         Phase := Next_Phase (Multisine_Card, Frame, Phase);
      end loop;
      Expect ("within the amplitude", Most in 85 .. 100, True);
      Expect
        ("orthogonal", abs Cross * 100 < Powers (Left_Aileron), True);
      Expect
        ("power of each",
         (for all Which in Test_Surface =>
            Powers (Which) > Long_Long_Integer (Length) * 1_500), True);
   end Harmonics;

   procedure Rates is
      Item   : Aboard := Started (Doublet_Card);
      Before : Increments := Nothing_Added;
   begin
      for Frame in 1 .. 60 loop
         for Which in Test_Surface loop
            Expect
              ("step",
               abs (Item.Run.Added (Which) - Before (Which)) <=
                 Rate_Step (Which), True);
            Expect ("amplitude", abs Item.Run.Added (Which) <= 100, True);
         end loop;
         Before := Item.Run.Added;
         Fly (Item, 1, Switched);
      end loop;
      Expect_Verdict ("it ended", Item.Run.Reason, Complete);
      Expect ("all at rest", Item.Run.Added = Nothing_Added, True);
   end Rates;

   procedure Switch_Starts is
      Item : Aboard := Nothing_Aboard;
   begin
      Fly (Item, 10, Switched);
      Fly (Item, 1);
      Take (Item, Doublet_Card);
      Fly (Item, 50);
      Expect ("with the switch off", Is_Running (Item.Run), False);
      Fly (Item, 5, (Switched with delta Is_New => False));
      Expect ("by old commands", Is_Running (Item.Run), False);
      Fly (Item, 1, Switched);
      Expect ("by new ones", Is_Running (Item.Run), True);
      Expect_Number ("from its begin", Item.Run.Frame, 0);
      Fly (Item, 39, Switched);
      Expect ("its last frame", Is_Running (Item.Run), True);
      Fly (Item, 1, Switched);
      Expect ("over", Is_Running (Item.Run), False);
      Fly (Item, 200, Switched);
      Expect ("once only", Is_Running (Item.Run), False);
      Fly (Item, 1);
      Fly (Item, 1, Switched);
      Expect ("again", Is_Running (Item.Run), True);
   end Switch_Starts;

   --  The phase of a running sweep is the sum of its frequencies before.
   procedure Keeps_Phase is
      Item : Aboard       := Started (Sweep_Card, 1);
      Sum  : Phase_Number := 0;
   begin
      for Frame in Frame_Count range 0 .. 400 loop
         Expect_Number ("frame", Item.Run.Frame, Frame);
         Expect_Number
           ("phase" & Frame'Image, Integer (Item.Run.Phase), Integer (Sum));
         Sum := Next_Phase (Sweep_Card, Frame, Sum);
         Fly (Item, 1, Switched);
      end loop;
      Expect ("it turns", Sum > 0, True);
   end Keeps_Phase;

   procedure Ends_By is

      --  The card ends in the first frame of these facts, for this reason, and
      --  does not start with them.
      procedure Expect_End
        (What : String; Sight : Situation; Reason : Verdict);

      procedure Expect_End
        (What : String; Sight : Situation; Reason : Verdict)
      is
         Item : Aboard := Started (Doublet_Card, 10);
         Last : Increments;
      begin
         Expect (What & ": it runs", Is_Running (Item.Run), True);
         Last := Item.Run.Added;
         Fly (Item, 1, Sight);
         Expect (What & ": it ends", Is_Running (Item.Run), False);
         Expect_Verdict (What, Item.Run.Reason, Reason);
         Expect
           (What & ": towards 0",
            abs Item.Run.Added (Left_Elevator) < abs Last (Left_Elevator),
            True);
         Fly (Item, 10, Sight);
         Expect (What & ": at 0", Item.Run.Added = Nothing_Added, True);
         Expect_Number
           (What & ": still chosen", Integer (Item.Run.Chosen), 1);
         Item := Started (Sweep_Card);
         Fly (Item, 1, Switched);
         Expect ("the same facts", Is_Running (Item.Run), True);
      end Expect_End;

      function Without (Item : Sensor_Item) return Situation is
        ((Switched with delta
            Checks => (Switched.Checks with delta
              Item => (Switched.Checks (Item) with delta
                 Is_Valid => False))));

      function With_Word (Item : Sensor_Item; Value : Word) return Situation is
        ((Switched with delta
            Checks => (Switched.Checks with delta
              Item => (Switched.Checks (Item) with delta Used => Value))));

      Middle : constant Word := Neutral_Value;
   begin
      Expect_End ("switch", Calm, Switched_Off);
      Expect_End
        ("link", (Switched with delta Is_Linked => False), Link_Lost);
      Expect_End
        ("disconnect", (Switched with delta Is_Cut => True), Disconnected);
      Expect_End
        ("surface", (Switched with delta Failed => True), Surface_Failed);
      for Stick in Command_Item range Roll .. Yaw loop
         for Value of Word_List'(Middle - 201, Middle + 201) loop
            Expect_End
              (Stick'Image,
               (Switched with delta
                  Heard => (Switched.Heard with delta Stick => Value)),
               Stick_Moved);
         end loop;
      end loop;
      for Item of Sensor_List'
        (Roll_Attitude, Pitch_Attitude, Alpha, Vertical_Acceleration,
         Airspeed, Altitude)
      loop
         Expect_End (Item'Image, Without (Item), Sensor_Invalid);
      end loop;
      Expect_End ("bank", With_Word (Roll_Attitude, Middle + 513),
                  Envelope_Left);
      Expect_End ("bank", With_Word (Roll_Attitude, Middle - 513),
                  Envelope_Left);
      Expect_End ("pitch", With_Word (Pitch_Attitude, Middle + 684),
                  Envelope_Left);
      Expect_End ("alpha", With_Word (Alpha, Middle + 961), Envelope_Left);
      Expect_End
        ("load", With_Word (Vertical_Acceleration, Middle + 501),
         Envelope_Left);
      Expect_End ("slow", With_Word (Airspeed, 55 * 32 - 1), Envelope_Left);
      Expect_End ("fast", With_Word (Airspeed, 100 * 32 + 1), Envelope_Left);
      Expect_End ("low", With_Word (Altitude, 599), Envelope_Left);
   end Ends_By;

   procedure Limits_Alone is
      type Limit_Name is (None, Bank, Pitch, Alpha, Load, Slow, Fast, Low);

      --  A card with one limit.
      function Card_With (Name : Limit_Name) return Card is
        ((Doublet_Card with delta
            Attitude =>
              (if Name = Bank then 45 else 63)
              + 64 * (if Name = Pitch then 30 else 63),
            Airflow  =>
              (if Name = Alpha then 12 else 63)
              + 64 * (if Name = Load then 10 else 63),
            Slowest  => (if Name = Slow then 55 * 32 else 0),
            Fastest  => (if Name = Fast then 100 * 32 else 4_095),
            Lowest   => (if Name = Low then 600 else 0)));

      --  The card needs this sensor.
      function Needs (Name : Limit_Name; Item : Sensor_Item) return Boolean
      is
        (case Name is
            when None        => False,
            when Bank        => Item = Roll_Attitude,
            when Pitch       => Item = Pitch_Attitude,
            when Alpha       => Item = Alpha,
            when Load        => Item = Vertical_Acceleration,
            when Slow | Fast => Item = Airspeed,
            when Low         => Item = Altitude);
   begin
      for Name in Limit_Name loop
         Expect
           (Name'Image & " is in range", Is_Loaded (Card_With (Name)), True);
         for Item in Sensor_Item loop
            Expect_Verdict
              (Name'Image & " without " & Item'Image,
               Judged
                 (Card_With (Name),
                  (Switched with delta
                     Checks => (Switched.Checks with delta
                       Item => (Switched.Checks (Item) with delta
                          Is_Valid => False)))),
               (if Needs (Name, Item) then Sensor_Invalid else Well));
         end loop;
      end loop;
   end Limits_Alone;

   procedure Broken_Off is
      Item : Aboard := Nothing_Aboard;
   begin
      --  A card that a condition has ended is flown again, not the next one.
      Fly (Item, 1);
      Take (Item, Doublet_Card);
      Take (Item, Sweep_Card);
      Fly (Item, 10, Switched);
      Fly (Item, 1);
      Expect_Verdict ("broken off", Item.Run.Reason, Switched_Off);
      Expect_Number ("still chosen", Integer (Item.Run.Chosen), 1);
      Fly (Item, 1, Switched);
      Expect_Number ("it runs again", Integer (Item.Run.Running), 1);
   end Broken_Off;

   procedure Next_Card is
      Item : Aboard := Nothing_Aboard;
   begin
      Fly (Item, 1);
      Take (Item, Doublet_Card);
      Take (Item, Sweep_Card);
      Fly (Item, 41, Switched);
      Expect_Verdict ("the first", Item.Run.Reason, Complete);
      Expect_Number ("the next one", Integer (Item.Run.Chosen), 2);
      Fly (Item, 1);
      Fly (Item, 1_001, Switched);
      Expect_Verdict ("the second", Item.Run.Reason, Complete);
      Expect_Number ("the first again", Integer (Item.Run.Chosen), 1);
   end Next_Card;

   procedure Disconnect_Cuts is
      Item : Aboard := Started (Doublet_Card, 10);
   begin
      Expect ("it moves", Item.Run.Added = Nothing_Added, False);
      Fly (Item, 1, (Switched with delta Is_Cut => True));
      Expect ("at once", Item.Run.Added = Nothing_Added, True);
   end Disconnect_Cuts;

   procedure Restart_Ends is
      Item : Aboard := After_Restart (Started (Doublet_Card, 10));
   begin
      Expect ("no card", Is_Running (Item.Run), False);
      Expect_Verdict ("why", Item.Run.Reason, Restarted);
      Expect ("the cards remain", Item.Deck (1) = Doublet_Card, True);
      Fly (Item, 20, Switched);
      Expect ("a switch left on", Is_Running (Item.Run), False);
      Expect ("all at rest", Item.Run.Added = Nothing_Added, True);
   end Restart_Ends;

   procedure Servo_Words is
      Added  : constant Increments :=
        (Left_Aileron => 100, Right_Rudder => -800, others => 0);
      Before : constant PWM_Buffer :=
        (Left_Aileron => 2_000, Right_Rudder => 700, others => 16#ABC#);
      After  : constant PWM_Buffer := With_Inputs (Before, Added);
   begin
      for Item in PWM_Item loop
         Expect
           (Item'Image, After (Item),
            (case Item is
                when Left_Aileron => 2_100,
                when Right_Rudder => 0,
                when others       => 16#ABC#));
      end loop;
      Expect
        ("nothing", With_Inputs (Before, Nothing_Added) = Before, True);
   end Servo_Words;

   procedure Read_Back is
      use URV.Card_Status;
      Item : constant Aboard := Started (Sweep_Card, 3);
      Got  : Card;
   begin
      Expect ("something", Has_Cards (Item), True);
      Expect ("nothing", Has_Cards (Nothing_Aboard), False);
      for Part in Part_Number loop
         for Place in 0 .. 3 loop
            if Slot_Of (Part) = 2
              and then Integer (Part mod 3) * 4 + Place <=
                         Card_Item'Pos (Card_Item'Last)
            then
               Got (Card_Item'Val (Integer (Part mod 3) * 4 + Place)) :=
                 Word_Of (Item, Part, Place);
            end if;
         end loop;
      end loop;
      Expect ("word for word", Got = Sweep_Card, True);
      Expect
        ("state", State_Word (Item.Run),
         2 + 16 * 2 + 256 * 2 + 4_096 * Verdict'Pos (Well));
   end Read_Back;

   --  The inputs are those at the servos, at their own place only.
   procedure Places is
      Servo   : Aboard := Started (Doublet_Card, 10);
      Stick   : Aboard := Started (Stick_Card, 10);
      Command : Aboard := Nothing_Aboard;
      use URV.Law_Inputs;
   begin
      Fly (Command, 1);
      Take (Command, Command_Card);
      Fly (Command, 10, Holding_All);
      for Frame in 1 .. 60 loop
         Fly (Servo, 1, Switched);
         Fly (Stick, 1, Switched);
         Fly (Command, 1, Holding_All);
         Expect
           ("servo", To_Servos (Servo.Run) = Servo.Run.Added
            and then To_Sticks (Servo.Run) = No_Sticks
            and then To_Commands (Servo.Run) = No_Commands, True);
         Expect
           ("stick", To_Servos (Stick.Run) = Nothing_Added
            and then To_Sticks (Stick.Run) =
              (Servo.Run.Added (Left_Elevator),
               Servo.Run.Added (Left_Elevator),
               Stick.Run.Added (Left_Rudder))
            and then To_Commands (Stick.Run) = No_Commands, True);
         Expect
           ("command", To_Servos (Command.Run) = Nothing_Added
            and then To_Sticks (Command.Run) = No_Sticks
            and then To_Commands (Command.Run) =
              (Servo.Run.Added (Left_Elevator),
               Servo.Run.Added (Left_Elevator),
               Stick.Run.Added (Left_Rudder),
               Stick.Run.Added (Left_Rudder)), True);
      end loop;
      Expect_Verdict ("servo", Servo.Run.Reason, Complete);
      Expect_Verdict ("stick", Stick.Run.Reason, Complete);
      Expect_Verdict ("command", Command.Run.Reason, Complete);
   end Places;

   --  A card of another place waits until the inputs are back.
   procedure Place_Remains is
      Item : Aboard := Nothing_Aboard;
   begin
      Fly (Item, 1);
      Take (Item, (Doublet_Card with delta Amplitude => 800));
      Take (Item, (Stick_Card with delta Head => 512 + 2));
      Fly (Item, 10, Switched);
      Fly (Item, 1);
      Item.Run.Chosen := 2;
      Fly (Item, 1, Switched);
      Expect_Verdict ("too early", Item.Run.Reason, Inputs_Remain);
      Expect ("no card", Is_Running (Item.Run), False);
      Expect ("at its place", Item.Run.Place = At_Servo, True);
      Expect ("still there", Item.Run.Added = Nothing_Added, False);
      Fly (Item, 10);
      Fly (Item, 1, Switched);
      Expect ("it runs", Is_Running (Item.Run), True);
      Expect ("at its place", Item.Run.Place = At_Stick, True);
   end Place_Remains;

   procedure Not_Followed_Ends is

      --  A card with these inputs does not start with these modes, and ends in
      --  their first frame.
      procedure Expect_No_Run (Bits : Word; Before, After : Modes);

      procedure Expect_No_Run (Bits : Word; Before, After : Modes) is
         Item   : Aboard := Nothing_Aboard;
         Source : constant Card :=
           (Doublet_Card with delta Surfaces => Bits);
      begin
         Fly (Item, 1);
         Take (Item, Source);
         Fly (Item, 1, (Switched with delta Flown => After));
         Expect_Verdict (Bits'Image & " starts", Item.Run.Reason,
                         Not_Followed);
         Fly (Item, 1);
         Fly (Item, 10, (Switched with delta Flown => Before));
         Expect (Bits'Image & " runs", Is_Running (Item.Run), True);
         Fly (Item, 1, (Switched with delta Flown => After));
         Expect (Bits'Image & " ends", Is_Running (Item.Run), False);
         Expect_Verdict (Bits'Image, Item.Run.Reason, Not_Followed);
         Fly (Item, 1, (Switched with delta Flown => After));
         Expect (Bits'Image & ": at 0", Item.Run.Added = Nothing_Added, True);
      end Expect_No_Run;

      Held : constant Modes := Holding_All.Flown;
   begin
      Expect_No_Run
        (Stick_Place + 1, All_Direct, (Wings_Level, Direct, Direct));
      Expect_No_Run
        (Stick_Place + 4, All_Direct, (Direct, Hold_Altitude, Direct));
      Expect_No_Run (Command_Place + 1, Held, All_Direct);
      Expect_No_Run (Command_Place + 1, Held, (Held with delta
        Lateral => Damping));
      Expect_No_Run (Command_Place + 4, Held, (Held with delta
        Vertical => Damping));
      Expect_No_Run (Command_Place + 16, Held, (Held with delta
        Vertical => Pitch_By_Stick));
      Expect_No_Run (Command_Place + 32, Held, (Held with delta
        Power => Direct));
   end Not_Followed_Ends;

   procedure Stick_Words_Move is
      use URV.Law_Inputs;
      Given : constant Uplink_Buffer :=
        (Sticks with delta
           Roll => 2_000, Pitch => 100, Yaw => 16#FFFF#, Throttle => 77);
      Moved : constant Uplink_Buffer :=
        With_Sticks (Given, (Roll => 50, Pitch => -200, Yaw => 0));
   begin
      for Name in Command_Item loop
         Expect_Number
           (Name'Image, Integer (Moved (Name)),
            (case Name is
                when Roll   => 2_050,
                when Pitch  => 0,
                when others => Integer (Given (Name))));
      end loop;
   end Stick_Words_Move;

   --  Each input reaches its law, and nothing else.
   procedure In_The_Laws is
      use URV.Law_Inputs;

      Commands : constant Uplink_Buffer :=
        (Sticks with delta
           Switch_2 => On_Word, Switch_3 => On_Word, Throttle => 2_000);
      Levels   : constant Downlink_Buffer :=
        (for Item in Downlink_Item =>
           (if Item = Altitude then 2_000
            elsif Item = Airspeed then 70 * 32
            elsif Item = Error_Status then 0
            else Neutral_Value));
      By       : constant URV.Link_Loss.Times := Laws_Off.By;

      --  The memory after these frames, with these inputs after the first 100.
      function Flown
        (Sticks : Stick_Inputs := No_Sticks;
         Extra  : Command_Inputs := No_Commands;
         Frames : Positive := 200) return Memory;

      function Flown
        (Sticks : Stick_Inputs := No_Sticks;
         Extra  : Command_Inputs := No_Commands;
         Frames : Positive := 200) return Memory
      is
         Item : Memory := At_Start;
         Seen : Observation;
      begin
         for Frame in 1 .. Frames loop
            Observe (Item, Commands, Levels, By, Seen);
            Steer
              (Item, Commands, Seen,
               (if Frame > 100 then Sticks else No_Sticks),
               (if Frame > 100 then Extra else No_Commands));
         end loop;
         return Item;
      end Flown;

      Calm : constant Memory := Flown;
      Item : Memory;
   begin
      Expect ("the laws fly", Calm.Flown =
                (Bank_By_Stick, Hold_Altitude, Hold_Airspeed), True);
      Item := Flown (Sticks => (Roll => 400, others => 0));
      Expect_Number
        ("bank by stick", Item.Bank_Wanted,
         Calm.Bank_Wanted + URV.Law_Axes.Stick_Bank (400));
      Item := Flown (Extra => (Bank => 400, others => 0));
      Expect_Number
        ("bank command", Item.Bank_Wanted, Calm.Bank_Wanted + 8_000);
      Expect_Number ("no pitch", Item.Pitch_Wanted, Calm.Pitch_Wanted);
      Item := Flown (Extra => (Pitch => 100, others => 0));
      Expect_Number
        ("pitch command", Item.Pitch_Wanted, Calm.Pitch_Wanted + 2_000);
      Item := Flown (Extra => (Altitude => 20, others => 0));
      Expect
        ("altitude command", Item.Pitch_Wanted > Calm.Pitch_Wanted, True);
      Expect_Number ("is kept", Item.Height_Held, Calm.Height_Held);
      Item := Flown (Extra => (Airspeed => 64, others => 0));
      Expect
        ("airspeed command", Item.Last.Throttle > Calm.Last.Throttle, True);
      Expect_Number ("is kept", Item.Speed_Held, Calm.Speed_Held);

      --  In the first frames before the integrators have moved.
      Item := Flown (Extra => (Airspeed => 64, others => 0), Frames => 103);
      Expect
        ("throttle at once",
         Item.Last.Throttle > Flown (Frames => 103).Last.Throttle + 20, True);
      Item := Flown (Extra => (Altitude => 80, others => 0), Frames => 103);
      Expect
        ("throttle for the climb",
         Item.Last.Throttle > Flown (Frames => 103).Last.Throttle, True);
      Item := Flown (Sticks => (Yaw => 300, others => 0));
      Expect ("rudder", Item.Last.Yaw > Calm.Last.Yaw + 250, True);
   end In_The_Laws;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "FTI-1 a block with one wrong bit is no card", Blocks'Access);
      Add (Suite, "FTI-1 values of a card", Ranges'Access);
      Add (Suite, "FTI-2 slots are taken, cleared, chosen", Slots'Access);
      Add (Suite, "FTI-3 shapes of the pulses", Pulse_Shapes'Access);
      Add (Suite, "FTI-3 frequencies of the sweeps", Sweeps'Access);
      Add
        (Suite, "FTI-3 a running sweep has the phase of its frame",
         Keeps_Phase'Access);
      Add (Suite, "FTI-3 harmonics are disjoint", Harmonics'Access);
      Add (Suite, "FTI-3 an input has its rate and amplitude", Rates'Access);
      Add (Suite, "FTI-4 only switch 5 starts a card", Switch_Starts'Access);
      Add (Suite, "FTI-5 each reason ends a card", Ends_By'Access);
      Add (Suite, "FTI-5 each limit needs its own sensor alone",
           Limits_Alone'Access);
      Add (Suite, "FTI-4 the next card is chosen", Next_Card'Access);
      Add (Suite, "FTI-4 a card that was broken off stays chosen",
           Broken_Off'Access);
      Add
        (Suite, "FTI-5 a disconnect takes inputs away at once",
         Disconnect_Cuts'Access);
      Add (Suite, "FTI-5 a warm start ends a card", Restart_Ends'Access);
      Add
        (Suite, "FTI-6 D-85 only the surfaces' words get inputs",
         Servo_Words'Access);
      Add
        (Suite, "FTI-2 a card is read back word for word", Read_Back'Access);
      Add
        (Suite, "FTI-3 inputs are added at the card's place", Places'Access);
      Add
        (Suite, "FTI-5 D-100 inputs return where they were added",
         Place_Remains'Access);
      Add
        (Suite, "FTI-5 D-100 a card ends when nothing follows its input",
         Not_Followed_Ends'Access);
      Add
        (Suite, "FTI-6 D-100 only the sticks' words get inputs",
         Stick_Words_Move'Access);
      Add
        (Suite, "FTI-3 D-100 each input reaches its law", In_The_Laws'Access);
   end Add_To;

end Test_Cards_Tests;
