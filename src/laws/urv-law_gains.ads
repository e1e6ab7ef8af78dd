--  SPDX-License-Identifier: Apache-2.0

--  All numbers of the control laws: gains, limits and times (EXT-3, EXT-5).
--  They were tuned in flights of the aircraft of sim/jsbsim.
--  docs/control-laws.md gives them in the field's units.
--
--  A gain is a fraction: output words per input units (URV.Law_Units). An
--  integrator counts thousandths of a word.
--
--  Rates are per second and times in seconds. The values per frame are derived
--  from them (FRM-7, D-75). A frame that makes them fractional, or that is
--  longer than the design's, does not compile.

with URV.Frame_Times; use URV.Frame_Times;

package URV.Law_Gains with Pure, SPARK_Mode is

   --  The ground selects a table of gains by number (EXT-2): 0 is the usual
   --  table, 1 is softer in bank and pitch.

   type Table_Number is range 0 .. 1;

   subtype Gain is Integer range 0 .. 100;

   type Gain_Table is record
      For_Bank, Bank_Integral_Gain, For_Pitch, Pitch_Integral_Gain : Gain;
   end record;

   --  The rate limits of the laws' outputs, in words a second.
   Roll_Rate_Limit     : constant := 7_500;
   Pitch_Rate_Limit    : constant := 7_500;
   Yaw_Rate_Limit      : constant := 5_000;
   Throttle_Rate_Limit : constant := 5_000;

   --  The same limits for a frame.
   Roll_Step     : constant := Roll_Rate_Limit / Frames_Per_Second;
   Pitch_Step    : constant := Pitch_Rate_Limit / Frames_Per_Second;
   Yaw_Step      : constant := Yaw_Rate_Limit / Frames_Per_Second;
   Throttle_Step : constant := Throttle_Rate_Limit / Frames_Per_Second;

   --  The largest surface demand of a law, from neutral, and the largest
   --  change by rate damping, from the stick.
   Roll_Authority    : constant := 1_200;
   Pitch_Authority   : constant := 1_200;
   Damping_Authority : constant := 400;

   --  The largest rudder demand of a law while the link is lost.
   Held_Yaw : constant := 250;

   --  Words for thousandths of a degree, or of a degree a second.
   Per_Thousand  : constant := 1_000;
   Roll_Damping  : constant := 3;
   Pitch_Damping : constant := 12;
   Yaw_Damping   : constant := 8;
   Roll_Gain     : constant := 22;
   Pitch_Gain    : constant := 35;

   --  Integrator gains: thousandths of a word a second for each 2 thousandths
   --  of a degree. An integrator moves once a frame, so the divisor contains
   --  the frames of a second.
   Per_Hundred         : constant := 100;
   Per_Angle           : constant := 2 * Frames_Per_Second;
   Roll_Integral_Gain  : constant := 8;
   Pitch_Integral_Gain : constant := 40;

   --  The same gains in the softer table.
   Soft_Roll_Gain           : constant := 16;
   Soft_Roll_Integral_Gain  : constant := 5;
   Soft_Pitch_Gain          : constant := 28;
   Soft_Pitch_Integral_Gain : constant := 20;

   --  The limits of the integrators, in thousandths of a word, and the largest
   --  errors that they integrate, in thousandths of a degree.
   Roll_Trim_Most   : constant := 300_000;
   Pitch_Trim_Most  : constant := 600_000;
   Roll_Integrated  : constant := 6_000;
   Pitch_Integrated : constant := 6_000;

   --  The pitch integrator starts from the last output, up to this limit.
   First_Pitch_Trim : constant := 200;

   --  Bank: the limit of the laws' computations; the demand of a full stick;
   --  the roll-in rate, 15 deg/s; the bank for a turn at 3 deg/s, in
   --  thousandths of a degree for 100 32nds of a knot.
   Largest_Bank  : constant := 60_000;
   Most_Bank     : constant := 45_000;
   Bank_Rate     : constant := 15_000;
   Bank_Slew     : constant := Bank_Rate / Frames_Per_Second;
   Orbit_Bank    : constant := 491;
   Orbit_Fastest : constant := 95 * 32;

   --  A level turn: the yaw rate for bank is 0.23 deg/s a degree, exact at 83
   --  kt. Pitch rate and load factor follow the square of the bank in tenths
   --  of a degree, at 70 kt.
   Turn_For_Bank   : constant := 2_300;
   Tenths          : constant := 100;
   Square_Per_Rate : constant := 21;
   Square_Per_Load : constant := 657;

   --  Lift in a turn: elevator and pitch for thousandths of load factor above
   --  one.
   Per_Ten         : constant := 10;
   Stick_For_Load  : constant := 6;
   Pitch_For_Load  : constant := 63;

   --  Pitch: in level flight; the demand of a full stick; the highest and
   --  lowest pitch; the rate of the reference, 12 deg/s.
   Level_Pitch        : constant := 2_400;
   Stick_Pitch        : constant := 20_000;
   Highest_Pitch      : constant := 15_000;
   Lowest_Pitch       : constant := -12_000;
   Pitch_Command_Rate : constant := 12_000;
   Pitch_Slew         : constant := Pitch_Command_Rate / Frames_Per_Second;

   --  Altitude: the climb rate in thousandths of a foot a second for half feet
   --  of error; the pitch for the climb rate, and for its deficit.
   Climb_Gain      : constant := 125;
   Most_Climb      : constant := 10_000;
   Pitch_For_Climb : constant := 18;
   Pitch_For_Lag   : constant := 35;

   --  The altitude law's integrator of pitch, in tenths of thousandths of a
   --  degree: its gain for a climb rate that lacks 0.02 ft/s, and the largest
   --  error that it integrates, in thousandths of a foot a second.
   Per_Climb            : constant := 20 * Frames_Per_Second;
   Height_Integral_Gain : constant := 16;
   Height_Integrated    : constant := 10_000;
   Height_Trim_Most     : constant := 80_000;

   --  The altitude filter has a lag of 0.5 s. The difference to the filtered
   --  altitude, in thousandths of half feet, is therefore the climb rate in
   --  thousandths of a foot a second.
   Filter_Frames : constant := 5 * Frames_Per_Tenth;

   --  A pitch stick within this distance of neutral is at rest.
   Stick_Rest : constant := 100;

   --  Airspeed, in 32nds of a knot: throttle words for it; integrator gain in
   --  thousandths of a word a second; words for a climb rate; the lowest and
   --  highest speed that can be held.
   Per_Speed           : constant := Frames_Per_Second;
   Speed_Gain          : constant := 6;
   Speed_Integral_Gain : constant := 750;
   Speed_For_Climb     : constant := 120;
   Least_Speed         : constant := 60 * 32;
   Most_Speed          : constant := 95 * 32;

   --  32nds of a knot for ten words of the throttle lever.
   Speed_For_Lever : constant := 4;

   --  Below this speed a law lowers the nose by this gain for each 32nd.
   Guarded_Speed : constant := 58 * 32;
   Guard_Gain    : constant := 50;

   --  The glide: its speed, the pitch at that speed, and the pitch for each
   --  32nd.
   Glide_Speed : constant := 65 * 32;
   Glide_Pitch : constant := -2_000;
   Glide_Gain  : constant := 20;

   --  Below both values, the height in half feet, the aircraft is on the
   --  ground.
   Flying_Speed  : constant := 42 * 32;
   Flying_Height : constant := 100;

   --  Loss of link: 0.5 s, 5 s and 120 s, and 1 s for its return.
   Hold_After      : constant := 5 * Frames_Per_Tenth;
   Orbit_After     : constant := 5 * Frames_Per_Second;
   Terminate_After : constant := 120 * Frames_Per_Second;
   Return_After    : constant := Frames_Per_Second;

   --  The fresh frames that each silent frame costs during the link's return.
   --  With 2, a gap that loses the link clears the count (D-35).
   Silence_Cost    : constant := 2;

   --  Sensors: bad for 0.06 s or stuck for 0.2 s is invalid; good for 1 s is
   --  valid again. Each frame has one scan.
   Bad_Scans   : constant := 60_000 / Microseconds_Per_Frame;
   Good_Scans  : constant := Frames_Per_Second;
   Stuck_Scans : constant := 2 * Frames_Per_Tenth;

   --  No step of a law is rounded
   pragma Compile_Time_Error
     (Roll_Step * Frames_Per_Second /= Roll_Rate_Limit
        or else Pitch_Step * Frames_Per_Second /= Pitch_Rate_Limit
        or else Yaw_Step * Frames_Per_Second /= Yaw_Rate_Limit
        or else Throttle_Step * Frames_Per_Second /= Throttle_Rate_Limit
        or else Bank_Slew * Frames_Per_Second /= Bank_Rate
        or else Pitch_Slew * Frames_Per_Second /= Pitch_Command_Rate
        or else Bad_Scans * Microseconds_Per_Frame /= 60_000,
      "a step of the control laws is no whole number for this frame: "
      & "its rate in URV.Law_Gains needs a new design");

   --  A loop has a delay of two frames. A longer delay reduces its margin.
   Longest_Frame : constant := 20_000;

   pragma Compile_Time_Error
     (Microseconds_Per_Frame > Longest_Frame,
      "the gains of URV.Law_Gains are designed for frames of 20 ms or less: "
      & "longer frames need new ones");

   --  The tables
   function Gains_Of (Table : Table_Number) return Gain_Table is
     (case Table is
         when 0 =>
           (For_Bank       => Roll_Gain,
            Bank_Integral_Gain  => Roll_Integral_Gain,
            For_Pitch      => Pitch_Gain,
            Pitch_Integral_Gain => Law_Gains.Pitch_Integral_Gain),
         when 1 =>
           (For_Bank       => Soft_Roll_Gain,
            Bank_Integral_Gain  => Soft_Roll_Integral_Gain,
            For_Pitch      => Soft_Pitch_Gain,
            Pitch_Integral_Gain => Soft_Pitch_Integral_Gain))
   with Global => null;

end URV.Law_Gains;
