--  SPDX-License-Identifier: Apache-2.0

--  Detects an engine that does not follow its throttle (EXT-6, FRM-7, D-32).
--  No sensor measures the throttle's position. The engine drives a fixed
--  propeller, so its speed shows it.
--
--  Two bounds enclose the speeds that the last throttle words demand, with the
--  dead band of the servo. A bound widens to a new demand at once, and narrows
--  more slowly than a sound engine. An engine fails when its speed is outside
--  the bounds by more than the allowance for half a second. The monitor
--  reports nothing on the ground or with invalid sensors, nor before the
--  measured speed has moved. A running engine's speed always varies; a
--  constant word (from the bench, or from an unconnected sensor) shows
--  nothing.

with URV.Frame_Times; use URV.Frame_Times;
with URV.Law_Units;   use URV.Law_Units;

package URV.Engine_Monitor with Pure, SPARK_Mode is

   --  The word of the engine speed at 70 kt for each eighth of the throttle's
   --  travel, for the aircraft of sim/jsbsim.
   subtype Eighth is Number range 0 .. 8;
   Per_Eighth : constant := 512;

   type Speed_Table is array (Eighth) of Level;

   Speeds : constant Speed_Table :=
     (1_140, 1_835, 2_202, 2_465, 2_702, 2_925, 3_140, 3_335, 3_485);

   Cruise    : constant := 2_240;
   Per_Speed : constant := 5;

   function Steady (Power : Lever; Airspeed : Level) return Level is
     (Within
        (Speeds (Power / Per_Eighth)
         + (Speeds (Power / Per_Eighth + 1) - Speeds (Power / Per_Eighth))
           * (Power mod Per_Eighth) / Per_Eighth
         + (Airspeed - Cruise) / Per_Speed,
         0, Level'Last))
   with Global => null;

   --  One per cent of the throttle's travel, in words. The servo may rest that
   --  far on either side of its word.
   Dead_Band : constant := 41;

   --  The engine follows the airspeed as in Steady, or not at all. At idle in
   --  a dive it does not.

   function Least_Asked (Power : Lever; Airspeed : Level) return Level is
     (Steady
        (Integer'Max (Power - Dead_Band, 0),
         Integer'Min (Airspeed, Cruise)))
   with Global => null;

   function Most_Asked (Power : Lever; Airspeed : Level) return Level is
     (Steady
        (Integer'Min (Power + Dead_Band, Lever'Last),
         Integer'Max (Airspeed, Cruise)))
   with Global => null;

   --  The measured speed must move this far, 16 rev/min, to count as a
   --  measurement.
   Movement : constant := 8;

   --  The narrowing of a bound in a second and in a frame: the whole range
   --  takes ten seconds. A sound engine, slowly throttled back in turbulence,
   --  changed by 550 a second.
   Narrowing_Rate : constant := 400;
   Narrowing      : constant := Narrowing_Rate / Frames_Per_Second;

   --  The effect of a hot day, rising air and a poor sensor: 500 rev/min.
   Allowance : constant := 250;

   --  The time outside the bounds before a failure: 0.5 s, in frames.
   Certainty : constant := 5 * Frames_Per_Tenth;

   --  The lowest airspeed at which the engine is monitored: 50 kt.
   Slowest : constant := 1_600;

   subtype Doubt_Level is Number range 0 .. Certainty;

   type Monitor is record
      Least  : Level       := 0;
      Most   : Level       := Level'Last;
      Doubt  : Doubt_Level := 0;
      Failed : Boolean     := False;

      --  The first measured speed, and whether the speed has moved from it.
      Is_Seen   : Boolean := False;
      First     : Level   := 0;
      Has_Moved : Boolean := False;
   end record;

   function Is_Outside (This : Monitor; Speed : Level) return Boolean is
     (Speed < This.Least - Allowance or else Speed > This.Most + Allowance)
   with Global => null;

   --  The bounds after the speeds demanded in this frame.
   function Narrowed
     (This : Monitor; Least_Goal, Most_Goal : Level) return Monitor
   is
     ((This with delta
         Least => Integer'Min
                    (Least_Goal,
                     Integer'Min (This.Least + Narrowing, Level'Last)),
         Most  => Integer'Max
                    (Most_Goal, Integer'Max (This.Most - Narrowing, 0))))
   with Global => null;

   --  Nothing is known of this frame: the bounds are as wide as possible.
   function Unknown (This : Monitor) return Monitor is
     ((This with delta Least => 0, Most => Level'Last, Doubt => 0))
   with Global => null;

   --  After a valid measurement of the speed.
   function Seen (This : Monitor; Speed : Level) return Monitor is
     ((This with delta
         Is_Seen   => True,
         First     => (if This.Is_Seen then This.First else Speed),
         Has_Moved =>
           This.Has_Moved
           or else (This.Is_Seen
                    and then abs (Speed - This.First) >= Movement)))
   with Global => null;

   --  After a frame in flight. An engine whose speed has never moved counts as
   --  sound.
   function Judged
     (This     : Monitor;
      Power    : Lever;
      Speed    : Level;
      Airspeed : Level) return Monitor
   is
     (if not This.Has_Moved or else not Is_Outside (This, Speed)
      then (Narrowed
              (This, Least_Asked (Power, Airspeed),
               Most_Asked (Power, Airspeed)) with delta Doubt => 0)
      else
        (Narrowed
           (This, Least_Asked (Power, Airspeed),
            Most_Asked (Power, Airspeed)) with delta
           Doubt  => Integer'Min (This.Doubt + 1, Certainty),
           Failed => This.Failed or else This.Doubt + 1 >= Certainty))
   with Global => null;

   --  Power is the throttle's word of the last frame.
   function Next
     (This     : Monitor;
      Power    : Lever;
      Speed    : Level;
      Airspeed : Level;
      Is_Known : Boolean) return Monitor
   is
     (if not Is_Known then Unknown (This)
      elsif Airspeed < Slowest then Unknown (Seen (This, Speed))
      else Judged (Seen (This, Speed), Power, Speed, Airspeed))
   with
     Global => null,
     Post   =>
       --  A failure lasts. It appears only after half a second outside the
       --  bounds, with a speed that has moved.
       (if This.Failed then Next'Result.Failed)
       and then
         (if Next'Result.Failed and then not This.Failed
          then Is_Known
            and then Next'Result.Has_Moved
            and then Is_Outside (This, Speed)
            and then This.Doubt >= Certainty - 1);

end URV.Engine_Monitor;
