--  SPDX-License-Identifier: Apache-2.0

--  All numbers of the control laws: gains, limits and times (EXT-3, EXT-5).
--  They are for the aircraft of sim/jsbsim, found by flying it.
--  docs/control-laws.md has them in the units of the field.
--
--  A gain is a fraction, so many words for so many units (URV.Law_Units). An
--  integrator counts thousandths of a word.
--
--  Rates are for a second and times in seconds. Those for a frame are derived
--  from them (FRM-7, D-75). A frame for which they are not whole numbers, or
--  that is longer than the one they were designed for, does not compile.

with URV.Frame_Times; use URV.Frame_Times;

package URV.Law_Gains with Pure, SPARK_Mode is

   --  The ground chooses a table of gains by its number (EXT-2): 0 is the
   --  usual one, 1 is softer in bank and pitch.

   type Table_Number is range 0 .. 1;

   subtype Gain is Integer range 0 .. 100;

   type Gain_Table is record
      For_Bank, Bank_Learning, For_Pitch, Pitch_Learning : Gain;
   end record;

   --  How fast a law moves an output, in words a second.
   Roll_Rate_Limit     : constant := 7_500;
   Pitch_Rate_Limit    : constant := 7_500;
   Yaw_Rate_Limit      : constant := 5_000;
   Throttle_Rate_Limit : constant := 5_000;

   --  And how far in a frame.
   Roll_Step     : constant := Roll_Rate_Limit / Frames_Per_Second;
   Pitch_Step    : constant := Pitch_Rate_Limit / Frames_Per_Second;
   Yaw_Step      : constant := Yaw_Rate_Limit / Frames_Per_Second;
   Throttle_Step : constant := Throttle_Rate_Limit / Frames_Per_Second;

   --  How far from neutral a law holds a surface; how far from the stick
   --  rate damping moves one.
   Roll_Authority    : constant := 1_200;
   Pitch_Authority   : constant := 1_200;
   Damping_Authority : constant := 400;

   --  A law that has lost the link uses the rudder no further than this.
   Held_Yaw : constant := 250;

   --  Words for thousandths of a degree, or of a degree a second.
   Per_Thousand  : constant := 1_000;
   Roll_Damping  : constant := 3;
   Pitch_Damping : constant := 12;
   Yaw_Damping   : constant := 8;
   Roll_Gain     : constant := 22;
   Pitch_Gain    : constant := 35;

   --  Thousandths of a word a second, for each 2 thousandths of a degree. An
   --  integrator moves once a frame: the error's divisor has the frames of a
   --  second.
   Per_Hundred    : constant := 100;
   Per_Angle      : constant := 2 * Frames_Per_Second;
   Roll_Learning  : constant := 8;
   Pitch_Learning : constant := 40;

   --  The same of the softer table.
   Soft_Roll_Gain      : constant := 16;
   Soft_Roll_Learning  : constant := 5;
   Soft_Pitch_Gain     : constant := 28;
   Soft_Pitch_Learning : constant := 20;

   --  What an integrator may hold: thousandths of a word. From an error
   --  beyond the next, in thousandths of a degree, it learns as from that.
   Roll_Trim_Most  : constant := 300_000;
   Pitch_Trim_Most : constant := 600_000;
   Roll_Learnt     : constant := 6_000;
   Pitch_Learnt    : constant := 6_000;

   --  The trim that pitch begins with is the last output, up to this.
   First_Pitch_Trim : constant := 200;

   --  Bank: how much the laws reckon with; what the stick's end asks for;
   --  how fast it is rolled in, 15 deg/s; what turns at 3 deg/s, thousandths
   --  of a degree for so many 32nds of a knot.
   Reckoned_Bank : constant := 60_000;
   Most_Bank     : constant := 45_000;
   Bank_Rate     : constant := 15_000;
   Bank_Slew     : constant := Bank_Rate / Frames_Per_Second;
   Orbit_Bank    : constant := 491;
   Orbit_Fastest : constant := 95 * 32;

   --  A level turn: yaw rate for bank, 0.23 deg/s a degree, which is true of
   --  83 kt; pitch rate and load factor for the square of the bank in tenths
   --  of a degree, at 70 kt.
   Turn_For_Bank   : constant := 2_300;
   Per_Ten_Thousand : constant := 10_000;
   Tenths          : constant := 100;
   Square_Per_Rate : constant := 21;
   Square_Per_Load : constant := 657;

   --  Turning needs lift: elevator and pitch for thousandths of load factor
   --  above one.
   Per_Ten         : constant := 10;
   Stick_For_Load  : constant := 6;
   Pitch_For_Load  : constant := 63;

   --  Pitch: level flight, what the stick's end adds, how high and low the
   --  nose may be, how fast it is moved, 12 deg/s.
   Level_Pitch   : constant := 2_400;
   Stick_Pitch   : constant := 20_000;
   Highest_Pitch : constant := 15_000;
   Lowest_Pitch  : constant := -12_000;
   Nose_Rate     : constant := 12_000;
   Pitch_Slew    : constant := Nose_Rate / Frames_Per_Second;

   --  Altitude: climb in thousandths of a foot a second for half feet; pitch
   --  for it, and for what is missing of it.
   Climb_Gain      : constant := 125;
   Most_Climb      : constant := 10_000;
   Pitch_For_Climb : constant := 18;
   Pitch_For_Lag   : constant := 35;

   --  The altitude's trim of pitch, in tenths of thousandths of a degree: so
   --  many a second for a climb rate that lacks 0.02 ft/s. What it learns
   --  from at most, in thousandths of a foot a second.
   Per_Climb        : constant := 20 * Frames_Per_Second;
   Height_Learning  : constant := 16;
   Height_Learnt    : constant := 10_000;
   Height_Trim_Most : constant := 80_000;

   --  The altitude's filter has a lag of 0.5 s. So the difference, in
   --  thousandths of half feet, is the climb rate, in thousandths of a foot a
   --  second.
   Filter_Frames : constant := 5 * Frames_Per_Tenth;

   --  A pitch stick no further than this from neutral is at rest.
   Stick_Rest : constant := 100;

   --  Airspeed, in 32nds of a knot: throttle words for it; thousandths of a
   --  word a second; words for a climb rate. What can be held.
   Per_Speed       : constant := Frames_Per_Second;
   Speed_Gain      : constant := 6;
   Speed_Learning  : constant := 750;
   Speed_For_Climb : constant := 120;
   Least_Speed     : constant := 60 * 32;
   Most_Speed      : constant := 95 * 32;

   --  32nds of a knot for words of the throttle's lever.
   Speed_For_Lever : constant := 4;

   --  Below this speed a law lowers the nose, so much for each 32nd.
   Guarded_Speed : constant := 58 * 32;
   Guard_Gain    : constant := 50;

   --  The glide: its speed, its pitch there, the pitch for each 32nd.
   Glide_Speed : constant := 65 * 32;
   Glide_Pitch : constant := -2_000;
   Glide_Gain  : constant := 20;

   --  Slower than this and lower than that, in half feet, it is not flying.
   Flying_Speed  : constant := 42 * 32;
   Flying_Height : constant := 100;

   --  Loss of link: 0.5 s, 5 s, 120 s, and 1 s for its return.
   Hold_After      : constant := 5 * Frames_Per_Tenth;
   Orbit_After     : constant := 5 * Frames_Per_Second;
   Terminate_After : constant := 120 * Frames_Per_Second;
   Return_After    : constant := Frames_Per_Second;

   --  So many fresh frames does each silent one cost on the way back. With 2
   --  a gap that loses the link clears the count (D-35).
   Silence_Cost    : constant := 2;

   --  Sensors: bad for 0.06 s is not valid, as is stuck for 0.2 s; good for
   --  1 s is valid again. There is a scan in each frame.
   Bad_Scans   : constant := 60_000 / Microseconds_Per_Frame;
   Good_Scans  : constant := Frames_Per_Second;
   Stuck_Scans : constant := 2 * Frames_Per_Tenth;

   --  No step of a law is rounded.
   pragma Compile_Time_Error
     (Roll_Step * Frames_Per_Second /= Roll_Rate_Limit
        or else Pitch_Step * Frames_Per_Second /= Pitch_Rate_Limit
        or else Yaw_Step * Frames_Per_Second /= Yaw_Rate_Limit
        or else Throttle_Step * Frames_Per_Second /= Throttle_Rate_Limit
        or else Bank_Slew * Frames_Per_Second /= Bank_Rate
        or else Pitch_Slew * Frames_Per_Second /= Nose_Rate
        or else Bad_Scans * Microseconds_Per_Frame /= 60_000,
      "a step of the control laws is no whole number for this frame: "
      & "its rate in URV.Law_Gains needs a new design");

   --  A loop has a delay of two frames. A longer one takes margin away.
   Longest_Frame : constant := 20_000;

   pragma Compile_Time_Error
     (Microseconds_Per_Frame > Longest_Frame,
      "the gains of URV.Law_Gains are designed for frames of 20 ms or less: "
      & "longer frames need new ones");

   --  The tables.
   function Gains_Of (Table : Table_Number) return Gain_Table is
     (case Table is
         when 0 =>
           (For_Bank       => Roll_Gain,
            Bank_Learning  => Roll_Learning,
            For_Pitch      => Pitch_Gain,
            Pitch_Learning => Law_Gains.Pitch_Learning),
         when 1 =>
           (For_Bank       => Soft_Roll_Gain,
            Bank_Learning  => Soft_Roll_Learning,
            For_Pitch      => Soft_Pitch_Gain,
            Pitch_Learning => Soft_Pitch_Learning))
   with Global => null;

end URV.Law_Gains;
