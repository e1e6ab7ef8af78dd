--  SPDX-License-Identifier: Apache-2.0

--  All numbers of the control laws: gains, limits and times (EXT-3, EXT-5).
--  They are for the aircraft of sim/jsbsim, found by flying it.
--  docs/control-laws.md has them in the units of the field.
--
--  A gain is a fraction, so many words for so many units (URV.Law_Units). An
--  integrator counts thousandths of a word.

package URV.Law_Gains with Pure, SPARK_Mode is

   --  The ground chooses a table of gains by its number (EXT-2): 0 is the
   --  usual one, 1 is softer in bank and pitch.

   type Table_Number is range 0 .. 1;

   subtype Gain is Integer range 0 .. 100;

   type Gain_Table is record
      For_Bank, Bank_Learning, For_Pitch, Pitch_Learning : Gain;
   end record;

   --  Times are in major frames of 20 ms.
   Frames_Per_Second : constant := 50;

   --  How far a law moves an output in a frame, in words.
   Roll_Step     : constant := 150;
   Pitch_Step    : constant := 150;
   Yaw_Step      : constant := 100;
   Throttle_Step : constant := 100;

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

   --  Thousandths of a word a frame, for thousandths of a degree.
   Per_Hundred    : constant := 100;
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
   --  how fast it is rolled in; what turns at 3 deg/s, thousandths of a
   --  degree for so many 32nds of a knot.
   Reckoned_Bank : constant := 60_000;
   Most_Bank     : constant := 45_000;
   Bank_Slew     : constant := 300;
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
   --  nose may be, how fast it is moved.
   Level_Pitch   : constant := 2_400;
   Stick_Pitch   : constant := 20_000;
   Highest_Pitch : constant := 15_000;
   Lowest_Pitch  : constant := -12_000;
   Pitch_Slew    : constant := 240;

   --  Altitude: climb in thousandths of a foot a second for half feet; pitch
   --  for it, and for what is missing of it.
   Climb_Gain      : constant := 125;
   Most_Climb      : constant := 10_000;
   Pitch_For_Climb : constant := 18;
   Pitch_For_Lag   : constant := 35;

   --  The altitude's trim of pitch, in tenths of thousandths of a degree: so
   --  many a frame for a climb rate that lacks a foot a second. What it
   --  learns from at most, in thousandths of a foot a second.
   Height_Learning  : constant := 16;
   Height_Learnt    : constant := 10_000;
   Height_Trim_Most : constant := 80_000;

   --  The altitude's filter: thousandths of the difference a frame. The
   --  difference, in thousandths of half feet, is the climb rate, in
   --  thousandths of a foot a second.
   Filter_Share : constant := 40;

   --  A pitch stick no further than this from neutral is at rest.
   Stick_Rest : constant := 100;

   --  Airspeed, in 32nds of a knot: throttle words for it; thousandths of a
   --  word a frame; words for a climb rate. What can be held.
   Speed_Gain      : constant := 6;
   Speed_Learning  : constant := 15;
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

   --  Loss of link.
   Hold_After      : constant := Frames_Per_Second / 2;
   Orbit_After     : constant := 5 * Frames_Per_Second;
   Terminate_After : constant := 120 * Frames_Per_Second;
   Return_After    : constant := Frames_Per_Second;

   --  So many fresh frames does each silent one cost on the way back. With 2
   --  a gap that loses the link clears the count (D-35).
   Silence_Cost    : constant := 2;

   --  Sensors: bad in so many scans one after the other is not valid, good
   --  in so many is valid again.
   Bad_Scans   : constant := 3;
   Good_Scans  : constant := Frames_Per_Second;
   Stuck_Scans : constant := 10;

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
