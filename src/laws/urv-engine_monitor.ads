--  SPDX-License-Identifier: Apache-2.0

--  Whether the engine follows its throttle (EXT-6). Nothing measures where the
--  throttle is; the speed of the engine, which turns a fixed propeller,
--  tells.
--
--  Two bounds hold the speed that the throttle's last words ask for. They go
--  out to a new one at once, and come in slower than a sound engine does. An
--  engine that is outside of them by more than an allowance for half a second
--  does not follow. On the ground, and with sensors that are not believed,
--  nothing is said.

with URV.Law_Units; use URV.Law_Units;

package URV.Engine_Monitor with Pure, SPARK_Mode is

   --  The word of the engine's speed at 70 kt, for each eighth of the
   --  throttle's travel: of the aircraft of sim/jsbsim.
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

   --  How much a bound comes in a frame: the whole range in ten seconds. A
   --  sound engine, throttled back bit by bit in turbulence, changed by 11.
   Narrowing : constant := 8;

   --  500 rev/min: what a hot day, a hill of air and a poor sensor change.
   Allowance : constant := 250;

   --  Frames.
   Certainty : constant := 25;

   --  50 kt.
   Slowest : constant := 1_600;

   subtype Doubt_Level is Number range 0 .. Certainty;

   type Monitor is record
      Least  : Level       := 0;
      Most   : Level       := Level'Last;
      Doubt  : Doubt_Level := 0;
      Failed : Boolean     := False;
   end record;

   function Is_Outside (This : Monitor; Speed : Level) return Boolean is
     (Speed < This.Least - Allowance or else Speed > This.Most + Allowance)
   with Global => null;

   --  The bounds with the speed that is asked for in this frame.
   function Narrowed (This : Monitor; Goal : Level) return Monitor is
     ((This with delta
         Least => Integer'Min
                    (Goal, Integer'Min (This.Least + Narrowing, Level'Last)),
         Most  => Integer'Max
                    (Goal, Integer'Max (This.Most - Narrowing, 0))))
   with Global => null;

   --  Nothing is known of this frame: the bounds are anywhere.
   function Unknown (This : Monitor) return Monitor is
     ((Least => 0, Most => Level'Last, Doubt => 0, Failed => This.Failed))
   with Global => null;

   --  Power is the throttle's word in the last frame.
   function Next
     (This     : Monitor;
      Power    : Lever;
      Speed    : Level;
      Airspeed : Level;
      Is_Known : Boolean) return Monitor
   is
     (if not Is_Known or else Airspeed < Slowest then Unknown (This)
      elsif not Is_Outside (This, Speed)
      then (Narrowed (This, Steady (Power, Airspeed)) with delta Doubt => 0)
      else
        (Narrowed (This, Steady (Power, Airspeed)) with delta
           Doubt  => Integer'Min (This.Doubt + 1, Certainty),
           Failed => This.Failed or else This.Doubt + 1 >= Certainty))
   with
     Global => null,
     Post   =>
       --  It is not forgotten, and seen only after half a second outside.
       (if This.Failed then Next'Result.Failed)
       and then
         (if Next'Result.Failed and then not This.Failed
          then Is_Known
            and then Is_Outside (This, Speed)
            and then This.Doubt >= Certainty - 1);

end URV.Engine_Monitor;
