--  SPDX-License-Identifier: Apache-2.0

--  The flight software never reports a sound servo as failed, reports within
--  half a second any surface that is half a degree of an aileron outside its
--  bounds, and sends no sound surface beyond its stops (EXT-6). This holds for
--  all commands, sensor words and servos within the limits of
--  URV.Servo_Models, with sensor errors up to the allowance. The engine's
--  monitor has similar theorems. How well the remaining surfaces fly the
--  aircraft is not proved but flown in simulation. The proof of their bodies
--  shows that nothing overflows.

with URV.Allocation;      use URV.Allocation;
with URV.Buffers;         use URV.Buffers;
with URV.Engine_Monitor;
with URV.Law_Units;       use URV.Law_Units;
with URV.PWM_Transform;   use URV.PWM_Transform;
with URV.Servo_Models;    use URV.Servo_Models;
with URV.Surface_Monitor; use URV.Surface_Monitor;
with URV.Surfaces;        use URV.Surfaces;
with URVOS;               use URVOS;

package Theorems.Surfaces with SPARK_Mode, Ghost is

   --  Unless a surface was reported as failed and a law flies, the servos get
   --  figure 13's words, bit for bit.
   procedure Nothing_Reported_Is_Figure_13
     (Commands : Uplink_Buffer; Now : Health; By_Law : Boolean)
   with
     Global => null,
     Pre    => Now.Failed = None or else not By_Law,
     Post   =>
       Servos (Commands, Reported_Health (Now, By_Law)) = Transform (Commands);

   --  For any failures: the words are in the converter's range, no sound
   --  surface is sent beyond its stops, and failed surfaces and other outputs
   --  get figure 13's words.
   procedure Limits_Are_Kept
     (Commands : Uplink_Buffer; Now : Health; Given : PWM_Buffer)
   with
     Global => null,
     Pre    => Now.Failed /= None and then Given = Servos (Commands, Now),
     Post   =>
       (for all Item in Servo_Item => Given (Item) in Converter_Value)
       and then
         (for all Item in Surface =>
            (if Now.Failed (Item)
             then Demand_Of (Given (Servo_Of (Item))) =
                 Demand_Of (Transform (Commands) (Servo_Of (Item)))
             else Demand_Of (Given (Servo_Of (Item))) in
                    Lowest (Item) .. Highest (Item)))
       and then Given (Steering) = Transform (Commands) (Steering)
       and then Given (Throttle) = Transform (Commands) (Throttle)
       and then Given (Brake) = Transform (Commands) (Brake)
       and then Given (Discretes) = Transform (Commands) (Discretes);

   --  A servo of any design: Lagged is its filtered word, and Place its
   --  surface's position.
   type Servo is record
      Lagged, Place : Fine := 0;
   end record;

   --  In a step Lagged covers at least the slowest sound servo's share of the
   --  distance to the goal, and stops at the goal.
   function Has_Followed (From, To, Goal : Fine) return Boolean is
     (if From >= Goal then To in Goal .. From - Part_Of (From - Goal)
      else To in From + Part_Of (Goal - From) .. Goal)
   with Global => null;

   --  The surface follows it, at least at the slowest rate limit, and no
   --  further.
   function Has_Moved (From, To, Goal : Fine; Slowest : Rate_Limit)
                       return Boolean
   is
     (if From >= Goal
      then To in Goal .. Integer'Max (Goal, From - Slowest)
      else To in Integer'Min (Goal, From + Slowest) .. Goal)
   with Global => null;

   --  A step of a sound servo: a lag of 0 to 0.15 s, and a rate limit of at
   --  least the slowest, or none. Both may differ in every step.
   function Is_Sound_Step
     (Before, After : Servo; Goal : Fine; Slowest : Rate_Limit)
      return Boolean
   is
     (Has_Followed (Before.Lagged, After.Lagged, Goal)
      and then Has_Moved (Before.Place, After.Place, After.Lagged, Slowest))
   with Global => null;

   function Is_Within (Item : Servo; Range_Of : Bounds) return Boolean is
     (Item.Lagged in Range_Of.Least .. Range_Of.Most
      and then Item.Place in Range_Of.Least .. Range_Of.Most)
   with Global => null;

   --  The bounds contain the servo in every step, for any goal within the dead
   --  band around one of its words.
   procedure A_Sound_Servo_Stays_Within
     (Before, After : Servo;
      Range_Of      : Bounds;
      Goals         : Bounds;
      Goal          : Fine;
      Slowest       : Rate_Limit)
   with
     Global => null,
     Pre    =>
       Goals.Least <= Goals.Most
       and then Goal in Goals.Least .. Goals.Most
       and then Is_Within (Before, Range_Of)
       and then Is_Sound_Step (Before, After, Goal, Slowest),
     Post   => Is_Within (After, After_Step (Range_Of, Goals, Slowest));

   --  From scan to scan: the servo and its goal, step by step.
   type Servo_Steps is array (0 .. Steps_Per_Frame) of Servo;
   type Goal_Steps is array (1 .. Steps_Per_Frame) of Fine;

   --  A frame of a sound servo. In every step its word is one of the last
   --  three, followed within the dead band, beyond a stop or not.
   function Is_Sound_Frame
     (Item  : Monitor;
      Which : Surface;
      Steps : Servo_Steps;
      Goals : Goal_Steps) return Boolean
   is
     (for all Step in Goals'Range =>
        Goals (Step) in
          Goals_Of (Which, Words_Of (Item, Which)).Least ..
          Goals_Of (Which, Words_Of (Item, Which)).Most
        and then Is_Sound_Step
          (Steps (Step - 1), Steps (Step), Goals (Step),
           Slowest_Rate (Which)))
   with Global => null;

   --  The measured position is that of the servo, or the stop that it is
   --  beyond, with the sensor's error within the allowance.
   function Is_Measured
     (Which : Surface; Place : Fine; Measured : Demand) return Boolean
   is
     (Measured * Per_Word in
        Integer'Min (Place, At_Stops (Which, Place)) - Allowance * Per_Word ..
        Integer'Max (Place, At_Stops (Which, Place)) + Allowance * Per_Word)
   with Global => null;

   --  EXT-6, D-32: a sound servo is never reported as failed. If it is within
   --  its bounds at one scan, it is at the next, the doubt does not grow, and
   --  it is not reported, for all commands and all words of other sensors.
   --  While words are unknown it may be anywhere.
   procedure A_Sound_Servo_Is_Never_Reported
     (Item    : Monitor;
      Which   : Surface;
      Steps   : Servo_Steps;
      Goals   : Goal_Steps;
      Sensors : Downlink_Buffer)
   with
     Global => null,
     Pre    =>
       not Item.Failed (Which)
       and then
         (Item.Unknown > 0
          or else (Is_Within (Steps (0), Item.Ranges (Which))
                   and then Is_Sound_Frame (Item, Which, Steps, Goals)))
       and then Is_Measured
         (Which, Steps (Steps_Per_Frame).Place, Places_Of (Sensors) (Which)),
     Post   =>
       Is_Within
         (Steps (Steps_Per_Frame), Next (Item, Sensors).Ranges (Which))
       and then Next (Item, Sensors).Doubts (Which) <= Item.Doubts (Which)
       and then not Next (Item, Sensors).Failed (Which);

   --  The induction begins here: after a cold or warm start every servo is
   --  within the bounds, and no words sent put it outside.
   procedure A_Start_Holds_Every_Servo
     (Item  : Monitor;
      Which : Surface;
      Any   : Servo;
      Sent  : Surface_Demands)
   with
     Global => null,
     Post   =>
       Is_Within (Any, Monitor'(others => <>).Ranges (Which))
       and then Is_Within (Any, Restarted (Item).Ranges (Which))
       and then Restarted (Item).Unknown = Unknown_Frames'Last
       and then With_Sent (Item, Sent).Ranges = Item.Ranges
       and then With_None_Sent (Item).Ranges = Item.Ranges;

   --  A surface within the bounds and the allowance is not reported. Old
   --  sensors report no surface, nor does any frame with unknown words.
   procedure A_Surface_That_Follows_Is_Not_Reported
     (Item : Monitor; Sensors : Downlink_Buffer; Which : Surface)
   with
     Global => null,
     Pre    =>
       not Item.Failed (Which)
       and then
         (Is_Old (Sensors)
          or else Item.Unknown > 0
          or else Off_Now (Item, Sensors, Which) <= Allowance),
     Post   => not Next (Item, Sensors).Failed (Which);

   --  A reported failure remains after every frame and warm start.
   procedure A_Failure_Is_Not_Forgotten
     (Item : Monitor; Sensors : Downlink_Buffer; Which : Surface)
   with
     Global => null,
     Pre    => Item.Failed (Which),
     Post   =>
       Next (Item, Sensors).Failed (Which)
       and then Restarted (Item).Failed (Which);

   --  Half a degree of an aileron outside the bounds in each of 24 scans, 0.48
   --  s, gives certainty, from any doubt.
   Seen_Off : constant := 50;
   Enough   : constant :=
     URV.Surface_Monitor.Certainty / (Seen_Off - Allowance);
   type Distances is array (1 .. Enough) of Distance;

   procedure Half_A_Second_Is_Certainty
     (Before : Doubt_Level; Off : Distances; After : out Doubt_Level)
   with
     Global => null,
     Pre    => (for all Each of Off => Each >= Seen_Off),
     Post   => After = Certainty;

   --  Certainty gives the report in the same frame.
   procedure Certainty_Is_Named
     (Item : Monitor; Sensors : Downlink_Buffer; Which : Surface)
   with
     Global => null,
     Pre    =>
       not Is_Old (Sensors)
       and then Next_Doubt
         (Item.Doubts (Which), Off_Now (Item, Sensors, Which)) = Certainty
       and then
         (if Item.Doubts (Which) = Certainty then Item.Failed (Which)),
     Post   => Next (Item, Sensors).Failed (Which);

   --  An engine within its bounds, or in an unknown state, is not reported. An
   --  engine whose speed has never moved is not reported, nor one outside for
   --  less than half a second. A failure lasts.
   procedure An_Engine_Within_Its_Bounds_Is_Not_Reported
     (Item     : URV.Engine_Monitor.Monitor;
      Power    : Lever;
      Speed    : Level;
      Airspeed : Level;
      Is_Known : Boolean)
   with
     Global => null,
     Post   =>
       (if Item.Failed
        then URV.Engine_Monitor.Next
          (Item, Power, Speed, Airspeed, Is_Known).Failed
        elsif not Is_Known
          or else not URV.Engine_Monitor.Is_Outside (Item, Speed)
          or else not URV.Engine_Monitor.Seen (Item, Speed).Has_Moved
          or else Item.Doubt < URV.Engine_Monitor.Certainty - 1
        then not URV.Engine_Monitor.Next
          (Item, Power, Speed, Airspeed, Is_Known).Failed);

   --  The bounds of the next frame contain the speed demanded at any throttle
   --  position within its dead band, and every speed between the old bounds
   --  and there.
   procedure A_Sound_Throttle_Is_Within
     (Item     : URV.Engine_Monitor.Monitor;
      Power    : Lever;
      Speed    : Level;
      Airspeed : Level)
   with
     Global => null,
     Post   =>
       (declare
          After : constant URV.Engine_Monitor.Monitor :=
            URV.Engine_Monitor.Judged (Item, Power, Speed, Airspeed);
        begin
          After.Least <=
            URV.Engine_Monitor.Least_Asked (Power, Airspeed)
          and then After.Most >=
            URV.Engine_Monitor.Most_Asked (Power, Airspeed)
          and then After.Least <= Item.Least + URV.Engine_Monitor.Narrowing
          and then After.Most >= Item.Most - URV.Engine_Monitor.Narrowing);

end Theorems.Surfaces;
