--  SPDX-License-Identifier: Apache-2.0

--  Where a sound servo has its surface: it follows with a lag of 0.1 s, no
--  faster than its rate limit, between the linkage's stops (EXT-6). The
--  numbers are those of the aircraft of sim/jsbsim.
--
--  The servos get new words at minor frame 2 and the sensors are scanned as
--  the next frame begins: 16 ms later. So of a frame from scan to scan the
--  first 4 ms are flown with the words of before.

with URV.Law_Units; use URV.Law_Units;
with URV.Surfaces;  use URV.Surfaces;

package URV.Servo_Models with Pure, SPARK_Mode is

   --  In 64ths of a word.
   Per_Word : constant := 64;
   subtype Fine is Number range -2_048 * Per_Word .. 2_048 * Per_Word;

   --  Where the lag has come to, and the surface, which is no faster than
   --  its rate limit.
   type Model is record
      Lagged, Place : Fine := 0;
   end record;

   --  The lag's share in a step of 4 ms, in thousandths.
   Share : constant := 39;

   --  As far as a surface gets in a frame: 100 deg/s, 5 deg/s for a flap.
   subtype Way is Number range 0 .. 20_000;

   function Way_Of (Item : Surface) return Way is
     (case Item is
         when Left_Aileron | Right_Aileron => 200 * Per_Word,
         when Left_Elevator | Right_Elevator
            | Left_Rudder | Right_Rudder   => 160 * Per_Word,
         when Flap                         => 1_365 * Per_Word / 100)
   with Global => null;

   function Lagged_After (From, Goal : Fine) return Fine is
     (Within
        (From + (Goal - From) * Share / 1_000, Fine'First, Fine'Last))
   with Global => null;

   --  A step of 4 ms: shorter than a frame, for a servo at its rate limit
   --  that is turned back.
   function Advanced
     (This : Model; Goal : Demand; Longest : Way) return Model
   is
     (Lagged => Lagged_After (This.Lagged, Goal * Per_Word),
      Place  => Stepped
        (This.Place, Lagged_After (This.Lagged, Goal * Per_Word), Longest))
   with
     Global => null,
     Post   => abs (Advanced'Result.Place - This.Place) <= Longest;

   function Advanced_Twice
     (This : Model; Goal : Demand; Longest : Way) return Model
   is
     (Advanced (Advanced (This, Goal, Longest), Goal, Longest))
   with
     Global => null,
     Post   =>
       abs (Advanced_Twice'Result.Place - This.Place) <= 2 * Longest;

   --  From one scan to the next.
   function Next
     (Which : Surface; This : Model; Early, Late : Demand) return Model
   is
     (Advanced_Twice
        (Advanced_Twice
           (Advanced
              (This, Reachable (Which, Early), Way_Of (Which) / 5),
            Reachable (Which, Late), Way_Of (Which) / 5),
         Reachable (Which, Late), Way_Of (Which) / 5))
   with
     Global => null,
     Post   => abs (Next'Result.Place - This.Place) <= Way_Of (Which);

   function At_Rest (Place : Demand) return Model is
     (Lagged | Place => Place * Per_Word)
   with Global => null;

   --  How far the measured place is from the model's, in words.
   subtype Distance is Number range 0 .. 4_096;

   function Off (This : Model; Measured : Demand) return Distance is
     (abs (Measured * Per_Word - This.Place) / Per_Word)
   with Global => null;

end URV.Servo_Models;
