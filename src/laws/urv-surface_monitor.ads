--  SPDX-License-Identifier: Apache-2.0

--  Which surfaces do not follow their servos' words (EXT-6, FRM-7): each frame
--  the measured position is compared with the bounds of every sound servo
--  (URV.Servo_Models).
--
--  Doubt grows by the distance outside the bounds, less an allowance for the
--  sensor, limited for each frame; it shrinks when the distance is smaller. A
--  surface that has failed stays so until the next cold start. After a start
--  nothing is known, and the bounds are anywhere. docs/surfaces.md has the
--  times in which failures are identified.

with URVOS;            use URVOS;
with URV.Buffers;      use URV.Buffers;
with URV.Engine_Monitor;
with URV.Frame_Times;  use URV.Frame_Times;
with URV.Law_Units;    use URV.Law_Units;
with URV.Routing;      use URV.Routing;
with URV.Servo_Models; use URV.Servo_Models;
with URV.Surfaces;     use URV.Surfaces;

package URV.Surface_Monitor with Pure, SPARK_Mode is

   --  In words: 0.4 degrees of an aileron. A sensor may be off by that much.
   Allowance : constant := 40;

   --  How much of a distance counts in a frame, and the doubt that is a
   --  failure: 0.1 s of a large distance, 0.24 s of one of 60 words.
   Most_Off  : constant := 88;
   Certainty : constant := (Most_Off - Allowance) * Frames_Per_Tenth;

   subtype Doubt_Level is Number range 0 .. Certainty;

   --  Frames after a start in which the servos may have words that the
   --  monitor does not know.
   subtype Unknown_Frames is Number range 0 .. 3;

   type Bounds_Table is array (Surface) of Bounds;
   type Doubt_Table is array (Surface) of Doubt_Level;

   type Monitor is record
      Ranges : Bounds_Table    := (others => Anywhere);
      Doubts : Doubt_Table     := (others => 0);
      Failed : Surface_Flags   := None;
      Places : Surface_Demands := (others => 0);

      --  What the servos were given in the last three frames.
      Sent, Sent_Before, Sent_First : Surface_Demands := (others => 0);

      --  How many of these frames are not known.
      Unknown : Unknown_Frames := Unknown_Frames'Last;

      --  Of the engine, and what its throttle was given in the last frame.
      Engine : Engine_Monitor.Monitor := (others => <>);
      Power  : Lever := 0;
   end record;

   --  The doubt after a frame.
   function Next_Doubt
     (Doubt : Doubt_Level; Off : Distance) return Doubt_Level
   is
     (Within
        (Doubt + Integer'Min (Off, Most_Off) - Allowance, 0, Certainty))
   with
     Global => null,
     Post   =>
       (if Off <= Allowance then Next_Doubt'Result <= Doubt)
       and then Next_Doubt'Result <= Doubt + Most_Off - Allowance;

   function Words_Of (This : Monitor; Which : Surface) return Word_History is
     ((First  => This.Sent_First (Which),
       Before => This.Sent_Before (Which),
       Last   => This.Sent (Which)))
   with Global => null;

   --  The bounds at this frame's scan.
   function Bounds_After (This : Monitor; Which : Surface) return Bounds is
     (if This.Unknown > 0 then Anywhere
      else After_Frame
        (Which, This.Ranges (Which), Words_Of (This, Which)))
   with Global => null;

   --  How far a surface is measured outside of them.
   function Off_Now
     (This : Monitor; Sensors : Downlink_Buffer; Which : Surface)
      return Distance
   is
     (Off
        (Which, Bounds_After (This, Which), Places_Of (Sensors) (Which)))
   with Global => null;

   --  Sensors are in. Old ones show nothing.
   function Next (This : Monitor; Sensors : Downlink_Buffer) return Monitor
   with
     Global => null,
     Post   =>
       Next'Result.Unknown = This.Unknown
       and then Next'Result.Sent = This.Sent
       and then Next'Result.Sent_Before = This.Sent_Before
       and then Next'Result.Sent_First = This.Sent_First
       and then
         (for all Which in Surface =>
            Next'Result.Ranges (Which) = Bounds_After (This, Which)

            --  A failure is not forgotten.
            and then
              (if This.Failed (Which) then Next'Result.Failed (Which))

            --  It is seen in fresh sensors only, outside the bounds now and
            --  before.
            and then
              (if Next'Result.Failed (Which) and then not This.Failed (Which)
               then not Is_Old (Sensors)
                 and then Off_Now (This, Sensors, Which) > Allowance
                 and then This.Doubts (Which) >=
                            Certainty - (Most_Off - Allowance))

            --  And then always.
            and then
              (if Is_Old (Sensors)
               then Next'Result.Doubts (Which) = This.Doubts (Which)
               else Next'Result.Doubts (Which) =
                   Next_Doubt
                     (This.Doubts (Which), Off_Now (This, Sensors, Which))
                 and then
                   (if Next'Result.Doubts (Which) = Certainty
                      and then This.Doubts (Which) < Certainty
                    then Next'Result.Failed (Which))));

   --  The servos are given these words in this frame.
   function With_Sent
     (This : Monitor; Sent : Surface_Demands) return Monitor
   is
     ((This with delta
         Sent        => Sent,
         Sent_Before => This.Sent,
         Sent_First  => This.Sent_Before,
         Unknown     => Integer'Max (This.Unknown - 1, 0)))
   with Global => null;

   --  The servos are given nothing in this frame, and keep what they have.
   function With_None_Sent (This : Monitor) return Monitor is
     ((This with delta
         Sent_Before => This.Sent,
         Sent_First  => This.Sent_Before))
   with Global => null;

   --  The engine was looked at; its throttle is given Power in this frame.
   function With_Engine
     (This : Monitor; Engine : Engine_Monitor.Monitor; Power : Lever)
      return Monitor
   is
     ((This with delta Engine => Engine, Power => Power))
   with Global => null;

   --  After frames that nobody watched: a surface may be anywhere; one that
   --  has failed is still known.
   function Restarted (This : Monitor) return Monitor is
     ((This with delta
         Ranges  => (others => Anywhere),
         Doubts  => (others => 0),
         Unknown => Unknown_Frames'Last,
         Engine  => Engine_Monitor.Unknown (This.Engine)))
   with Global => null;

   --  A bit for each surface that has failed, in their order, the first in
   --  bit 0.
   function Bits_Of (Failed : Surface_Flags) return Word is
     ((if Failed (Left_Aileron)   then 1   else 0)
      + (if Failed (Right_Aileron)  then 2   else 0)
      + (if Failed (Left_Elevator)  then 4   else 0)
      + (if Failed (Right_Elevator) then 8   else 0)
      + (if Failed (Left_Rudder)    then 16  else 0)
      + (if Failed (Right_Rudder)   then 32  else 0)
      + (if Failed (Left_Flap_1)    then 64  else 0)
      + (if Failed (Right_Flap_1)   then 128 else 0)
      + (if Failed (Left_Flap_2)    then 256 else 0)
      + (if Failed (Right_Flap_2)   then 512 else 0))
   with Global => null;

   --  The same with the throttle, which the engine does not follow, in bit 10.
   Throttle_Bit : constant Word := 1_024;

   function Failed_Bits (This : Monitor) return Word is
     (Bits_Of (This.Failed) + (if This.Engine.Failed then Throttle_Bit else 0))
   with Global => null;

end URV.Surface_Monitor;
