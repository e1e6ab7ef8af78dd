--  SPDX-License-Identifier: Apache-2.0

--  The units of the control laws. All are whole numbers, so the same words
--  give the same outputs on every machine (EXT-3).
--
--  Angles are in thousandths of a degree, rates in thousandths of a degree a
--  second. Altitude and airspeed keep the units of their words: half a foot,
--  and a 32nd of a knot. A servo's demand is its word minus the neutral word:
--  0.01 degrees of aileron, 0.0125 of elevator and rudder. docs/items.md has
--  the scales of all words.

with URVOS;       use URVOS;
with URV.Buffers; use URV.Buffers;

package URV.Law_Units with Pure, SPARK_Mode is

   --  Wide enough for every sum and product in the laws.
   subtype Number is Integer range -1_000_000_000 .. 1_000_000_000;

   subtype Angle is Number range -180_000 .. 180_000;
   subtype Rate is Number range -103_000 .. 103_000;

   --  Altitude and airspeed in the units of their words.
   subtype Level is Number range 0 .. 4_095;

   --  A word minus the neutral word; the throttle's word.
   subtype Demand is Number range -2_048 .. 2_047;
   subtype Lever is Number range 0 .. 4_095;

   --  The nearest value within two bounds.
   function Within (Value, Least, Most : Number) return Number is
     (if Value < Least then Least elsif Value > Most then Most else Value)
   with
     Global => null,
     Pre    => Least <= Most,
     Post   => Within'Result in Least .. Most
       and then (if Value in Least .. Most then Within'Result = Value);

   --  One step from a value towards another, no longer than a limit.
   function Stepped (From, To, Longest : Number) return Number is
     (if To - From > Longest then From + Longest
      elsif From - To > Longest then From - Longest
      else To)
   with
     Global => null,
     Pre    =>
       From in -200_000 .. 200_000
       and then To in -200_000 .. 200_000
       and then Longest in 0 .. 200_000,
     Post   =>
       Stepped'Result in Integer'Min (From, To) .. Integer'Max (From, To)
       and then abs (Stepped'Result - From) <= Longest
       and then (if abs (To - From) <= Longest then Stepped'Result = To);

   --  Conversion from words. A word beyond the converter's range counts as its
   --  end.

   function Level_Of (Value : Word) return Level is
     (if Value in Converter_Value then Number (Value) else Level'Last)
   with Global => null;

   function Demand_Of (Value : Word) return Demand is
     (Level_Of (Value) - Number (Neutral_Value))
   with Global => null;

   function Roll_Angle_Of (Value : Word) return Angle is
     (Demand_Of (Value) * 45_000 / 512)
   with Global => null;

   function Pitch_Angle_Of (Value : Word) return Angle is
     (Demand_Of (Value) * 45_000 / 1_024)
   with Global => null;

   function Roll_Rate_Of (Value : Word) return Rate is
     (Demand_Of (Value) * 50)
   with Global => null;

   --  Rates of pitch and yaw.
   function Slow_Rate_Of (Value : Word) return Rate is
     (Demand_Of (Value) * 25)
   with Global => null;

   --  Conversion to words

   function Lever_Word_Of (Value : Lever) return Converter_Value is
     (Converter_Value (Value))
   with
     Global => null,
     Post   => Level_Of (Lever_Word_Of'Result) = Value;

   function Word_Of (Value : Demand) return Converter_Value is
     (Lever_Word_Of (Value + Number (Neutral_Value)))
   with
     Global => null,
     Post   => Demand_Of (Word_Of'Result) = Value;

end URV.Law_Units;
