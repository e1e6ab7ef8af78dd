--  SPDX-License-Identifier: Apache-2.0

--  Which surfaces do not follow their servos' words (EXT-6): the measured
--  position is compared with that of a model of the servo, each frame.
--
--  Doubt grows by how much more than an allowance they differ, no more than
--  so much a frame, and shrinks when they differ by less. A surface that has
--  failed stays so until the next cold start. docs/surfaces.md says how well
--  they are told.

with URVOS;            use URVOS;
with URV.Buffers;      use URV.Buffers;
with URV.Engine_Monitor;
with URV.Law_Units;    use URV.Law_Units;
with URV.Routing;      use URV.Routing;
with URV.Servo_Models; use URV.Servo_Models;
with URV.Surfaces;     use URV.Surfaces;

package URV.Surface_Monitor with Pure, SPARK_Mode is

   --  In words: 0.4 degrees of an aileron. A sensor may be off by that much.
   Allowance : constant := 40;

   --  How much of a difference counts in a frame, and the doubt that is a
   --  failure: 0.1 s of a large difference, 0.24 s of one of 60 words.
   Most_Off  : constant := 88;
   Certainty : constant := 240;

   subtype Doubt_Level is Number range 0 .. Certainty;

   --  Frames after a start in which the models are put where the surfaces
   --  are.
   subtype Settling_Count is Number range 0 .. 50;

   type Model_Table is array (Surface) of Model;
   type Doubt_Table is array (Surface) of Doubt_Level;

   type Monitor is record
      Models : Model_Table     := (others => <>);
      Doubts : Doubt_Table     := (others => 0);
      Failed : Surface_Flags   := None;
      Places : Surface_Demands := (others => 0);

      --  What the servos were given in the last three frames.
      Sent, Sent_Before, Sent_First : Surface_Demands := (others => 0);

      Settling : Settling_Count := Settling_Count'Last;

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

   --  Where a model is at a scan: the words that were sent three frames and
   --  two frames ago moved it there.
   function Model_After (This : Monitor; Which : Surface) return Model is
     (Servo_Models.Next
        (Which, This.Models (Which),
         Early => This.Sent_First (Which), Late => This.Sent_Before (Which)))
   with Global => null;

   --  Sensors are in. Old ones tell nothing.
   function Next (This : Monitor; Sensors : Downlink_Buffer) return Monitor
   with
     Global => null,
     Post   =>
       (for all Which in Surface =>
          --  A failure is not forgotten.
          (if This.Failed (Which) then Next'Result.Failed (Which))

          --  It is seen in fresh sensors only, which differ now and did
          --  before.
          and then
            (if Next'Result.Failed (Which) and then not This.Failed (Which)
             then This.Settling = 0
               and then not Is_Old (Sensors)
               and then Off (Model_After (This, Which),
                             Places_Of (Sensors) (Which)) > Allowance
               and then This.Doubts (Which) >=
                          Certainty - (Most_Off - Allowance))

          --  And then always.
          and then
            (if This.Settling = 0 and then not Is_Old (Sensors)
             then Next'Result.Doubts (Which) =
                 Next_Doubt
                   (This.Doubts (Which),
                    Off (Model_After (This, Which),
                         Places_Of (Sensors) (Which)))
               and then
                 (if Next'Result.Doubts (Which) = Certainty
                    and then This.Doubts (Which) < Certainty
                  then Next'Result.Failed (Which))));

   --  What the servos are given in this frame.
   function With_Sent
     (This : Monitor; Sent : Surface_Demands) return Monitor
   is
     ((This with delta
         Sent        => Sent,
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

   --  After frames that nobody watched: the models are put where the surfaces
   --  are anew; what has failed is known still.
   function Restarted (This : Monitor) return Monitor is
     ((This with delta
         Doubts   => (others => 0),
         Settling => Settling_Count'Last,
         Engine   => Engine_Monitor.Unknown (This.Engine)))
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
