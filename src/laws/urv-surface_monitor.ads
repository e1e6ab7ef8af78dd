--  SPDX-License-Identifier: Apache-2.0

--  Detects surfaces that do not follow their servos' words (EXT-6, FRM-7).
--  Each frame compares the measured positions with the bounds of every sound
--  servo (URV.Servo_Models).
--
--  Doubt grows by the distance outside the bounds, minus an allowance for the
--  sensor, limited for each frame. It shrinks if the distance is below the
--  allowance. A failure lasts until the next cold start. After a start nothing
--  is known, and the bounds are as wide as possible. docs/surfaces.md has the
--  detection times.

with URVOS;            use URVOS;
with URV.Buffers;      use URV.Buffers;
with URV.Engine_Monitor; use type URV.Engine_Monitor.Monitor;
with URV.Frame_Times;  use URV.Frame_Times;
with URV.Law_Units;    use URV.Law_Units;
with URV.Servo_Models; use URV.Servo_Models;
with URV.Surfaces;     use URV.Surfaces;

package URV.Surface_Monitor with Pure, SPARK_Mode is

   --  The sensor's possible error in words: 0.4 degrees of an aileron.
   Allowance : constant := 40;

   --  The largest distance that counts in a frame, and the doubt that is a
   --  failure: after 0.1 s of a large distance, or 0.24 s of 60 words.
   Most_Off  : constant := 88;
   Certainty : constant := (Most_Off - Allowance) * Frames_Per_Tenth;

   subtype Doubt_Level is Number range 0 .. Certainty;

   --  The frames after a start in which the servos may have words that the
   --  monitor does not know.
   subtype Unknown_Frames is Number range 0 .. 3;

   type Bounds_Table is array (Surface) of Bounds;
   type Doubt_Table is array (Surface) of Doubt_Level
   with Component_Size => 16;

   type Monitor is record
      Ranges : Bounds_Table    := (others => Anywhere);
      Doubts : Doubt_Table     := (others => 0);
      Failed : Surface_Flags   := None;
      Places : Surface_Demands := (others => 0);

      --  The servos' words of the last three frames.
      Sent, Sent_Before, Sent_First : Surface_Demands := (others => 0);

      --  The number of these frames that are unknown.
      Unknown : Unknown_Frames := Unknown_Frames'Last;

      --  The engine's monitor, and the throttle's word of the last frame.
      Engine : Engine_Monitor.Monitor := (others => <>);
      Power  : Lever := 0;
   end record;

   --  The predefined equality as a function. Without it Z3 takes minutes to
   --  read each goal that knows this type.
   function "=" (One, Other : Monitor) return Boolean is
     (One.Ranges = Other.Ranges
      and then One.Doubts = Other.Doubts
      and then One.Failed = Other.Failed
      and then One.Places = Other.Places
      and then One.Sent = Other.Sent
      and then One.Sent_Before = Other.Sent_Before
      and then One.Sent_First = Other.Sent_First
      and then One.Unknown = Other.Unknown
      and then One.Engine = Other.Engine
      and then One.Power = Other.Power)
   with Global => null;

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

   --  The distance of a measured surface from its bounds.
   function Off_Now
     (This : Monitor; Sensors : Downlink_Buffer; Which : Surface)
      return Distance
   is
     (Off
        (Which, Bounds_After (This, Which), Places_Of (Sensors) (Which)))
   with Global => null;

   --  Each surface after the sensors of a frame. Old sensors show nothing.
   function Are_Watched
     (Before, After : Monitor; Sensors : Downlink_Buffer) return Boolean
   is
     (for all Which in Surface =>
        After.Ranges (Which) = Bounds_After (Before, Which)

        --  A failure lasts.
        and then
          (if Before.Failed (Which) then After.Failed (Which))

        --  Only fresh sensors show a failure, and only after an earlier
        --  distance.
        and then
          (if After.Failed (Which) and then not Before.Failed (Which)
           then not Is_Old (Sensors)
             and then Off_Now (Before, Sensors, Which) > Allowance
             and then Before.Doubts (Which) >=
                        Certainty - (Most_Off - Allowance))

        --  The position is the last measured one.
        and then
          After.Places (Which) =
            (if Is_Old (Sensors) then Before.Places (Which)
             else Places_Of (Sensors) (Which))

        --  And then always.
        and then
          (if Is_Old (Sensors)
           then After.Doubts (Which) = Before.Doubts (Which)
           else After.Doubts (Which) =
               Next_Doubt
                 (Before.Doubts (Which), Off_Now (Before, Sensors, Which))
             and then
               (if After.Doubts (Which) = Certainty
                  and then Before.Doubts (Which) < Certainty
                then After.Failed (Which))))
   with Ghost, Global => null;

   --  The monitor after the sensors of a frame.
   procedure Advance (This : in out Monitor; Sensors : Downlink_Buffer)
   with
     Global => null,
     Post   =>
       This.Unknown = This.Unknown'Old
       and then This.Sent = This.Sent'Old
       and then This.Sent_Before = This.Sent_Before'Old
       and then This.Sent_First = This.Sent_First'Old
       and then This.Engine = This.Engine'Old
       and then This.Power = This.Power'Old
       and then Are_Watched (This'Old, This, Sensors);

   --  The same as a function, for theorems and tests.
   function Next (This : Monitor; Sensors : Downlink_Buffer) return Monitor
   with
     Global => null,
     Post   =>
       Next'Result.Unknown = This.Unknown
       and then Next'Result.Sent = This.Sent
       and then Next'Result.Sent_Before = This.Sent_Before
       and then Next'Result.Sent_First = This.Sent_First
       and then Are_Watched (This, Next'Result, Sensors);

   --  The servos get these words in this frame.
   function With_Sent
     (This : Monitor; Sent : Surface_Demands) return Monitor
   is
     ((This with delta
         Sent        => Sent,
         Sent_Before => This.Sent,
         Sent_First  => This.Sent_Before,
         Unknown     => Integer'Max (This.Unknown - 1, 0)))
   with Global => null;

   --  The servos get no words in this frame, and keep theirs.
   function With_None_Sent (This : Monitor) return Monitor is
     ((This with delta
         Sent_Before => This.Sent,
         Sent_First  => This.Sent_Before))
   with Global => null;

   --  The same in place

   procedure Note_Sent (This : in out Monitor; Sent : Surface_Demands)
   with
     Global => null,
     Post   => This = With_Sent (This'Old, Sent);

   procedure Note_None_Sent (This : in out Monitor)
   with
     Global => null,
     Post   => This = With_None_Sent (This'Old);

   --  After unmonitored frames: each surface may be anywhere; known failures
   --  remain.
   function Restarted (This : Monitor) return Monitor is
     ((This with delta
         Ranges  => (others => Anywhere),
         Doubts  => (others => 0),
         Unknown => Unknown_Frames'Last,
         Engine  => Engine_Monitor.Unknown (This.Engine)))
   with Global => null;

   --  A bit for each failed surface, in their order, the first in bit 0.
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

   --  The same, with bit 10 for a throttle that the engine does not follow.
   Throttle_Bit : constant Word := 1_024;

   function Failed_Bits (This : Monitor) return Word is
     (Bits_Of (This.Failed) + (if This.Engine.Failed then Throttle_Bit else 0))
   with Global => null;

end URV.Surface_Monitor;
