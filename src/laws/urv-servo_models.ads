--  SPDX-License-Identifier: Apache-2.0

--  The positions of a surface with a sound servo (EXT-6, FRM-7, D-32), as a
--  range between two bounds.
--
--  A servo follows its word with a lag, within its rate limit, and rests
--  within a dead band around the word. The aircraft's servos have a lag of 0.1
--  s and the rates below. No real servo behaves exactly so; the bounds
--  therefore rely on no single servo model. They widen at once to a new word,
--  like the fastest servo. They narrow like the slowest sound servo, with half
--  as much lag again and half the rate. Theorems.Surfaces proves that they
--  contain every servo between these.
--
--  The schedule decides which word a servo has at a scan. The bounds therefore
--  allow for every word of the last three frames.

with URV.Frame_Times; use URV.Frame_Times;
with URV.Law_Units;   use URV.Law_Units;
with URV.Surfaces;    use URV.Surfaces;

package URV.Servo_Models with Pure, SPARK_Mode is

   --  Positions in 64ths of a word, including a dead band beyond the words'
   --  range.
   Per_Word : constant := 64;
   subtype Fine is Number range -2_100 * Per_Word .. 2_100 * Per_Word;

   type Bounds is record
      Least, Most : Fine;
   end record;

   Anywhere : constant Bounds := (Least => Fine'First, Most => Fine'Last);

   --  A frame has five steps, of 4 ms in a frame of 20 ms.
   Steps_Per_Frame       : constant := 5;
   Microseconds_Per_Step : constant :=
     Microseconds_Per_Frame / Steps_Per_Frame;

   --  The share of its way that the slowest sound servo makes in a step, in
   --  thousandths, rounded down: a lag of 0.15 s.
   Slowest_Lag   : constant := 150_000;
   Slowest_Share : constant := 1_000 * Microseconds_Per_Step / Slowest_Lag;

   function Part_Of (Distance : Number) return Number is
     (Distance * Slowest_Share / 1_000)
   with
     Global => null,
     Pre    => Distance in 0 .. Fine'Last - Fine'First,
     Post   => Part_Of'Result in 0 .. Distance;

   --  The rate limit of the slowest sound servo, in words a second: 50 deg/s,
   --  and 2.5 deg/s for a flap.
   Slowest_Aileron : constant := 5_000;
   Slowest_Tail    : constant := 4_000;
   Slowest_Flap    : constant := 341;

   --  The limits for a step, rounded down.
   Per_Step : constant := 1_000_000 / Per_Word;
   subtype Rate_Limit is Number range
     1 .. Slowest_Aileron * Microseconds_Per_Step / Per_Step;

   Far_Factor : constant :=
     (1_000 + Slowest_Share - 1) / Slowest_Share + Steps_Per_Frame - 1;

   function Slowest_Rate (Item : Surface) return Rate_Limit is
     (case Item is
         when Left_Aileron | Right_Aileron =>
           Slowest_Aileron * Microseconds_Per_Step / Per_Step,
         when Left_Elevator | Right_Elevator
            | Left_Rudder | Right_Rudder   =>
           Slowest_Tail * Microseconds_Per_Step / Per_Step,
         when Flap                         =>
           Slowest_Flap * Microseconds_Per_Step / Per_Step)
   with Global => null;

   --  From this distance on a servo moves at its rate limit in each step of a
   --  frame.
   function Far_From (Item : Surface) return Number is
     (Far_Factor * Slowest_Rate (Item))
   with Global => null;

   --  The movement of the slowest sound servo in a step: its share of the
   --  distance, within its rate limit. A 68000 divides slowly, so the share is
   --  a product of 16 by 16 bits and a shift. A distance of more than 16 bits
   --  is always limited.

   Longest_Short : constant := 2 ** 16 - 1;
   type Short_Distance is range 0 .. Longest_Short
   with Size => 16;

   Least_Moving : constant := (1_000 + Slowest_Share - 1) / Slowest_Share;
   Factor       : constant := 27_263;
   Divisor      : constant := 2 ** 20 * 26 / Slowest_Share;

   pragma Compile_Time_Error
     (Factor * 1_000 < Slowest_Share * Divisor
        or else (Factor * 1_000 - Slowest_Share * Divisor) * Longest_Short
                  >= (2 - Slowest_Share mod 2) * Divisor
        or else Longest_Short * Slowest_Share / 1_000 < Rate_Limit'Last
        or else Far_Factor * Rate_Limit'Last > Longest_Short,
      "the product is not the slowest servo's share for this frame");

   function Share_Of (Distance : Short_Distance) return Number is
     (Integer (Distance) * Factor / Divisor)
   with
     Global => null,
     Post   => Share_Of'Result = Part_Of (Integer (Distance));

   function Movement (Distance : Number; Slowest : Rate_Limit) return Number
   is
     (if Distance < Least_Moving then 0
      elsif Distance > Longest_Short then Slowest
      else Integer'Min (Slowest, Share_Of (Short_Distance (Distance))))
   with
     Global => null,
     Pre    => Distance in 0 .. Fine'Last - Fine'First,
     Post   => Movement'Result = Integer'Min (Slowest, Part_Of (Distance));

   --  One per cent of the travel, in words. A servo may rest that far on
   --  either side of its word.
   function Dead_Band (Item : Surface) return Demand is
     (if Item in Flap then 21 else 40)
   with Global => null;

   --  The words that a servo may have had from one scan to the next.
   type Word_History is record
      First, Before, Last : Demand := 0;
   end record;

   --  The range to which these words may send a sound servo. A servo may or
   --  may not follow a word beyond the linkage's stop.

   function Goals_Of (Which : Surface; Words : Word_History) return Bounds is
     (Least => Per_Word *
        (Integer'Min
           (Integer'Min (Words.First, Integer'Min (Words.Before, Words.Last)),
            Highest (Which))
         - Dead_Band (Which)),
      Most  => Per_Word *
        (Integer'Max
           (Integer'Max (Words.First, Integer'Max (Words.Before, Words.Last)),
            Lowest (Which))
         + Dead_Band (Which)))
   with
     Global => null,
     Post   =>
       Goals_Of'Result.Least <= Goals_Of'Result.Most

       --  The same, word by word.
       and then Goals_Of'Result.Least = Per_Word *
         (Integer'Min
            (Integer'Min
               (Integer'Min (Words.First, Reachable (Which, Words.First)),
                Integer'Min (Words.Before, Reachable (Which, Words.Before))),
             Integer'Min (Words.Last, Reachable (Which, Words.Last)))
          - Dead_Band (Which))
       and then Goals_Of'Result.Most = Per_Word *
         (Integer'Max
            (Integer'Max
               (Integer'Max (Words.First, Reachable (Which, Words.First)),
                Integer'Max (Words.Before, Reachable (Which, Words.Before))),
             Integer'Max (Words.Last, Reachable (Which, Words.Last)))
          + Dead_Band (Which));

   --  The distance that is left after a step, and after two steps.

   function Left (Distance : Number; Slowest : Rate_Limit) return Number is
     (Distance - Movement (Distance, Slowest))
   with
     Global => null,
     Pre    => Distance in 0 .. Fine'Last - Fine'First,
     Post   => Left'Result in 0 .. Distance;

   function Left_After_Two
     (Distance : Number; Slowest : Rate_Limit) return Number
   is
     (Left (Left (Distance, Slowest), Slowest))
   with
     Global => null,
     Pre    => Distance in 0 .. Fine'Last - Fine'First,
     Post   => Left_After_Two'Result in 0 .. Distance;

   --  A bound after a step: it widens to the goal at once, or narrows towards
   --  it. The upper bound is the lower one of a mirrored servo

   function Least_After
     (From, Goal : Fine; Slowest : Rate_Limit) return Fine
   is
     (if Goal <= From then Goal else Goal - Left (Goal - From, Slowest))
   with
     Global => null,
     Post   => Least_After'Result in Integer'Min (From, Goal) .. Goal;

   function Most_After
     (From, Goal : Fine; Slowest : Rate_Limit) return Fine
   is
     (-Least_After (-From, -Goal, Slowest))
   with
     Global => null,
     Post   => Most_After'Result in Goal .. Integer'Max (From, Goal);

   function After_Step
     (From, Goals : Bounds; Slowest : Rate_Limit) return Bounds
   is
     (Least => Least_After (From.Least, Goals.Least, Slowest),
      Most  => Most_After (From.Most, Goals.Most, Slowest))
   with Global => null;

   --  The same after two steps

   function Least_After_Two
     (From, Goal : Fine; Slowest : Rate_Limit) return Fine
   is
     (Least_After (Least_After (From, Goal, Slowest), Goal, Slowest))
   with
     Global => null,
     Post   =>
       Least_After_Two'Result =
         (if Goal <= From then Goal
          else Goal - Left_After_Two (Goal - From, Slowest));

   function Most_After_Two
     (From, Goal : Fine; Slowest : Rate_Limit) return Fine
   is
     (-Least_After_Two (-From, -Goal, Slowest))
   with
     Global => null,
     Post   =>
       Most_After_Two'Result =
         Most_After (Most_After (From, Goal, Slowest), Goal, Slowest);

   --  The distance that is left after the five steps of a frame

   function Left_After_Five
     (Distance : Short_Distance; Slowest : Rate_Limit) return Short_Distance
   with
     Global => null,
     Post   =>
       Left_After_Five'Result <= Distance
       and then
         Integer (Left_After_Five'Result) =
           Left
             (Left_After_Two
                (Left_After_Two (Integer (Distance), Slowest), Slowest),
              Slowest);

   function Left_After_Frame
     (Distance : Number; Which : Surface) return Number
   is
     (if Distance < Least_Moving then Distance
      elsif Distance >= Far_From (Which)
      then Distance - Steps_Per_Frame * Slowest_Rate (Which)
      else Integer
        (Left_After_Five
           (Short_Distance (Distance), Slowest_Rate (Which))))
   with
     Global => null,
     Pre    => Distance in 0 .. Fine'Last - Fine'First,
     Post   =>
       Left_After_Frame'Result in 0 .. Distance
       and then
         Left_After_Frame'Result =
           Left
             (Left_After_Two
                (Left_After_Two (Distance, Slowest_Rate (Which)),
                 Slowest_Rate (Which)),
              Slowest_Rate (Which));

   --  The bounds at the next scan

   function Least_After_Frame
     (From, Goal : Fine; Which : Surface) return Fine
   is
     (if Goal <= From then Goal
      else Goal - Left_After_Frame (Goal - From, Which))
   with
     Global => null,
     Post   =>
       Least_After_Frame'Result = Least_After
         (Least_After_Two
            (Least_After_Two (From, Goal, Slowest_Rate (Which)),
             Goal, Slowest_Rate (Which)),
          Goal, Slowest_Rate (Which));

   function Most_After_Frame
     (From, Goal : Fine; Which : Surface) return Fine
   is
     (-Least_After_Frame (-From, -Goal, Which))
   with
     Global => null,
     Post   =>
       Most_After_Frame'Result = Most_After
         (Most_After_Two
            (Most_After_Two (From, Goal, Slowest_Rate (Which)),
             Goal, Slowest_Rate (Which)),
          Goal, Slowest_Rate (Which));

   function After_Frame
     (Which : Surface; From : Bounds; Words : Word_History) return Bounds
   is
     (Least => Least_After_Frame
        (From.Least, Goals_Of (Which, Words).Least, Which),
      Most  => Most_After_Frame
        (From.Most, Goals_Of (Which, Words).Most, Which))
   with Global => null;

   --  The distance of a measured position from the bounds, in words; 0 within
   --  them. A surface at its stop is measured there, even if its servo would
   --  go further.
   subtype Distance is Number range 0 .. 4_200;

   function At_Stops (Which : Surface; Place : Fine) return Fine is
     (Within (Place, Per_Word * Lowest (Which), Per_Word * Highest (Which)))
   with Global => null;

   function Off
     (Which : Surface; Item : Bounds; Measured : Demand) return Distance
   is
     (Integer'Max
        (0,
         Integer'Max
           (Measured * Per_Word
            - Integer'Max (Item.Most, Per_Word * Lowest (Which)),
            Integer'Min (Item.Least, Per_Word * Highest (Which))
            - Measured * Per_Word))
      / Per_Word)
   with
     Global => null,
     Post   =>
       Off'Result =
         Integer'Max
           (0,
            Integer'Max
              (Measured * Per_Word
               - Integer'Max (Item.Most, At_Stops (Which, Item.Most)),
               Integer'Min (Item.Least, At_Stops (Which, Item.Least))
               - Measured * Per_Word))
         / Per_Word;

end URV.Servo_Models;
