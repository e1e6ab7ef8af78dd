--  SPDX-License-Identifier: Apache-2.0

with Ada.Numerics.Elementary_Functions;
use Ada.Numerics.Elementary_Functions;
with Ada.Numerics.Generic_Elementary_Functions;

with Checks;              use Checks;
with Expectations;        use Expectations;
with URV.Allocation;      use URV.Allocation;
with URV.Buffers;         use URV.Buffers;
with URV.Engine_Monitor;
with URV.Law_Units;       use URV.Law_Units;
with URV.PWM_Transform;   use URV.PWM_Transform;
with URV.Servo_Models;
with URV.Surface_Monitor; use URV.Surface_Monitor;
with URV.Surfaces;        use URV.Surfaces;

separate (Law_Suite)
package body Surfaces_Tests is

   --  The tests, in order.
   procedure Sound_Ones;
   procedure Quick_And_Slow_Ones;
   procedure Stuck_Ones;
   procedure Small_Offset;
   procedure Old_Sensors;
   procedure After_A_Restart;
   procedure Figure_13;
   procedure Partners;
   procedure Signs;
   procedure Flaps_Help;
   procedure Stops;
   procedure Engine_Follows;
   procedure Engine_Does_Not;
   procedure Engine_Held;
   procedure Engine_Run_Up;
   procedure Begins_Again;
   procedure Engine_Unknown;
   procedure Equality;

   --  A textbook servo: a lag of 0.1 s and a rate limit, in steps of 2 ms. Its
   --  words of a frame act from 4 ms after the scan on. It may be faster or
   --  slower, and rest within a dead band.
   type Exact is digits 12;
   type Servo_Kind is record
      Lag, Rate, Dead_Band : Exact;
   end record;
   Usual : constant Servo_Kind :=
     (Lag => 1.0, Rate => 1.0, Dead_Band => 0.0);

   type Exact_Table is array (Surface) of Exact;
   type Rig is record
      Lagged, Place : Exact_Table := (others => 0.0);
      Words         : Surface_Demands := (others => 0);
      Scanned       : Surface_Demands := (others => 0);
      Seen          : Surface_Demands := (others => 0);
      Watch         : Monitor;
      Kind          : Servo_Kind := Usual;
   end record;

   package Engines renames URV.Engine_Monitor;
   package Law_Units renames URV.Law_Units;
   package Servo_Models renames URV.Servo_Models;
   package Functions is new Ada.Numerics.Generic_Elementary_Functions (Exact);
   use Functions;

   Free : constant Surface_Flags := None;

   --  In each frame the monitor sees the scan of the frame before; then the
   --  servos get their words. A stuck servo stays; all sensors are off by
   --  Bias.
   procedure Fly
     (Plane  : in out Rig;
      Words  : Surface_Demands;
      Stuck  : Surface_Flags := Free;
      Bias   : Number        := 0;
      Is_Old : Boolean       := False;
      Frames : Positive      := 1);

   procedure Move
     (Plane : in out Rig; Stuck : Surface_Flags; Steps : Positive);

   --  The longest movement of a surface in 2 ms.
   function Longest (Which : Surface) return Exact is
     (case Which is
         when Left_Aileron | Right_Aileron => 20.0,
         when Flap                         => 1.365,
         when others                       => 16.0);

   --  The goal of a servo: none within its dead band, which is a share of the
   --  travel.
   function Goal_Of (Plane : Rig; Which : Surface) return Exact is
     (if abs (Exact (Plane.Words (Which)) - Plane.Place (Which)) <=
           Plane.Kind.Dead_Band
             * Exact (Highest (Which) - Lowest (Which))
      then Plane.Place (Which)
      else Exact (Plane.Words (Which)));

   function Everywhere (Value : Demand) return Surface_Demands is
     (for Which in Surface => Reachable (Which, Value));

   function Image_Of (Places : Surface_Demands; Is_Old : Boolean)
                      return Downlink_Buffer;

   --  The number of failures in a table of flags.
   function Count (Failed : Surface_Flags) return Natural;

   Commands : constant Uplink_Buffer :=
     (Roll         => 16#888#,
      Pitch        => 16#744#,
      Yaw          => 16#801#,
      Throttle     => 16#444#,
      Brake        => 16#855#,
      Switch_Item  => 0,
      Error_Status => No_Error);

   Level : constant Uplink_Buffer :=
     (Commands with delta
        Roll | Pitch | Yaw | Brake => Neutral_Value);

   --  One surface rests at a place, the others where they should be.
   function With_Failed
     (Which : Surface; Place : Demand; Wanted : Uplink_Buffer := Level)
      return Health
   is
     (Failed => (None with delta Which => True),
      Places =>
        (Demands_Of (Transform (Wanted)) with delta Which => Place));

   function Given (Wanted : Uplink_Buffer; Now : Health)
                   return Surface_Demands
   is (Demands_Of (Servos (Wanted, Now)));

   procedure Move
     (Plane : in out Rig; Stuck : Surface_Flags; Steps : Positive) is
   begin
      for Step in 1 .. Steps loop
         for Which in Surface loop
            if not Stuck (Which) then
               Plane.Lagged (Which) := Plane.Lagged (Which)
                 + (Goal_Of (Plane, Which) - Plane.Lagged (Which))
                   * (1.0 - Exp (-0.02 / Plane.Kind.Lag));
               Plane.Place (Which) := Plane.Place (Which)
                 + Exact'Max
                     (-Longest (Which) * Plane.Kind.Rate,
                      Exact'Min
                        (Longest (Which) * Plane.Kind.Rate,
                         Plane.Lagged (Which) - Plane.Place (Which)));
            end if;
         end loop;
      end loop;
   end Move;

   function Image_Of (Places : Surface_Demands; Is_Old : Boolean)
                      return Downlink_Buffer
   is
      Image : Downlink_Buffer :=
        (Error_Status => (if Is_Old then Stale_Data else No_Error),
         others       => Neutral_Value);
   begin
      for Which in Surface loop
         Image (Sensor_Of (Which)) := Word_Of (Places (Which));
      end loop;
      return Image;
   end Image_Of;

   procedure Fly
     (Plane  : in out Rig;
      Words  : Surface_Demands;
      Stuck  : Surface_Flags := Free;
      Bias   : Number        := 0;
      Is_Old : Boolean       := False;
      Frames : Positive      := 1) is
   begin
      for Frame in 1 .. Frames loop
         --  The node now has the scan of the frame before.
         Plane.Seen := Plane.Scanned;
         for Which in Surface loop
            Plane.Scanned (Which) := Within
              (Number (Plane.Place (Which)) + Bias, Demand'First, Demand'Last);
         end loop;
         Plane.Watch := With_Sent
           (Next (Plane.Watch, Image_Of (Plane.Seen, Is_Old)), Words);
         Move (Plane, Stuck, 2);
         Plane.Words := Words;
         Move (Plane, Stuck, 8);
      end loop;
   end Fly;

   function Count (Failed : Surface_Flags) return Natural is
      Sum : Natural := 0;
   begin
      for Flag of Failed loop
         Sum := Sum + Boolean'Pos (Flag);
      end loop;
      return Sum;
   end Count;

   procedure Sound_Ones is
      Plane : Rig;
   begin
      for Frame in 1 .. 2_000 loop
         --  Steps from stop to stop, fast and slow.
         Fly (Plane,
              Everywhere
                (if Frame < 60 then 0
                 elsif Frame / 7 mod 2 = 0 then 1_900 - Frame
                 elsif Frame / 91 mod 2 = 0 then -1_500
                 else Frame mod 150 * 10 - 700),
              Bias => Frame mod 21 - 10);
      end loop;
      Expect_Number ("named", Count (Plane.Watch.Failed), 0);
   end Sound_Ones;

   --  Words at frame N: steps, doublets, sweeps and a random telegraph.
   function Any_Word (Frame, Sort : Natural) return Demand is
     (case Sort mod 6 is
         when 0      => (if Frame / 40 mod 2 = 0 then 1_455 else -1_455),
         when 1      => (case Frame mod 50 is
                            when 0 .. 6  => 2_047,
                            when 7 .. 13 => -2_048,
                            when others  => 0),
         when 2      => Demand
                          (2_000.0
                           * Sin (Float (Frame * Frame) / 8_000.0)),
         when 3      => Demand (300.0 * Sin (Float (Frame) * 0.9)),
         when 4      => (if Frame * Frame mod 97 mod 5 < 2
                         then 2_047 else -2_048),
         when others => Frame * 7_919 mod 4_001 - 2_000);

   --  A lag and a rate limit of half to one and a half times the usual, or no
   --  rate limit, and a dead band of up to 1 % of the travel.
   procedure Quick_And_Slow_Ones is
      Lags  : constant array (1 .. 4) of Exact := (0.2, 0.5, 1.0, 1.5);
      Rates : constant array (1 .. 4) of Exact := (0.5, 1.0, 1.5, 1.0E6);
      Bands : constant array (1 .. 2) of Exact := (0.0, 0.01);
      Frames : constant Positive :=
        (if Contracts_Are_Executed then 60 else 600);
   begin
      for Lag of Lags loop
         for Rate of Rates loop
            for Band of Bands loop
               for Sort in 0 .. 5 loop
                  declare
                     Plane : Rig := (Kind => (Lag, Rate, Band), others => <>);
                  begin
                     for Frame in 1 .. Frames loop
                        Fly (Plane, Everywhere (Any_Word (Frame, Sort)),
                             Bias => Frame mod 21 - 10);
                     end loop;
                     Expect_Number
                       ("lag" & Lag'Image & ", rate" & Rate'Image
                        & ", dead band" & Band'Image & ", words"
                        & Sort'Image,
                        Count (Plane.Watch.Failed), 0);
                  end;
               end loop;
            end loop;
         end loop;
      end loop;
   end Quick_And_Slow_Ones;

   procedure Stuck_Ones is
      --  The frames until a flap's bounds have narrowed.
      Coming_In : constant := 400;
   begin
      for Which in Surface loop
         declare
            Plane  : Rig;
            Named : Natural := 0;
         begin
            Fly (Plane, Everywhere (0), Frames => Coming_In);
            for Frame in 1 .. 25 loop
               Fly (Plane, Everywhere (400), (None with delta Which => True));
               if Plane.Watch.Failed (Which) and then Named = 0 then
                  Named := Frame;
               end if;
            end loop;
            Expect (Which'Image & " named", Named in 4 .. 25, True);
            Expect_Number
              (Which'Image & " alone", Count (Plane.Watch.Failed), 1);
            Expect_Number
              ("bit", Integer (Bits_Of (Plane.Watch.Failed)),
               2 ** Surface'Pos (Which));
         end;
      end loop;
   end Stuck_Ones;

   procedure Small_Offset is
      Plane : Rig;
      --  The largest dead band.
      Band  : constant Demand := Servo_Models.Dead_Band (Left_Aileron);
   begin
      Fly (Plane, Everywhere (0), Frames => 400);
      Fly (Plane, Everywhere (0), Bias => Allowance, Frames => 500);
      Expect_Number ("named within", Count (Plane.Watch.Failed), 0);
      Fly (Plane, Everywhere (0), Bias => Band + Allowance + 20,
           Frames => 50);
      Expect_Number ("named beyond", Count (Plane.Watch.Failed), 10);
   end Small_Offset;

   procedure Old_Sensors is
      Plane : Rig;
   begin
      Fly (Plane, Everywhere (0), Frames => 100);
      Fly (Plane, Everywhere (400), (others => True), Is_Old => True,
           Frames => 50);
      Expect_Number ("named by old ones", Count (Plane.Watch.Failed), 0);
   end Old_Sensors;

   procedure After_A_Restart is
      Plane : Rig;
   begin
      Fly (Plane, Everywhere (0), Frames => 100);
      Fly (Plane, Everywhere (400),
           (Left_Rudder => True, others => False), Frames => 25);
      --  The others moved while no monitor ran.
      Plane.Words := Everywhere (-700);
      Move (Plane, Free, 300);
      Plane.Watch := Restarted (Plane.Watch);
      Fly (Plane, Everywhere (-700), Frames => 100);
      Expect ("still known", Plane.Watch.Failed (Left_Rudder), True);
      Expect_Number ("no other", Count (Plane.Watch.Failed), 1);
   end After_A_Restart;

   procedure Figure_13 is
      Now : constant Health :=
        (Failed => None, Places => Everywhere (1_234));
   begin
      for Item in PWM_Item loop
         Expect (Item'Image, Servos (Commands, Now) (Item),
                 Transform (Commands) (Item));
      end loop;
   end Figure_13;

   procedure Partners is
      type Pair is array (1 .. 2) of Surface;
      Pairs : constant array (1 .. 3) of Pair :=
        ((Left_Aileron, Right_Aileron), (Left_Elevator, Right_Elevator),
         (Left_Rudder, Right_Rudder));
   begin
      --  The partner moves as far the other way, within a tenth.
      for One of Pairs loop
         declare
            After : constant Surface_Demands :=
              Given (Level, With_Failed (One (1), 600));
         begin
            Expect
              (One (2)'Image, After (One (2)) in -660 .. -540, True);
            Expect_Number (One (1)'Image, After (One (1)), 0);
         end;
         declare
            After : constant Surface_Demands :=
              Given (Level, With_Failed (One (2), -600));
         begin
            Expect (One (1)'Image, After (One (1)) in 540 .. 660, True);
         end;
      end loop;
   end Partners;

   procedure Signs is
      --  Left flap down: it rolls right, so the ailerons roll left.
      Left_Down : constant Surface_Demands :=
        Given (Level, With_Failed (Left_Flap_1, 2_047));

      --  The same on the right.
      Right_Down : constant Surface_Demands :=
        Given (Level, With_Failed (Right_Flap_2, 2_047));
   begin
      Expect ("left flap", Left_Down (Left_Aileron) < -200, True);
      Expect ("right flap", Right_Down (Right_Aileron) > 150, True);
      Expect_Number ("other flap", Left_Down (Left_Flap_2), 0);
   end Signs;

   procedure Flaps_Help is
      Wanted : constant Health := With_Failed (Left_Aileron, 2_000);
      First  : constant Surface_Demands := Given (Level, Wanted);
      Down   : constant Health :=
        (Wanted with delta
           Places =>
             (Wanted.Places with delta
                Right_Flap_1 | Right_Flap_2 => First (Right_Flap_1)));
      Then_On : constant Surface_Demands := Given (Level, Down);
   begin
      --  The aircraft rolls right: the other aileron fully left, the right
      --  flaps down. As these move down, the aileron returns.
      Expect ("aileron", First (Right_Aileron) < -1_800, True);
      Expect ("right flap 1", First (Right_Flap_1) > 1_000, True);
      Expect ("right flap 2", First (Right_Flap_2) > 1_000, True);
      Expect_Number ("left flap", First (Left_Flap_1), 0);
      Expect
        ("aileron back", Then_On (Right_Aileron) in -1_150 .. -850, True);
      Expect_Number
        ("flap stays", Then_On (Right_Flap_1), First (Right_Flap_1));

      --  One flap has failed at its place. Its roll is shared between the
      --  ailerons, and only one can do its part.
      Expect
        ("with a flap that stays down",
         Then_On (Right_Aileron)
         - Given
             (Level,
              (Down with delta
                 Failed =>
                   (Down.Failed with delta Right_Flap_2 => True)))
             (Right_Aileron) in 150 .. 220,
         True);
      Expect
        ("none has failed: as it was wanted",
         Demands
           (Demands_Of (Transform (Commands)),
            (Down with delta Failed => None))
         = Demands_Of (Transform (Commands)),
         True);
   end Flaps_Help;

   procedure Stops is
      Full : constant Uplink_Buffer :=
        (Level with delta Roll | Pitch | Yaw => 16#FFF#);
   begin
      for Which in Surface loop
         for Place of Surface_Demands'(Everywhere (-2_000)) loop
            for Item in Surface loop
               declare
                  After : constant Demand :=
                    Given (Full, With_Failed (Which, Place, Full)) (Item);
               begin
                  Expect
                    (Item'Image,
                     Item = Which
                       or else After in Lowest (Item) .. Highest (Item),
                     True);
               end;
            end loop;
         end loop;
      end loop;
   end Stops;

   --  An engine approaches the speed of its throttle by a 25th a frame.
   type Engine_Rig is record
      Speed : Exact := 2_600.0;
      Watch : Engines.Monitor;
   end record;

   procedure Run
     (Engine   : in out Engine_Rig;
      Asked    : Lever;
      Obeyed   : Lever;
      Frames   : Positive;
      Airspeed : Law_Units.Level := Engines.Cruise;
      Is_Known : Boolean         := True);

   procedure Run
     (Engine   : in out Engine_Rig;
      Asked    : Lever;
      Obeyed   : Lever;
      Frames   : Positive;
      Airspeed : Law_Units.Level := Engines.Cruise;
      Is_Known : Boolean         := True) is
   begin
      for Frame in 1 .. Frames loop
         Engine.Watch := Engines.Next
           (Engine.Watch, Asked, Law_Units.Level (Engine.Speed), Airspeed,
            Is_Known);
         Engine.Speed := Engine.Speed
           + (Exact (Engines.Steady (Obeyed, Airspeed)) - Engine.Speed) / 25.0;
      end loop;
   end Run;

   procedure Engine_Follows is
      Engine : Engine_Rig;
   begin
      Run (Engine, 2_048, 2_048, 500);
      for Round in 1 .. 10 loop
         Run (Engine, 4_095, 4_095, 17 * Round);
         Run (Engine, 0, 0, 29 * Round, Airspeed => 2_900);
         Run (Engine, 1_500, 1_500, 40);
      end loop;
      Expect ("told", Engine.Watch.Failed, False);
   end Engine_Follows;

   procedure Engine_Does_Not is
   begin
      for Eighth in Number range 0 .. 7 loop
         declare
            Stuck : constant Lever := Eighth * Engines.Per_Eighth;
            Engine  : Engine_Rig;
         begin
            Run (Engine, 2_048, 2_048, 500);
            Run (Engine, (if Stuck < 2_048 then 4_095 else 0), Stuck, 250);
            Expect ("stuck at" & Stuck'Image, Engine.Watch.Failed, True);
            Run (Engine, 2_048, 2_048, 500);
            Expect ("not forgotten", Engine.Watch.Failed, True);
         end;
      end loop;
   end Engine_Does_Not;

   procedure Engine_Held is
      Engine : Engine_Rig;
   begin
      --  The bench holds the same word, whatever the throttle does.
      Engine.Speed := 2_048.0;
      for Frame in 1 .. 1_000 loop
         Engine.Watch := Engines.Next
           (Engine.Watch, (if Frame < 300 then 2_048 else 4_095),
            2_048, Engines.Cruise, Is_Known => True);
      end loop;
      Expect ("told of a speed that is held", Engine.Watch.Failed, False);
      --  Once the word has moved, it counts as a measurement.
      Run (Engine, 4_095, 0, 100);
      Expect ("told of one that has moved", Engine.Watch.Failed, True);
   end Engine_Held;

   procedure Engine_Run_Up is
      Engine : Engine_Rig;
   begin
      --  The speed has moved before the take-off, and is constant after it.
      Engine.Watch := Engines.Next
        (Engine.Watch, 0, 1_140, 0, Is_Known => True);
      Engine.Watch := Engines.Next
        (Engine.Watch, 0, 1_140 + Engines.Movement, 0, Is_Known => True);
      Expect ("has moved", Engine.Watch.Has_Moved, True);
      for Frame in 1 .. 500 loop
         Engine.Watch := Engines.Next
           (Engine.Watch, 4_095, 1_148, Engines.Cruise, Is_Known => True);
      end loop;
      Expect ("told of a stuck one", Engine.Watch.Failed, True);
   end Engine_Run_Up;

   procedure Begins_Again is
      Before : constant Monitor :=
        (Doubts  => (others => 5),
         Unknown => 0,
         Engine  => (Doubt => 3, Failed => True, others => <>),
         others  => <>);
      After  : constant Monitor := Restarted (Before);
   begin
      Expect
        ("no doubt remains", (for all Doubt of After.Doubts => Doubt = 0),
         True);
      Expect_Number ("unknown frames", After.Unknown, 3);
      Expect ("the engine's failure", After.Engine.Failed, True);
      Expect_Number ("its doubt", After.Engine.Doubt, 0);

      --  Only words that are sent make the servos known.
      Expect_Number
        ("without words", With_None_Sent (After).Unknown, 3);
      Expect_Number
        ("with words", With_Sent (After, After.Sent).Unknown, 2);
   end Begins_Again;

   procedure Engine_Unknown is
      Engine : Engine_Rig;
   begin
      Run (Engine, 2_048, 2_048, 500);
      Run (Engine, 4_095, 0, 500, Airspeed => Engines.Slowest - 1);
      Run (Engine, 4_095, 0, 500, Is_Known => False);
      Expect ("told", Engine.Watch.Failed, False);
      Expect_Number
        ("bit", Integer (Failed_Bits ((others => <>))), 0);
      Run (Engine, 4_095, 0, 500);
      Expect ("told when it is known", Engine.Watch.Failed, True);
      Expect_Number
        ("bit of the throttle",
         Integer
           (Failed_Bits
              (Monitor'(Engine => Engine.Watch, others => <>))),
         1_024);
   end Engine_Unknown;

   --  The equality names each component (URV.Surface_Monitor).
   procedure Equality is
      One : constant Monitor := (others => <>);

      procedure Expect_Other (Name : String; Other : Monitor);

      procedure Expect_Other (Name : String; Other : Monitor) is
      begin
         Expect (Name, One = Other, False);
         Expect (Name & ", itself", Other = Other, True);
      end Expect_Other;

   begin
      Expect_Other
        ("Ranges", (One with delta Ranges => (others => (1, 2))));
      Expect_Other ("Doubts", (One with delta Doubts => (others => 1)));
      Expect_Other ("Failed", (One with delta Failed => (others => True)));
      Expect_Other ("Places", (One with delta Places => (others => 1)));
      Expect_Other ("Sent", (One with delta Sent => (others => 1)));
      Expect_Other
        ("Sent_Before", (One with delta Sent_Before => (others => 1)));
      Expect_Other
        ("Sent_First", (One with delta Sent_First => (others => 1)));
      Expect_Other ("Unknown", (One with delta Unknown => 0));
      Expect_Other
        ("Engine",
         (One with delta Engine => (One.Engine with delta Failed => True)));
      Expect_Other ("Power", (One with delta Power => 1));
   end Equality;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "EXT-6 surfaces that follow are not named, whatever moves",
           Sound_Ones'Access);
      Add (Suite, "EXT-6 D-32 a sound servo is not named, quick or slow",
           Quick_And_Slow_Ones'Access);
      Add (Suite, "EXT-6 each stuck surface is named within 0.5 s, alone",
           Stuck_Ones'Access);
      Add (Suite, "EXT-6 an offset is allowed up to its limit",
           Small_Offset'Access);
      Add (Suite, "EXT-6 old sensors name no surface", Old_Sensors'Access);
      Add (Suite, "EXT-6 a restart forgets no failure and sees none",
           After_A_Restart'Access);
      Add (Suite, "EXT-6 without a failure it is figure 13",
           Figure_13'Access);
      Add (Suite, "EXT-6 the partner makes up for a stuck surface",
           Partners'Access);
      Add (Suite, "EXT-6 ailerons make up for a flap", Signs'Access);
      Add (Suite, "EXT-6 flaps help an aileron at its limit, slowly",
           Flaps_Help'Access);
      Add (Suite, "EXT-6 nothing is asked beyond the stops", Stops'Access);
      Add (Suite, "EXT-6 an engine that follows is not reported",
           Engine_Follows'Access);
      Add (Suite, "EXT-6 a stuck engine is reported, at any place",
           Engine_Does_Not'Access);
      Add (Suite, "EXT-6 a speed that is held is not reported",
           Engine_Held'Access);
      Add (Suite, "EXT-6 after a start three frames of words are unknown",
           Begins_Again'Access);
      Add (Suite, "EXT-6 a speed that moved on the ground is measured",
           Engine_Run_Up'Access);
      Add (Suite, "EXT-6 no engine is reported on the ground or unseen",
           Engine_Unknown'Access);
      Add (Suite, "EXT-6 monitors with one other component are not equal",
           Equality'Access);
   end Add_To;

end Surfaces_Tests;
