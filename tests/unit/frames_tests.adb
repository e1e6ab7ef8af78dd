--  SPDX-License-Identifier: Apache-2.0

with Checks;              use Checks;
with Devices.PWM_Board;
with Expectations;        use Expectations;
with URV.Configurations;  use URV.Configurations;
with URV.Console_Watch;
with URV.Engine_Monitor;
with URV.Frame_Times;     use URV.Frame_Times;
with URV.Handshakes;
with URV.Law_Gains;       use URV.Law_Gains;
with URV.Link_Loss;
with URV.Seals;
with URV.Servo_Models;    use URV.Servo_Models;
with URV.Surface_Monitor; use URV.Surface_Monitor;
with URV.Surfaces;        use URV.Surfaces;
with URVOS.Frames;        use URVOS.Frames;
with URVOS.Waits;

package body Frames_Tests is

   --  The tests, in order.
   procedure Time_Units;
   procedure Advance;
   procedure Clock_At_Limit;
   procedure Next_Frames;
   procedure Releases;
   procedure One_Frame;
   procedure Times;
   procedure Rates;

   procedure Time_Units is
   begin
      Expect_Number ("microseconds a tick", Microseconds_Per_Tick, 2_000);
      Expect_Number ("ticks a major frame", Ticks_Per_Major_Frame, 10);
      Expect_Number
        ("microseconds a major frame",
         Microseconds_Per_Tick * Ticks_Per_Major_Frame, 20_000);
      Expect_Number ("first minor frame", Integer (Minor_Frame'First), 0);
      Expect_Number ("last minor frame", Integer (Minor_Frame'Last), 9);
   end Time_Units;

   procedure Advance is
      Now : Clock_Tick := 0;
   begin
      for Minor in 1 .. 1_000 loop
         Now := Advanced (Now);
         Expect ("clock", Now, Tick (Minor));
         Expect_Number
           ("minor frame", Integer (Minor_Frame_Of (Now)), Minor mod 10);
      end loop;
   end Advance;

   procedure Clock_At_Limit is
      Seven_Days : constant := 7 * 24 * 3_600 * 500;
      Now        : Clock_Tick := Last_Tick - 1;
   begin
      Expect
        ("clock in a flight of seven days", Advanced (Seven_Days),
         Seven_Days + 1);
      Now := Advanced (Now);
      Expect ("clock at its last tick", Now, Last_Tick);
      Now := Advanced (Now);
      Expect ("clock after its last tick", Now, Last_Tick);
      Expect ("next frame is in the future", Next_Frame (Now) > Now, True);
      Expect
        ("and no overflow with the greatest offset",
         Next_Release (Now, Minor_Frame'Last), Tick'Last);
   end Clock_At_Limit;

   procedure Next_Frames is
      type Row is record
         Now, Frame : Tick;
      end record;

      Last_Frame : constant Tick := Last_Tick / 10 * 10;

      Table : constant array (Positive range <>) of Row :=
        ((0, 10), (1, 10), (9, 10), (10, 20), (11, 20), (19, 20),
         (123_456, 123_460), (123_459, 123_460), (123_460, 123_470),

         --  Numbers beyond 16 and 32 bits
         (65_535, 65_540), (65_536, 65_540),
         (2 ** 31 - 1, 2_147_483_650), (2 ** 32, 4_294_967_300),
         (Last_Frame - 1, Last_Frame), (Last_Frame, Last_Frame + 10));
   begin
      for Each of Table loop
         Expect
           ("next frame at" & Each.Now'Image, Next_Frame (Each.Now),
            Each.Frame);
      end loop;
   end Next_Frames;

   procedure Releases is
   begin
      for Now in Tick range 0 .. 100 loop
         for Offset in Minor_Frame loop
            Expect
              ("release at" & Now'Image & ", offset" & Offset'Image,
               Next_Release (Now, Offset),
               (Now / 10 + 1) * 10 + Tick (Offset));
         end loop;
      end loop;
   end Releases;

   procedure One_Frame is
      Release : Tick := 4;
   begin
      --  A task with offset 4 that runs when released returns every 10 ticks,
      --  even if it runs up to the last tick of its frame.
      for Delay_Ticks in Tick range 0 .. 5 loop
         Expect ("release", Release, 4 + 10 * Delay_Ticks);
         Release := Next_Release (Release + Delay_Ticks, 4);
      end loop;
   end One_Frame;

   procedure Times is

      procedure Expect_Time (Name : String; Frames, Milliseconds : Natural);

      procedure Expect_Time (Name : String; Frames, Milliseconds : Natural) is
      begin
         Expect_Number
           (Name & ", in milliseconds",
            Frames * Ticks_Per_Major_Frame * Microseconds_Per_Tick / 1_000,
            Milliseconds);
      end Expect_Time;

      Chosen : constant URV.Link_Loss.Times :=
        Times_Of
          ((Serial => 1, Gains => 0, Orbit_From => 25, End_From => 600));
   begin
      Expect_Time ("holding", Hold_After, 500);
      Expect_Time ("orbiting", Orbit_After, 5_000);
      Expect_Time ("terminated", Terminate_After, 120_000);
      Expect_Time ("the link's return", Return_After, 1_000);
      Expect_Time ("a chosen orbit", Natural (Chosen.Orbit), 2_500);
      Expect_Time ("a chosen end", Natural (Chosen.Terminate_At), 60_000);
      Expect_Time ("a bad sensor", Bad_Scans, 60);
      Expect_Time ("a stuck sensor", Stuck_Scans, 200);
      Expect_Time ("a good sensor", Good_Scans, 1_000);
      Expect_Time ("the altitude's lag", Filter_Frames, 500);
      Expect_Time
        ("a lost console", Natural (URV.Console_Watch.Lost_After), 500);
      Expect_Time
        ("the safe words", Natural (URV.Console_Watch.Safe_After), 2_000);
      Expect_Time ("the engine's failure", URV.Engine_Monitor.Certainty, 500);
      Expect_Time
        ("a surface's failure", Certainty / (Most_Off - Allowance), 100);
      Expect_Time
        ("a session without a block", URV.Seals.Handshake_Lasts, 500);
      Expect_Time
        ("a session's silence", URV.Handshakes.Longest_Silence, 60_000);
      Expect_Number
        ("the hold timer, in microseconds",
         Devices.PWM_Board.Hold_Ticks * Microseconds_Per_Tick, 500_000);
      Expect_Number
        ("the longest wait, in microseconds",
         Integer (URVOS.Waits.Wait_Ticks'Last) * Microseconds_Per_Tick,
         60_000_000);
   end Times;

   procedure Rates is

      procedure Expect_Rate (Name : String; In_A_Frame, In_A_Second : Natural);

      procedure Expect_Rate (Name : String; In_A_Frame, In_A_Second : Natural)
      is
      begin
         Expect_Number
           (Name & ", in a second",
            In_A_Frame
            * (1_000_000 / (Ticks_Per_Major_Frame * Microseconds_Per_Tick)),
            In_A_Second);
      end Expect_Rate;

      --  The rate for a step is rounded down: a slightly slower servo counts
      --  as sound, never the reverse.
      procedure Expect_Servo (Item : Surface; Words_A_Second : Natural);

      procedure Expect_Servo (Item : Surface; Words_A_Second : Natural) is
         Derived : constant Natural :=
           Slowest_Rate (Item) * Steps_Per_Frame * Frames_Per_Second
           / Per_Word;
      begin
         Expect
           (Item'Image & " at most" & Words_A_Second'Image & " and less than"
            & " a fiftieth below, is" & Derived'Image,
            Derived in Words_A_Second * 49 / 50 .. Words_A_Second, True);
      end Expect_Servo;

      --  For a full unit of error.
      Unit : constant := 1_000_000;
   begin
      Expect_Rate ("roll output", Roll_Step, 7_500);
      Expect_Rate ("pitch output", Pitch_Step, 7_500);
      Expect_Rate ("yaw output", Yaw_Step, 5_000);
      Expect_Rate ("throttle output", Throttle_Step, 5_000);
      Expect_Rate ("bank", Bank_Slew, 15_000);
      Expect_Rate ("pitch", Pitch_Slew, 12_000);
      Expect_Rate ("roll trim", Roll_Integral_Gain * 100 / Per_Angle, 400);
      Expect_Rate ("pitch trim", Pitch_Integral_Gain * 100 / Per_Angle, 2_000);
      Expect_Rate
        ("softer roll trim", Soft_Roll_Integral_Gain * Unit / Per_Angle,
         5 * Unit / 2);
      Expect_Rate
        ("altitude trim", Height_Integral_Gain * 1_000 / Per_Climb, 800);
      Expect_Rate
        ("power trim", Speed_Integral_Gain * 100 / Per_Speed, 75_000);
      Expect_Rate
        ("the engine's bounds", URV.Engine_Monitor.Narrowing, 400);
      Expect_Servo (Left_Aileron, 5_000);
      Expect_Servo (Left_Elevator, 4_000);
      Expect_Servo (Left_Rudder, 4_000);
      Expect_Servo (Left_Flap_1, 341);
      Expect
        ("the slowest servo's lag",
         1_000 * Microseconds_Per_Step - Slowest_Share * Slowest_Lag
           in 0 .. 149_999, True);
   end Rates;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "FRM-1 ten minor frames of 2 ms are a major frame of 20 ms",
         Time_Units'Access);
      Add
        (Suite, "FRM-1 the clock advances by one tick a minor frame",
         Advance'Access);
      Add
        (Suite, "FRM-1 the clock stops at its last tick",
         Clock_At_Limit'Access);
      Add
        (Suite, "FRM-3 the next frame begins at the next multiple of ten",
         Next_Frames'Access);
      Add
        (Suite, "FRM-3 a release is the next frame plus the offset",
         Releases'Access);
      Add
        (Suite, "FRM-3 a task is released once a major frame",
         One_Frame'Access);
      Add
        (Suite, "FRM-7 D-75 times in seconds are the same in any frame",
         Times'Access);
      Add
        (Suite, "FRM-7 rates of a second are the same in any frame",
         Rates'Access);
   end Add_To;

end Frames_Tests;
