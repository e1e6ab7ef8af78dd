--  SPDX-License-Identifier: Apache-2.0

with Checks;            use Checks;
with Expect_Value;
with Expectations;      use Expectations;
with Law_Rig;
with URVOS;             use URVOS;
with URV.Buffers;       use URV.Buffers;
with URV.Configurations;
with URV.CORE_Memory;   use URV.CORE_Memory;
with URV.Law_Axes;
with URV.Laws;          use URV.Laws;
with URV.Laws.Frames;   use URV.Laws.Frames;
with URV.Law_Gains;
with URV.Law_Status;    use URV.Law_Status;
with URV.Link_Loss;     use URV.Link_Loss;
with URV.Sensor_Checks; use URV.Sensor_Checks;

separate (Law_Suite)
package body Laws_Tests is

   --  The tests, in order.
   procedure All_Off;
   procedure Disconnected;
   procedure Letting_Go;
   procedure Signs;
   procedure Let_Go_Of_The_Altitude;
   procedure Falling_Back;
   procedure Rudder_Falls_Back;
   procedure Rudder_In_A_Turn;
   procedure Power_Begins;
   procedure Range_Check;
   procedure Rate_Check;
   procedure No_Rule;
   procedure Each_Rule;
   procedure Stuck_Check;
   procedure Stale_Scans;
   procedure Times_Of_Loss;
   procedure Way_Back;
   procedure Proportions;
   procedure Way_Out;
   procedure On_The_Ground;
   procedure In_The_Air;
   procedure Glide_By_Attitude;
   procedure What_Is_Held;
   procedure Told;
   procedure Integrators_Follow;
   procedure Integrators_Recover;
   procedure Large_Errors_Count;

   type Integer_List is array (Positive range <>) of Integer;

   Level   : Downlink_Buffer renames Law_Rig.Level;
   Sticks  : Uplink_Buffer renames Law_Rig.Sticks;
   On_Word : Word renames Law_Rig.On_Word;

   Usual : constant Times := (others => <>);

   procedure Expect_State is new Expect_Value (Link_State);

   --  Flies this number of equal frames.
   procedure Fly
     (Item     : in out URV.Laws.Memory;
      Frames   : Natural;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer := Level);

   --  The ground's report of it.
   function Status_Of (Item : URV.Laws.Memory) return Report is
     (Report_Of
        (Item, 0, URV.Configurations.Nothing_Set));

   --  After more than one second of good scans.
   function Warm
     (Commands : Uplink_Buffer := Sticks;
      Sensors  : Downlink_Buffer := Level) return URV.Laws.Memory;

   --  The same commands with a switch on, or marked as old

   function With_On
     (Which : Switch_Item; Commands : Uplink_Buffer := Sticks)
      return Uplink_Buffer
   is ((Commands with delta Which => On_Word));

   function Old (Commands : Uplink_Buffer := Sticks) return Uplink_Buffer is
     ((Commands with delta Error_Status => Stale_Data));

   --  The same scan with another word.
   function Measuring
     (Which : Sensor_Item; Value : Word; Scan : Downlink_Buffer := Level)
      return Downlink_Buffer
   is ((Scan with delta Which => Value));

   procedure Fly
     (Item     : in out URV.Laws.Memory;
      Frames   : Natural;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer := Level) is
   begin
      for Frame in 1 .. Frames loop
         Item := Next (Item, Commands, Sensors, Usual);
      end loop;
   end Fly;

   function Warm
     (Commands : Uplink_Buffer := Sticks;
      Sensors  : Downlink_Buffer := Level) return URV.Laws.Memory is
   begin
      return Item : URV.Laws.Memory do
         Fly (Item, URV.Law_Gains.Good_Scans + 2, Commands, Sensors);
      end return;
   end Warm;

   procedure All_Off is
      Item     : URV.Laws.Memory;
      Commands : Uplink_Buffer := Sticks;
      Sensors  : Downlink_Buffer := Level;
   begin
      for Frame in 1 .. 200 loop
         Commands (Roll) := Word (Frame * 97 mod 6_000);
         Commands (Throttle) := Word (Frame * 331 mod 70_000 mod 4_096);
         Commands (Switch_8) := Word (Frame mod 2) * On_Word;
         Commands (Error_Status) := Word (Frame / 9 mod 2);
         Sensors (Roll_Attitude) := Word (Frame * 771 mod 5_000);
         Item := Next (Item, Commands, Sensors, Usual);
         Expect ("the commands as they are",
                 Output (Item, Commands) = Commands, True);
      end loop;
   end All_Off;

   procedure Disconnected is
      Rolling : constant Downlink_Buffer :=
        Measuring (Roll_Attitude, 2_600, Measuring (Roll_Rate, 3_000));
      Item    : URV.Laws.Memory := Warm (Sticks, Rolling);
      Stick   : constant Uplink_Buffer :=
        (With_On (Switch_7, With_On (Switch_3)) with delta
           Roll => 300, Pitch => 4_000, Yaw => 9, Throttle => 3);
   begin
      Fly (Item, 30, With_On (Switch_3), Rolling);
      Expect ("a law flies", Item.Flown.Lateral = Bank_By_Stick, True);
      Fly (Item, 1, Stick, Rolling);
      Expect ("the sticks in one frame", Output (Item, Stick) = Stick, True);

      --  The link was lost for a long time; the laws still hold.
      Item := Warm (Sticks, Rolling);
      Fly (Item, 7_000, Old, Rolling);
      Expect_State ("after long", Item.Link.State, Terminated);
      Fly (Item, 1, Stick, Rolling);
      Expect ("the sticks again", Output (Item, Stick) = Stick, True);
      Expect_State ("but not yet ordered out", Item.Link.State, Terminated);

      --  In a gap the last switches remain in force.
      Item := Warm (With_On (Switch_7, With_On (Switch_4)), Rolling);
      Fly (Item, 1, Old, Rolling);
      Expect_State ("a gap", Item.Link.State, Linked);
      Expect ("still direct", Item.Flown = All_Direct, True);
   end Disconnected;

   procedure Letting_Go is
      Banked : constant Downlink_Buffer := Measuring (Roll_Attitude, 2_500);
      Item   : URV.Laws.Memory := Warm (Sticks, Banked);
      Stick  : Uplink_Buffer   := Sticks;
      Before : Integer;
   begin
      Fly (Item, 60, With_On (Switch_2), Banked);
      Expect ("ailerons against the bank", Item.Last.Roll < -300, True);
      Before := Item.Last.Roll;
      Fly (Item, 1, Sticks, Banked);
      Expect_Number
        ("one step towards the stick", Item.Last.Roll,
         Before + URV.Law_Gains.Roll_Step);
      Expect ("not yet the stick's", Item.Is_Stick (Roll_Axis), False);
      Fly (Item, 20, Sticks, Banked);
      Expect ("all direct again",
              Output (Item, Sticks) = Sticks, True);

      --  The stick moves in every frame.
      Item := Warm (Sticks, Banked);
      Fly (Item, 60, With_On (Switch_2), Banked);
      for Frame in 1 .. 20 loop
         Stick (Roll) := Stick (Roll) + 1;
         Fly (Item, 1, Stick, Banked);
      end loop;
      Expect ("the moving stick's", Item.Is_Stick (Roll_Axis), True);
      Stick (Roll) := Stick (Roll) + 500;
      Fly (Item, 1, Stick, Banked);
      Expect ("a jump at once", Output (Item, Stick) = Stick, True);
   end Letting_Go;

   procedure Signs is

      --  Expects the output to act against the sensor's deviation after some
      --  frames.
      procedure Expect_Against
        (What    : String;
         Switch  : Switch_Item;
         Sensor  : Sensor_Item;
         Value   : Word;
         Which   : Uplink_Item;
         Is_More : Boolean);

      procedure Expect_Against
        (What    : String;
         Switch  : Switch_Item;
         Sensor  : Sensor_Item;
         Value   : Word;
         Which   : Uplink_Item;
         Is_More : Boolean)
      is
         Commands : constant Uplink_Buffer := With_On (Switch);
         Rest     : URV.Laws.Memory := Warm (Commands);
         Moved    : URV.Laws.Memory := Warm (Commands);
      begin
         Fly (Rest, 30, Commands);
         Fly (Moved, 30, Commands, Measuring (Sensor, Value));
         Expect
           (What,
            (if Is_More
             then Output (Moved, Commands) (Which) >
                    Output (Rest, Commands) (Which)
             else Output (Moved, Commands) (Which) <
                    Output (Rest, Commands) (Which)),
            True);
      end Expect_Against;

   begin
      Expect_Against ("roll rate, damped", Switch_1, Roll_Rate, 2_148, Roll,
                      Is_More => False);
      Expect_Against ("pitch rate, damped", Switch_1, Pitch_Rate, 2_148,
                      Pitch, Is_More => False);
      Expect_Against ("yaw rate, damped", Switch_1, Yaw_Rate, 2_148, Yaw,
                      Is_More => False);
      Expect_Against ("bank, held", Switch_2, Roll_Attitude, 2_100, Roll,
                      Is_More => False);
      Expect_Against ("nose, held", Switch_2, Pitch_Attitude, 2_100, Pitch,
                      Is_More => False);
      Expect_Against ("wings, level", Switch_4, Roll_Attitude, 2_000, Roll,
                      Is_More => True);
      Expect_Against ("above the altitude", Switch_3, Altitude, 2_040, Pitch,
                      Is_More => False);
      Expect_Against ("too slow", Switch_3, Airspeed, 2_200, Throttle,
                      Is_More => True);
   end Signs;

   procedure Let_Go_Of_The_Altitude is
      Item  : URV.Laws.Memory := Warm (With_On (Switch_3));
      Stick : Uplink_Buffer := With_On (Switch_3);
   begin
      for Value of Word_List'(1_000, 3_000) loop
         Fly (Item, 1, With_On (Switch_3));
         Expect ("held", Item.Flown.Vertical = Hold_Altitude, True);
         Stick (Pitch) := Value;
         Fly (Item, 1, Stick);
         Expect ("the stick at" & Value'Image,
                 Item.Flown =
                   (Bank_By_Stick, Pitch_By_Stick, Hold_Airspeed), True);
      end loop;
   end Let_Go_Of_The_Altitude;

   procedure Falling_Back is
      Commands : constant Uplink_Buffer := With_On (Switch_3);
      Item     : URV.Laws.Memory := Warm (Commands);
   begin
      Expect ("altitude is held", Item.Flown =
                (Bank_By_Stick, Hold_Altitude, Hold_Airspeed), True);
      Fly (Item, 3, Commands, Measuring (Altitude, 9_999));
      Expect ("without it attitude", Item.Flown =
                (Bank_By_Stick, Pitch_By_Stick, Hold_Airspeed), True);
      Item := Warm (Commands);
      Fly (Item, 3, Commands, Measuring (Airspeed, 9_999));
      Expect ("without a speed the lever", Item.Flown =
                (Bank_By_Stick, Hold_Altitude, Direct), True);
      Item := Warm (Commands);
      Fly (Item, 3, Commands, Measuring (Roll_Attitude, 0));
      Expect ("without bank damping of roll", Item.Flown =
                (Damping, Direct, Hold_Airspeed), True);
      Fly (Item, 3, Commands,
           Measuring (Roll_Rate, 0, Measuring (Roll_Attitude, 0)));
      Expect ("without both the stick", Item.Flown =
                (Direct, Direct, Hold_Airspeed), True);

      --  While a law has the lever, the sticks have the other axes.
      Fly (Item, 100, (Commands with delta Roll => 2_500, Pitch => 1_900),
           Measuring (Roll_Rate, 0, Measuring (Roll_Attitude, 0)));
      Expect ("roll is the stick's",
              Output (Item, (Commands with delta Roll => 2_500)) (Roll),
              2_500);
      Expect ("so is pitch",
              Output (Item, (Commands with delta Pitch => 1_900)) (Pitch),
              1_900);

      Item := Warm (Commands);
      Fly (Item, 3, Commands, Measuring (Pitch_Attitude, 0));
      Expect ("without a nose damping of pitch", Item.Flown =
                (Bank_By_Stick, Damping, Hold_Airspeed), True);
   end Falling_Back;

   procedure Rudder_Falls_Back is
      Commands : constant Uplink_Buffer := With_On (Switch_1);
      Turning  : constant Downlink_Buffer :=
        Measuring (Yaw_Rate, Neutral_Value + 500);
      Item     : URV.Laws.Memory := Warm (Commands, Turning);
   begin
      Expect ("the yaw rate is damped", Item.Last.Yaw < 0, True);
      Fly (Item, 100, Commands, Measuring (Yaw_Rate, 0));
      Expect ("roll is still damped", Item.Flown.Lateral = Damping, True);
      Expect
        ("without its rate the rudder is the stick's",
         Item.Is_Stick (Yaw_Axis), True);
   end Rudder_Falls_Back;

   procedure Rudder_In_A_Turn is

      --  The rudder's demand at this bank and this yaw rate, in words.
      function Rudder (Bank, Turning : Integer) return Integer is
        (Warm
           (With_On (Switch_1),
            Measuring
              (Roll_Attitude, Word (Integer (Neutral_Value) + Bank),
               Measuring
                 (Yaw_Rate, Word (Integer (Neutral_Value) + Turning))))
           .Last.Yaw);

   begin
      --  A bank of 20 degrees needs a turn of about 5 degrees a second to the
      --  same side. Only a difference from it is damped.
      for Side in -1 .. 1 loop
         Expect
           ("no turn", Side * Rudder (Side * 228, 0) in 20 .. 60,
            Side /= 0);
         Expect
           ("the turn of its bank",
            Rudder (Side * 228, Side * 200) in -10 .. 10, True);
         Expect
           ("twice the turn",
            Side * Rudder (Side * 228, Side * 400) in -60 .. -20,
            Side /= 0);
      end loop;
   end Rudder_In_A_Turn;

   procedure Power_Begins is
      Item  : URV.Laws.Memory := Warm;
      Lever : constant Uplink_Buffer :=
        (With_On (Switch_3) with delta Throttle => 3_000);
   begin
      --  The lever jumps in the frame in which the law begins. The throttle
      --  stays where it was last, because the airspeed is as demanded.
      Expect_Number ("the lever's", Item.Last.Throttle, 2_048);
      Fly (Item, 1, Lever);
      Expect ("airspeed is held", Item.Flown.Power = Hold_Airspeed, True);
      Expect_Number ("integrator", Item.Power_Trim, 2_048 * 1_000);
      Expect_Number ("throttle", Item.Last.Throttle, 2_048);
      Fly (Item, 5, Lever);
      Expect_Number ("still", Item.Last.Throttle, 2_048);
   end Power_Begins;

   procedure Range_Check is
      Item : URV.Laws.Memory := Warm;
   begin
      Fly (Item, 2, Sticks, Measuring (Pitch_Rate, 4_095));
      Expect ("two may be wrong", Item.Checks (Pitch_Rate).Is_Valid, True);
      Expect ("the good one stands", Item.Checks (Pitch_Rate).Used,
              Neutral_Value);
      Fly (Item, 1, Sticks, Measuring (Pitch_Rate, 4_095));
      Expect ("three may not", Item.Checks (Pitch_Rate).Is_Valid, False);
      Expect ("the others are well", Item.Checks (Roll_Rate).Is_Valid, True);
      Fly (Item, 49, Sticks);
      Expect ("not a frame too early",
              Item.Checks (Pitch_Rate).Is_Valid, False);
      Fly (Item, 1, Sticks);
      Expect ("a second of good ones", Item.Checks (Pitch_Rate).Is_Valid,
              True);
   end Range_Check;

   procedure Rate_Check is
      Item : URV.Laws.Memory := Warm;
   begin
      Fly (Item, 1, Sticks, Measuring (Roll_Attitude, 3_000));
      Expect ("jumped away", Item.Checks (Roll_Attitude).Used,
              Neutral_Value);
      Fly (Item, 2, Sticks, Measuring (Roll_Attitude, 3_000));
      Expect ("and stayed away", Item.Checks (Roll_Attitude).Is_Valid,
              False);
   end Rate_Check;

   procedure No_Rule is
      Ends : constant array (1 .. 3) of Word := (0, 4_095, 0);
      Item : URV.Laws.Memory := Warm;
   begin
      for Value of Ends loop
         Fly (Item, 3, Sticks, Measuring (Uplink_Signal_Strength, Value));
         Expect ("the word is good", Item.Checks (Uplink_Signal_Strength).Used,
                 Value);
         Expect ("and the sensor valid",
                 Item.Checks (Uplink_Signal_Strength).Is_Valid, True);
      end loop;
      Fly (Item, 3, Sticks, Measuring (Uplink_Signal_Strength, 4_096));
      Expect ("no word of the converter",
              Item.Checks (Uplink_Signal_Strength).Is_Valid, False);
   end No_Rule;

   --  A mistyped rule is detected here, and by no flight.
   procedure Each_Rule is
   begin
      for Item in Law_Item loop
         declare
            Name : constant String := Item'Image;
            By   : constant Rule := Rule_Of (Item);
         begin
            Expect_Number
              (Name & ", the least word", Integer (By.Least),
               (case Item is
                   when Altitude_Offset | RPM | Alternator_Volts | Airspeed
                      | Altitude => 0,
                   when Battery_Volts => 500,
                   when others        => 1));
            Expect_Number
              (Name & ", the most", Integer (By.Most),
               (case Item is
                   when Right_Flap_1 | Left_Flap_1 | Right_Flap_2
                      | Left_Flap_2 => 4_095,
                   when Altitude_Offset | RPM | Battery_Volts
                      | Alternator_Volts | Airspeed => 4_000,
                   when others => 4_094));
            Expect_Number
              (Name & ", the most from scan to scan", Integer (By.Step),
               (case Item is
                   when Right_Flap_1 | Left_Flap_1 | Right_Flap_2
                      | Left_Flap_2 => 200,
                   when Altitude_Offset => 5,
                   when Lateral_Acceleration | Longitudinal_Acceleration
                      | Vertical_Acceleration => 4_095,
                   when RPM | Battery_Volts => 500,
                   when Alternator_Volts => 1_000,
                   when Roll_Attitude | Pitch_Attitude | Altitude => 60,
                   when Roll_Rate => 400,
                   when Pitch_Rate | Yaw_Rate => 800,
                   when Airspeed => 320,
                   when others => 600));
            Expect
              (Name & ", its witness",
               By.Witness =
                 (case Item is
                     when Roll_Attitude        => Roll_Rate,
                     when Pitch_Attitude       => Pitch_Rate,
                     when Roll_Rate | Yaw_Rate => Roll_Attitude,
                     when Pitch_Rate | Altitude => Pitch_Attitude,
                     when Airspeed             => Altitude,
                     when others               => Item),
               True);
            Expect_Number
              (Name & ", how far that goes away", Integer (By.Travel),
               (case Item is
                   when Roll_Attitude  => 100,
                   when Pitch_Attitude => 200,
                   when Roll_Rate | Pitch_Rate | Yaw_Rate | Altitude =>
                     340,  --  30 deg of an attitude
                   when Airspeed       => 400,
                   when others         => 4_095));
         end;
      end loop;
   end Each_Rule;

   procedure Stuck_Check is
      Item  : URV.Laws.Memory := Warm;
      Scan  : Downlink_Buffer := Level;
      Count : Natural := 0;
   begin
      --  The bank moves away while the roll rate reads zero.
      while Item.Checks (Roll_Rate).Is_Valid and then Count < 100 loop
         Count := Count + 1;
         Scan (Roll_Attitude) := Neutral_Value + Word (Count) * 20;
         Fly (Item, 1, Sticks, Scan);
      end loop;
      Expect_Number ("341 words in 18 scans, then ten", Count, 18 + 9);
      Expect ("the bank is well", Item.Checks (Roll_Attitude).Is_Valid, True);
   end Stuck_Check;

   procedure Stale_Scans is
      Item : URV.Laws.Memory := Warm (With_On (Switch_2));
   begin
      Fly (Item, 2, With_On (Switch_2),
           (Level with delta Error_Status => Stale_Data));
      Expect ("for two frames it flies on", Item.Flown.Lateral in Banked,
              True);
      Fly (Item, 1, With_On (Switch_2),
           (Level with delta Error_Status => Stale_Data));
      Expect ("then nobody but the pilot", Item.Flown = All_Direct, True);
      Expect ("all sensors", Status_Of (Item) (Invalid_Low),
              16#FFFF#);
      Fly (Item, 3, With_On (Switch_2),
           (Level with delta Error_Status => Stale_Data));
      Expect ("and so it stays", Item.Flown = All_Direct, True);
      Fly (Item, URV.Law_Gains.Good_Scans - 1, With_On (Switch_2));
      Expect ("a second of scans is needed", Item.Flown = All_Direct, True);
      Fly (Item, 1, With_On (Switch_2));
      Expect ("and is enough", Item.Flown.Lateral in Banked, True);
   end Stale_Scans;

   procedure Times_Of_Loss is
      Item : URV.Laws.Memory := Warm;
   begin
      Fly (Item, 24, Old);
      Expect_State ("after 24 frames", Item.Link.State, Linked);
      Expect ("and no law flies", Item.Flown = All_Direct, True);
      Fly (Item, 1, Old);
      Expect_State ("after 25 frames", Item.Link.State, Holding);
      Expect ("level", Item.Flown =
                (Wings_Level, Hold_Altitude, Hold_Airspeed), True);
      Fly (Item, 224, Old);
      Expect_State ("after 249 frames", Item.Link.State, Holding);
      Fly (Item, 1, Old);
      Expect_State ("after 250 frames", Item.Link.State, Orbiting);
      Expect ("turning", Item.Flown =
                (Orbit, Hold_Altitude, Hold_Airspeed), True);
      Fly (Item, 5_749, Old);
      Expect_State ("after 5999 frames", Item.Link.State, Orbiting);
      Fly (Item, 1, Old);
      Expect_State ("after 6000 frames", Item.Link.State, Terminated);
      Expect ("gliding", Item.Flown = (Wings_Level, Glide, Idle), True);
      Fly (Item, 60, Old);
      Expect_Number ("throttle idle", Item.Last.Throttle, 0);
   end Times_Of_Loss;

   procedure Way_Back is
      Item : URV.Laws.Memory := Warm;
   begin
      Fly (Item, 100, Old);
      Fly (Item, 49, Sticks);
      Expect_State ("after 49 fresh frames", Item.Link.State, Holding);
      Fly (Item, 1, Old);
      Fly (Item, 2, Sticks);
      Expect_State ("a gap costs two", Item.Link.State, Holding);
      Fly (Item, 1, Sticks);
      Expect_State ("at 50", Item.Link.State, Linked);
      Fly (Item, 24, Old);
      Expect_State ("the count begins again", Item.Link.State, Linked);
      Fly (Item, 1, Old);
      Expect_State ("25 silent frames, as ever", Item.Link.State, Holding);
      Fly (Item, 49, Sticks);
      Expect_State ("from 0 after a loss", Item.Link.State, Holding);

      --  A gap that would lose a link clears the count.
      Fly (Item, 25, Old);
      Fly (Item, 49, Sticks);
      Expect_State ("49 after a long gap", Item.Link.State, Holding);
      Fly (Item, 1, Sticks);
      Expect_State ("50 after it", Item.Link.State, Linked);

      --  Nothing was ever received.
      Item := (others => <>);
      Fly (Item, 7_000, Old);
      Expect_State ("nobody has ever flown", Item.Link.State, Waiting);
      Expect ("so nothing flies", Output (Item, Old) = Old, True);
   end Way_Back;

   --  A link that repeatedly brings Good frames and then loses Bad: the number
   --  of frames until it is back, at most Most.
   function Frames_Until_Back (Good, Bad, Most : Natural) return Natural;

   function Frames_Until_Back (Good, Bad, Most : Natural) return Natural is
      Item  : URV.Laws.Memory := Warm;
      Frame : Natural := 0;
   begin
      Fly (Item, 30, Old);
      while Item.Link.State /= Linked and then Frame < Most loop
         Fly (Item, 1,
              (if Frame mod (Good + Bad) < Bad then Old else Sticks));
         Frame := Frame + 1;
      end loop;
      return Frame;
   end Frames_Until_Back;

   procedure Proportions is
   begin
      Expect_Number ("nothing lost", Frames_Until_Back (100, 0, 200), 50);
      Expect_Number ("2 of 45", Frames_Until_Back (43, 2, 200), 58);
      Expect_Number ("1 of 10", Frames_Until_Back (9, 1, 200), 69);
      Expect_Number ("1 of 4", Frames_Until_Back (3, 1, 400), 192);
      Expect_Number ("1 of 3", Frames_Until_Back (2, 1, 2_000), 2_000);
      Expect_Number ("1 of 2", Frames_Until_Back (1, 1, 2_000), 2_000);
      Expect_Number ("24 of 25", Frames_Until_Back (1, 24, 2_000), 2_000);
   end Proportions;

   procedure Way_Out is
      Off  : constant Uplink_Buffer := Sticks;
      On   : constant Uplink_Buffer := With_On (Switch_7);
      Long : URV.Laws.Memory := Warm;
      Item : URV.Laws.Memory;
   begin
      Fly (Long, 6_000, Old);

      Item := Long;
      Fly (Item, 1_000, Off);
      Expect_State ("the link alone", Item.Link.State, Terminated);
      Fly (Item, 49, On);
      Expect_State ("49 frames on", Item.Link.State, Terminated);
      Fly (Item, 1, On);
      Expect_State ("50 frames on", Item.Link.State, Linked);

      Item := Long;
      Fly (Item, 1_000, On);
      Expect_State ("a switch left on", Item.Link.State, Terminated);

      Item := Long;
      Fly (Item, 49, Off);
      Fly (Item, 100, On);
      Expect_State ("49 frames off are too few", Item.Link.State, Terminated);

      Item := Long;
      Fly (Item, 60, Off);
      Fly (Item, 30, On);
      Fly (Item, 1, Old (On));
      Fly (Item, 21, On);
      Expect_State ("a gap costs two", Item.Link.State, Terminated);
      Fly (Item, 1, On);
      Expect_State ("no more", Item.Link.State, Linked);

      Item := Long;
      Fly (Item, 60, Off);
      Fly (Item, 1, Old (Off));
      Fly (Item, 100, On);
      Expect_State ("a gap before the switch spoils it", Item.Link.State,
                    Terminated);

      Item := Long;
      Fly (Item, 60, Off);
      Fly (Item, 30, On);
      Fly (Item, 40, Old (On));
      Fly (Item, 60, On);
      Expect_State ("so does a long one", Item.Link.State, Terminated);

      Item := Long;
      Fly (Item, 60, Off);
      Fly (Item, 30, On);
      Fly (Item, 1, Off);
      Fly (Item, 60, On);
      Expect_State ("so does a switch that goes to and fro",
                    Item.Link.State, Terminated);
   end Way_Out;

   procedure On_The_Ground is
      Standing : constant Downlink_Buffer :=
        Measuring (Altitude, 4, Measuring (Airspeed, 0));
      Item     : URV.Laws.Memory;
   begin
      Fly (Item, 60, Sticks, Standing);
      Fly (Item, 400, Old, Standing);
      Expect ("it idles", Item.Flown = (Direct, Direct, Idle), True);
      Expect_Number ("throttle", Item.Last.Throttle, 0);
      Expect_Number ("elevator at rest", Item.Last.Pitch, 0);
      Fly (Item, 6_000, Old, Standing);
      Expect_State ("to the end", Item.Link.State, Terminated);
      Expect ("it still idles", Item.Flown = (Direct, Direct, Idle), True);
   end On_The_Ground;

   procedure In_The_Air is
      Item : URV.Laws.Memory := Warm;
   begin
      --  Slow but not low: it stalls and has not landed. Then low, with an
      --  unknown speed.
      Fly (Item, 60, Sticks, Measuring (Airspeed, 0));
      Expect ("slow and high", Item.Is_Flying, True);
      Fly (Item, 60, Sticks, Measuring (Altitude, 4));
      Expect ("low and fast", Item.Is_Flying, True);
      Fly (Item, 60, Sticks,
           Measuring (Altitude, 4, Measuring (Airspeed, 9_999)));
      Expect ("low, and who knows how fast", Item.Is_Flying, True);
      Fly (Item, 60, Sticks,
           Measuring (Altitude, 4, Measuring (Airspeed, 0)));
      Expect ("slow and low", Item.Is_Flying, False);
   end In_The_Air;

   procedure Glide_By_Attitude is
      Item : URV.Laws.Memory := Warm;
   begin
      Fly (Item, 6_500, Old);
      Expect ("it glides", Item.Flown = (Wings_Level, Glide, Idle), True);
      Fly (Item, 500, Old, Measuring (Airspeed, 9_999));
      Expect ("without a speed too",
              Item.Flown = (Wings_Level, Glide, Idle), True);
      Expect_Number ("with its nose where the speed would be",
                     Item.Pitch_Wanted, URV.Law_Gains.Glide_Pitch);
   end Glide_By_Attitude;

   procedure What_Is_Held is
      Item  : URV.Laws.Memory := Warm (With_On (Switch_8));
      Other : constant Uplink_Buffer :=
        (Brake => On_Word, Error_Status => Stale_Data, others => 0);
   begin
      --  The ground has restarted: its old words differ.
      Fly (Item, 60, Other);
      Expect_State ("the link is lost", Item.Link.State, Holding);
      Expect ("the brake as last heard", Output (Item, Other) (Brake),
              Neutral_Value);
      Expect ("the flaps as last heard", Output (Item, Other) (Switch_8),
              On_Word);
      Expect ("not marked", Output (Item, Other) (Error_Status), No_Error);
   end What_Is_Held;

   procedure Told is
      Item : URV.Laws.Memory := Warm;
   begin
      Fly (Item, 300, Old);
      Fly (Item, 3, Old, Measuring (Yaw_Rate, 0));
      Expect ("orbit, altitude, airspeed, orbiting",
              Status_Of (Item) (Active), 16#3134#);
      Expect ("yaw rate is bit 7 of the second",
              Status_Of (Item) (Invalid_High), 16#80#);
      Expect ("silent frames",
              Status_Of (Item) (Silent), 303);

      --  The count exceeds a word, and then its own limit.
      Item.Link.Silent := Frame_Count (Word'Last) + 1;
      Expect ("silent for long", Status_Of (Item) (Silent),
              Word'Last);
      Item.Link.Silent := Frame_Count'Last;
      Fly (Item, 2, Old);
      Expect_Number
        ("the count stops", Integer (Item.Link.Silent),
         Integer (Frame_Count'Last));
   end Told;

   --  The state of one integrator, by the measurement of its law

   type Trimmed is (By_Bank, By_Pitch, By_Altitude, By_Airspeed);

   function Trim_Of (Item : URV.Laws.Memory; Which : Trimmed) return Integer
   is
     (case Which is
         when By_Bank     => Item.Roll_Trim,
         when By_Pitch    => Item.Pitch_Trim,
         when By_Altitude => Item.Height_Trim,
         when By_Airspeed => Item.Power_Trim);

   Measures : constant array (Trimmed) of Sensor_Item :=
     (By_Bank     => Roll_Attitude,
      By_Pitch    => Pitch_Attitude,
      By_Altitude => Altitude,
      By_Airspeed => Airspeed);

   --  The command for this law alone.
   function Holding (Which : Trimmed) return Uplink_Buffer is
     (With_On (if Which = By_Pitch then Switch_2 else Switch_3));

   --  In level flight, with its sensor this far from its target.
   function Beside (Which : Trimmed; Words : Integer) return Downlink_Buffer
   is
     (Measuring
        (Measures (Which),
         Word (Integer (Level (Measures (Which))) + Words)));

   --  The laws' pitch in level flight: 2.4 degrees up.
   Pitch_Up : constant Word := 2_048 + 55;

   procedure Integrators_Follow is
      Item    : URV.Laws.Memory;
      Before  : Integer;
      Sensors : Downlink_Buffer;
   begin
      for Which in Trimmed loop
         for Words of Integer_List'(-30, 30) loop
            Item := Warm
              (Holding (Which), Measuring (Pitch_Attitude, Pitch_Up));
            Before := Trim_Of (Item, Which);
            Sensors := (Beside (Which, Words) with delta
                          Pitch_Attitude =>
                            (if Which = By_Pitch
                             then Word (Integer (Pitch_Up) + Words)
                             else Pitch_Up));
            --  The first frames of an altitude law are a climb.
            Fly (Item, 100, Holding (Which), Sensors);
            if Which = By_Altitude then
               Before := Trim_Of (Item, Which);
            end if;
            Fly (Item, 50, Holding (Which), Sensors);
            Expect
              (Which'Image & " after" & Words'Image & " words",
               (if Words < 0 then Trim_Of (Item, Which) > Before
                else Trim_Of (Item, Which) < Before),
               True);
         end loop;
      end loop;
   end Integrators_Follow;

   procedure Integrators_Recover is
      Item : URV.Laws.Memory;
   begin
      for Which in Trimmed loop
         --  The integrator is at its limit, as after a long time with a
         --  saturated surface; then the error changes its sign.
         Item := Warm (Holding (Which), Measuring (Pitch_Attitude, Pitch_Up));
         Item.Roll_Trim := URV.Law_Axes.Roll_Trim'Last;
         Item.Pitch_Trim := URV.Law_Axes.Pitch_Trim'Last;
         Item.Height_Trim := URV.Law_Axes.Height_Trim'Last;
         Item.Power_Trim := URV.Law_Axes.Power_Trim'Last;
         --  A larger jump of altitude would be invalid. The lever moves the
         --  target of the airspeed.
         Fly (Item, (if Which = By_Altitude then 1_400 else 900),
              (Holding (Which) with delta
                 Throttle => (if Which = By_Airspeed then 1_248 else 2_048)),
              (Beside (Which, (case Which is
                                  when By_Bank | By_Pitch => 320,
                                  when By_Altitude        => 30,
                                  when By_Airspeed        => 0))
                 with delta
                 Pitch_Attitude =>
                   (if Which = By_Pitch then Pitch_Up + 320 else Pitch_Up)));
         Expect (Which'Image & " unwinds, from a large error",
                 (if Which = By_Airspeed then Item.Last.Throttle = 0
                  else Trim_Of (Item, Which) <= 0), True);
      end loop;
   end Integrators_Recover;

   procedure Large_Errors_Count is
      Item   : URV.Laws.Memory;
      Before : Integer;

      --  100 ft lower, 5 ft at a time; then this number of frames.
      procedure Sink (Speed : Word; Frames : Positive);

      procedure Sink (Speed : Word; Frames : Positive) is
         Sensors : Downlink_Buffer :=
           (Level with delta
              Airspeed => Speed, Pitch_Attitude => Pitch_Up);
      begin
         Item := Warm (With_On (Switch_3), Sensors);
         for Step in 1 .. 20 loop
            Sensors (Altitude) := Sensors (Altitude) - 10;
            Fly (Item, 2, With_On (Switch_3), Sensors);
         end loop;
         Fly (Item, 200, With_On (Switch_3), Sensors);
         Before := Item.Height_Trim;
         Fly (Item, Frames, With_On (Switch_3), Sensors);
         Expect ("the altitude is held",
                 Item.Flown.Vertical = Hold_Altitude, True);
         Expect_Number ("that there was", Item.Height_Held, 2_000);
      end Sink;

   begin
      --  The pitch is as wanted, but the climb is not.
      Sink (Speed => 2_240, Frames => 1);
      Expect ("learns from 100 ft", Item.Height_Trim > Before, True);

      --  Below the guard's speed the nose is lowered: the integrator stops.
      Sink (Speed => 1_500, Frames => 500);
      Expect_Number ("too slow to climb", Item.Height_Trim, Before);
   end Large_Errors_Count;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "EXT-3 with the law switches off all passes as it is",
           All_Off'Access);
      Add (Suite, "EXT-3 disconnect is direct in one frame",
           Disconnected'Access);
      Add (Suite, "EXT-3 an axis goes back to its stick at the rate limit",
           Letting_Go'Access);
      Add (Suite, "EXT-3 each law acts against its measured error",
           Signs'Access);
      Add (Suite, "EXT-3 a stick that is moved lets go of the altitude",
           Let_Go_Of_The_Altitude'Access);
      Add (Suite, "EXT-3 a law whose sensor is not valid falls back",
           Falling_Back'Access);
      Add (Suite, "EXT-3 the rudder falls back to its stick alone",
           Rudder_Falls_Back'Access);
      Add (Suite, "EXT-3 the rudder does not damp the turn of a bank",
           Rudder_In_A_Turn'Access);
      Add (Suite, "EXT-3 the throttle's law begins at its last output",
           Power_Begins'Access);
      Add (Suite, "EXT-3 three words out of range are not valid",
           Range_Check'Access);
      Add (Suite, "EXT-3 a word that jumps away is not believed",
           Rate_Check'Access);
      Add (Suite, "EXT-3 without a rule every word of the converter is good",
           No_Rule'Access);
      Add (Suite, "EXT-3 each sensor has its ends, its rate and its witness",
           Each_Rule'Access);
      Add (Suite, "EXT-3 a sensor that does not follow its witness is stuck",
           Stuck_Check'Access);
      Add (Suite, "EXT-3 without scans no law flies", Stale_Scans'Access);
      Add (Suite, "EXT-5 each state of loss comes in its very frame",
           Times_Of_Loss'Access);
      Add (Suite, "EXT-5 a second of fresh uplinks is the link's return",
           Way_Back'Access);
      Add (Suite, "D-35 a link returns on a proportion of its frames",
           Proportions'Access);
      Add (Suite, "EXT-5 only the ground's order ends a termination",
           Way_Out'Access);
      Add (Suite, "EXT-5 on the ground a lost link idles",
           On_The_Ground'Access);
      Add (Suite, "EXT-5 slow and low is the ground, all else is not",
           In_The_Air'Access);
      Add (Suite, "EXT-5 without an airspeed it glides by its attitude",
           Glide_By_Attitude'Access);
      Add (Suite, "EXT-5 brake and switches stay as last heard",
           What_Is_Held'Access);
      Add (Suite, "EXT-5 the ground gets the modes and their reasons",
           Told'Access);
      Add (Suite, "EXT-8 an integrator moves with the sign of its error",
           Integrators_Follow'Access);
      Add (Suite, "EXT-8 an integrator unwinds from its limit",
           Integrators_Recover'Access);
      Add (Suite, "D-31 a large error counts, unless nothing is left",
           Large_Errors_Count'Access);
   end Add_To;

end Laws_Tests;
