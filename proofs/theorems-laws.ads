--  SPDX-License-Identifier: Apache-2.0

--  The control laws obey the pilot's disconnect at once, keep their rate
--  limits when modes change, keep their authority, never wind up, and follow
--  the link-loss rule exactly (EXT-3, EXT-5, EXT-8). This holds for the code's
--  own functions in the aircraft, for all commands, sensor words and states of
--  the laws, valid or not. It says nothing about the aircraft's motion;
--  flights in simulation test that. The proof of their bodies shows that
--  nothing overflows and each output is in its converter's range.

with URV.Buffers;       use URV.Buffers;
with URV.Integrators;   use URV.Integrators;
with URV.Law_Axes;      use URV.Law_Axes;
with URV.Law_Gains;     use URV.Law_Gains;
with URV.Law_Inputs;    use URV.Law_Inputs;
with URV.Law_Units;     use URV.Law_Units;
with URV.Laws;          use URV.Laws;
with URV.Laws.Frames;   use URV.Laws.Frames;
with URV.Link_Loss;     use URV.Link_Loss;
with URV.PWM_Transform; use URV.PWM_Transform;
with URV.Sensor_Checks; use URV.Sensor_Checks;
with URVOS;             use URVOS;

package Theorems.Laws with SPARK_Mode, Ghost is

   --  With the disconnect switch on, the servos get figure 13's words of the
   --  sticks in the same frame.
   procedure Disconnect_Is_Direct
     (Item     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number;
      Sticks   : Stick_Inputs;
      Extra    : Command_Inputs)
   with
     Global => null,
     Pre    =>
       not Is_Old (Commands) and then Is_On (Commands (Switch_7)),
     Post   =>
       Output
         (Next (Item, Commands, Sensors, By, Table, Sticks, Extra), Commands,
          Sticks) =
         Commands
       and then
         Transform
           (Output
              (Next (Item, Commands, Sensors, By, Table, Sticks, Extra),
               Commands, Sticks)) =
             Transform (Commands);

   --  The first frame of a mode is like any other: an output of a law differs
   --  from the last one by at most the rate limit, whatever flew before.
   procedure A_Change_Of_Mode_Is_Bumpless
     (Item     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number;
      Sticks   : Stick_Inputs;
      Extra    : Command_Inputs;
      After    : Memory)
   with
     Global => null,
     Pre    =>
       After = Next (Item, Commands, Sensors, By, Table, Sticks, Extra),
     Post   =>
       (if not After.Is_Stick (Roll_Axis)
        then abs (After.Last.Roll - Item.Last.Roll) <= Roll_Step)
       and then
         (if not After.Is_Stick (Pitch_Axis)
          then abs (After.Last.Pitch - Item.Last.Pitch) <= Pitch_Step)
       and then
         (if not After.Is_Stick (Yaw_Axis)
          then abs (After.Last.Yaw - Item.Last.Yaw) <= Yaw_Step)
       and then
         (if not After.Is_Stick (Throttle_Axis)
          then abs (After.Last.Throttle - Item.Last.Throttle) <=
                 Throttle_Step);

   --  A law of bank or pitch stays within its authority.
   procedure Authority_Is_Kept
     (Item     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number;
      Sticks   : Stick_Inputs;
      Extra    : Command_Inputs;
      After    : Memory)
   with
     Global => null,
     Pre    =>
       After = Next (Item, Commands, Sensors, By, Table, Sticks, Extra),
     Post   =>
       (if After.Flown.Lateral in Banked
          and then abs Item.Last.Roll <= Roll_Authority
        then abs After.Last.Roll <= Roll_Authority)
       and then
         (if After.Flown.Vertical in Pitched
            and then abs Item.Last.Pitch <= Pitch_Authority
          then abs After.Last.Pitch <= Pitch_Authority);

   --  Rate damping changes a stick's output at most by its authority.
   procedure Damping_Is_Small (Stick : Demand; Extra : URV.Law_Axes.Damping)
   with
     Global => null,
     Post   => abs (Plus (Stick, Extra) - Stick) <= Damping_Authority;

   --  Windup. An integrator whose output is saturated never moves further into
   --  saturation, whatever its state, and never against the sign of its error.
   --  Its type limits its value.
   procedure Saturated_Trims_Never_Wind_Up
     (Roll   : Roll_Trim;
      Pitch  : Pitch_Trim;
      Height : Height_Trim;
      Power  : Power_Trim;
      Error  : Number;
      Output : Saturation;
      By     : Gain)
   with
     Global => null,
     Pre    => Error in -4_095 .. 4_095,
     Post   =>
       Follows (Roll, Next_Roll_Trim (Roll, Error, Output, By),
                Error, Output)
       and then Follows (Pitch, Next_Pitch_Trim (Pitch, Error, Output, By),
                         Error, Output)
       and then Follows (Height, Next_Height_Trim (Height, Error, Output),
                         Error, Output)
       and then Follows (Power, Next_Power_Trim (Power, Error, Output),
                         Error, Output);

   --  Recovery. However far an integrator is wound up, it leaves its limit in
   --  the first frame with an error of the other sign, unless the output is
   --  saturated in that direction too. After the numbers of frames below it
   --  has unwound: roll, pitch and height to zero, power from one end of the
   --  throttle to the other. The errors are at least the largest that it
   --  integrates; 10 kt for the airspeed

   type Error_History is array (Positive range <>) of Number;

   function Frames_For (Distance, Step : Positive) return Positive is
     ((Distance - 1) / Step + 1)
   with Global => null;

   Large_Speed_Error : constant := 10 * 32;

   --  625 frames with table 0, 1,000 with table 1.
   function Roll_Frames (Table : Table_Number) return Positive is
     (Frames_For
        (Roll_Trim_Most,
         Roll_Integrated * Gains_Of (Table).Bank_Integral_Gain / Per_Angle))
   with Global => null;

   --  250 frames with table 0, 500 with table 1.
   function Pitch_Frames (Table : Table_Number) return Positive is
     (Frames_For
        (Pitch_Trim_Most,
         Pitch_Integrated * Gains_Of (Table).Pitch_Integral_Gain / Per_Angle))
   with Global => null;

   --  500 frames.
   function Height_Frames return Positive is
     (Frames_For
        (Height_Trim_Most,
         Height_Integrated * Height_Integral_Gain / Per_Climb))
   with Global => null;

   --  854 frames.
   function Power_Frames return Positive is
     (Frames_For
        (Power_Trim'Last, Large_Speed_Error * Speed_Integral_Gain / Per_Speed))
   with Global => null;

   procedure Roll_Trim_Recovers
     (Start  : Roll_Trim;
      Errors : Error_History;
      Output : Saturation;
      Table  : Table_Number;
      After  : out Roll_Trim)
   with
     Global => null,
     Pre    =>
       Errors'First = 1
       and then Errors'Last = Roll_Frames (Table)
       and then (for all Error of Errors =>
                   Error in -Largest_Bank .. Largest_Bank),
     Post   =>
       (if (for all Error of Errors => Error <= -Roll_Integrated)
          and then not Output.Is_Low
        then After <= 0)
       and then
         (if (for all Error of Errors => Error >= Roll_Integrated)
            and then not Output.Is_High
          then After >= 0);

   procedure Pitch_Trim_Recovers
     (Start  : Pitch_Trim;
      Errors : Error_History;
      Output : Saturation;
      Table  : Table_Number;
      After  : out Pitch_Trim)
   with
     Global => null,
     Pre    =>
       Errors'First = 1
       and then Errors'Last = Pitch_Frames (Table)
       and then (for all Error of Errors =>
                   Error in -Largest_Bank .. Largest_Bank),
     Post   =>
       (if (for all Error of Errors => Error <= -Pitch_Integrated)
          and then not Output.Is_Low
        then After <= 0)
       and then
         (if (for all Error of Errors => Error >= Pitch_Integrated)
            and then not Output.Is_High
          then After >= 0);

   procedure Height_Trim_Recovers
     (Start  : Height_Trim;
      Errors : Error_History;
      Output : Saturation;
      After  : out Height_Trim)
   with
     Global => null,
     Pre    =>
       Errors'First = 1
       and then Errors'Last = Height_Frames
       and then (for all Error of Errors => Error in -40_000 .. 40_000),
     Post   =>
       (if (for all Error of Errors => Error <= -Height_Integrated)
          and then not Output.Is_Low
        then After <= 0)
       and then
         (if (for all Error of Errors => Error >= Height_Integrated)
            and then not Output.Is_High
          then After >= 0);

   procedure Power_Trim_Recovers
     (Start  : Power_Trim;
      Errors : Error_History;
      Output : Saturation;
      After  : out Power_Trim)
   with
     Global => null,
     Pre    =>
       Errors'First = 1
       and then Errors'Last = Power_Frames
       and then (for all Error of Errors => Error in -4_095 .. 4_095),
     Post   =>
       (if (for all Error of Errors => Error <= -Large_Speed_Error)
          and then not Output.Is_Low
        then After = 0)
       and then
         (if (for all Error of Errors => Error >= Large_Speed_Error)
            and then not Output.Is_High
          then After = Power_Trim'Last);

   --  A moving reference reaches its target after at most 400 frames in bank
   --  and 113 in pitch. No integrator waits longer for it

   Bank_Frames          : constant := 2 * Largest_Bank / Bank_Slew;
   Pitch_Command_Frames : constant :=
     (Highest_Pitch - Lowest_Pitch + Pitch_Slew - 1) / Pitch_Slew;

   procedure References_Arrive
     (Bank, Bank_Target   : Bank_Command;
      Pitch, Pitch_Target : Pitch_Command;
      Bank_After          : out Number;
      Pitch_After         : out Number)
   with
     Global => null,
     Post   =>
       Bank_After = Bank_Target
       and then Pitch_After = Pitch_Target
       and then On_The_Way (Bank_After, Bank_Target) = Free
       and then On_The_Way (Pitch_After, Pitch_Target) = Free;

   --  A law flies only with the sensors that it needs.
   procedure Invalid_Sensors_Disengage
     (Item     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number;
      Sticks   : Stick_Inputs;
      Extra    : Command_Inputs;
      After    : Memory)
   with
     Global => null,
     Pre    =>
       After = Next (Item, Commands, Sensors, By, Table, Sticks, Extra),
     Post   =>
       (if not After.Checks (Roll_Rate).Is_Valid
        then After.Flown.Lateral = Direct)
       and then (if not After.Checks (Roll_Attitude).Is_Valid
                 then After.Flown.Lateral not in Banked
                   and then After.Flown.Vertical = Direct)
       and then (if not After.Checks (Pitch_Rate).Is_Valid
                 then After.Flown.Vertical = Direct)
       and then (if not After.Checks (Pitch_Attitude).Is_Valid
                 then After.Flown.Vertical not in Pitched)
       and then (if not After.Checks (Altitude).Is_Valid
                 then After.Flown.Vertical /= Hold_Altitude)
       and then (if not After.Checks (Airspeed).Is_Valid
                 then After.Flown.Power /= Hold_Airspeed);

   --  A sensor that is out of range or without a scan in three frames in a row
   --  is invalid.
   procedure Three_Bad_Scans_Are_Enough
     (Item : Check; One, Two, Three, Witness : Word; By : Rule)
   with
     Global => null,
     Pre    =>
       not Is_In_Range (One, By)
       and then not Is_In_Range (Two, By)
       and then not Is_In_Range (Three, By),
     Post   =>
       not After_Scan
         (After_Scan
            (After_Scan (Item, One, Witness, By), Two, Witness, By),
          Three, Witness, By).Is_Valid
       and then not After_Gap (After_Gap (After_Gap (Item))).Is_Valid;

   --  Loss of link. Counted from the last fresh uplink, each state begins
   --  exactly in the silent frame that the times give

   function State_After (Silent : Frame_Count; By : Times) return Link_State
   is
     (if Silent < By.Hold then Linked
      elsif Silent < By.Orbit then Holding
      elsif Silent < By.Terminate_At then Orbiting
      else Terminated)
   with Global => null;

   procedure Times_Are_Exact
     (Silent : Frame_Count;
      By     : Times;
      After  : out Link_Memory)
   with
     Global => null,
     Post   => After.State = State_After (Silent, By);

   --  No state is skipped, and only the link's own return leads back.
   procedure Nothing_Is_Skipped
     (Item : Link_Memory; Is_Fresh, Disconnect : Boolean; By : Times)
   with
     Global => null,
     Post   =>
       (case Item.State is
           when Waiting    =>
             Next (Item, Is_Fresh, Disconnect, By).State in Waiting | Linked,
           when Linked     =>
             Next (Item, Is_Fresh, Disconnect, By).State in Linked | Holding,
           when Holding    =>
             Next (Item, Is_Fresh, Disconnect, By).State in
               Holding | Orbiting | Linked,
           when Orbiting   =>
             Next (Item, Is_Fresh, Disconnect, By).State in
               Orbiting | Terminated | Linked,
           when Terminated =>
             Next (Item, Is_Fresh, Disconnect, By).State in
               Terminated | Linked);

   --  A lost link is back after one second of fresh uplinks without a gap. If
   --  its count begins at 0, it is not back one frame earlier.
   --  Theorems.Lost_Links shows the cost of gaps.
   procedure A_Second_Brings_It_Back
     (Item : Link_Memory; Fresh : Return_Count; After : out Link_Memory)
   with
     Global => null,
     Pre    => Item.State in Holding | Orbiting,
     Post   =>
       (if Fresh = Return_After then After.State = Linked)
       and then
         (if Item.Fresh = 0 and then Fresh < Return_After
          then After.State = Item.State);

   --  End of termination. Only one kind of frame changes the state: a fresh
   --  uplink with the disconnect switch on that completes a count of 50 such
   --  frames, after a full count of 50 with the switch off.
   procedure Only_The_Order_Ends_Termination
     (Item : Link_Memory; Is_Fresh, Disconnect : Boolean; By : Times)
   with
     Global => null,
     Pre    => Item.State = Terminated,
     Post   =>
       (Next (Item, Is_Fresh, Disconnect, By).State = Linked) =
         (Is_Fresh and then Disconnect
          and then Item.Off = Return_After
          and then Item.On >= Return_After - 1)
       and then
         (Next (Item, Is_Fresh, Disconnect, By).State in
            Linked | Terminated)

       --  A silent frame takes 2 from the present half. The order begins again
       --  if the switch turns on before the first count is full, or turns off
       --  again.
       and then
         (if not Is_Fresh
          then Next (Item, Is_Fresh, Disconnect, By).On =
                 Less_Of_Return (Item.On)
            and then Next (Item, Is_Fresh, Disconnect, By).Off =
                 (if Item.On > 0 then Item.Off
                  else Less_Of_Return (Item.Off)))
       and then
         (if Is_Fresh and then not Disconnect
          then Next (Item, Is_Fresh, Disconnect, By).On = 0
            and then
              (if Item.On > 0
               then Next (Item, Is_Fresh, Disconnect, By).Off = 1))
       and then
         (if Is_Fresh and then Disconnect and then Item.Off < Return_After
          then Next (Item, Is_Fresh, Disconnect, By).Off = 0
            and then Next (Item, Is_Fresh, Disconnect, By).On = 0);

end Theorems.Laws;
