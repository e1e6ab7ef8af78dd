--  SPDX-License-Identifier: Apache-2.0

--  The integrator of every control law (EXT-3, EXT-8), and its protection
--  against windup: conditional integration on sign (D-31).
--
--     Trim := Integrated
--       (Trim, Error_Share (Error, Most_Integrated, Gain, Unit),
--        Saturation_Of (Wanted, -Authority, Authority), -Most, Most);
--
--  An integrator moves with the sign of its error. It stops in one case only:
--  its output, or the next limit in the chain, is saturated, and the error
--  would drive it further into that saturation. A rate limit is not a
--  saturation. A large error never stops an integrator; it moves as for the
--  largest error that it integrates.

with URV.Law_Units; use URV.Law_Units;

package URV.Integrators with Pure, SPARK_Mode is

   --  The limits that an output has reached. Both may hold at once if one
   --  limit in the chain is above another.
   type Saturation is record
      Is_High, Is_Low : Boolean := False;
   end record
   with Alignment => 2;

   Free : constant Saturation := (Is_High => False, Is_Low => False);

   function Saturation_Of (Wanted, Least, Most : Number) return Saturation is
     (Is_High => Wanted > Most, Is_Low => Wanted < Least)
   with Global => null;

   --  A reference that still moves to its target leads the aircraft by the
   --  aircraft's lag. No integrator should remove this error. The reference
   --  reaches its target, so this state ends.
   function On_The_Way (Reference, Target : Number) return Saturation is
     (Is_High => Target > Reference, Is_Low => Target < Reference)
   with Global => null;

   --  The saturation of two limits in series.
   function "or" (Left, Right : Saturation) return Saturation is
     (Is_High => Left.Is_High or else Right.Is_High,
      Is_Low  => Left.Is_Low or else Right.Is_Low)
   with Global => null;

   --  The error would drive the output further into saturation.
   function Is_Held (Change : Number; Output : Saturation) return Boolean is
     ((Change > 0 and then Output.Is_High)
      or else (Change < 0 and then Output.Is_Low))
   with Global => null;

   subtype Error_Range is Number range -200_000 .. 200_000;
   subtype Gain_Range is Integer range 0 .. 1_000;

   --  An integrator's change in a frame: Gain for each Unit of the error, and
   --  no more than for the error Most. For a gain per second, Unit contains
   --  the frames of a second as a factor.
   function Error_Share
     (Error : Error_Range;
      Most  : Error_Range;
      Gain  : Gain_Range;
      Unit  : Positive) return Number
   is
     (Within (Error, -Most, Most) * Gain / Unit)
   with
     Global => null,
     Pre    => Most >= 0 and then Unit <= 10_000,
     Post   =>
       (if Error >= 0 then Error_Share'Result >= 0)
       and then (if Error <= 0 then Error_Share'Result <= 0)
       and then abs Error_Share'Result <= Most * Gain;

   --  The integrator after a frame, within its own limits.
   function Integrated
     (Item   : Number;
      Change : Number;
      Output : Saturation;
      Least  : Number;
      Most   : Number) return Number
   is
     (if Is_Held (Change, Output) then Item
      else Within (Item + Change, Least, Most))
   with
     Global => null,
     Pre    =>
       Item in Least .. Most
       and then Least in -400_000_000 .. 400_000_000
       and then Most in -400_000_000 .. 400_000_000
       and then Change in -100_000_000 .. 100_000_000,
     Post   =>
       Integrated'Result in Least .. Most

       --  Never further into saturation.
       and then (if Is_Held (Change, Output)
                 then Integrated'Result = Item)

       --  Never against its error.
       and then (if Change >= 0 then Integrated'Result >= Item)
       and then (if Change <= 0 then Integrated'Result <= Item)

       --  Otherwise it moves with its error, by the whole change or to its own
       --  limit.
       and then
         (if Change > 0 and then not Output.Is_High
          then Integrated'Result = Integer'Min (Item + Change, Most))
       and then
         (if Change < 0 and then not Output.Is_Low
          then Integrated'Result = Integer'Max (Item + Change, Least));

   --  Every integrator's step from Before to After has this property: never
   --  against the sign of the error, never further into saturation.
   function Follows
     (Before, After, Error : Number; Output : Saturation) return Boolean
   is
     ((if Error >= 0 then After >= Before)
      and then (if Error <= 0 then After <= Before)
      and then (if Error > 0 and then Output.Is_High then After = Before)
      and then (if Error < 0 and then Output.Is_Low then After = Before))
   with Ghost, Global => null;

   --  An integrator never moves away from its demand, as measured. All outputs
   --  of the laws have one sign: a larger output makes a larger measurement.
   function Moves_With (Before, After, Wanted, Measured : Number)
                        return Boolean
   is
     ((if Measured <= Wanted then After >= Before)
      and then (if Measured >= Wanted then After <= Before))
   with Ghost, Global => null;

   --  The error is large enough to count.
   function Moves
     (Error : Error_Range; Gain : Gain_Range; Unit : Positive)
      return Boolean
   is
     (abs Error * Gain >= Unit)
   with Ghost, Global => null;

end URV.Integrators;
