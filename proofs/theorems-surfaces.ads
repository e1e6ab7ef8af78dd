--  SPDX-License-Identifier: Apache-2.0

--  What is done about surfaces that fail, and when it is not (EXT-6),
--  whatever the commands and the sensors. They are about the code's own
--  functions; that nothing in them overflows is proved with their bodies.

with URV.Allocation;      use URV.Allocation;
with URV.Buffers;         use URV.Buffers;
with URV.Engine_Monitor;
with URV.Law_Units;       use URV.Law_Units;
with URV.PWM_Transform;   use URV.PWM_Transform;
with URV.Routing;         use URV.Routing;
with URV.Servo_Models;    use URV.Servo_Models;
with URV.Surface_Monitor; use URV.Surface_Monitor;
with URV.Surfaces;        use URV.Surfaces;
with URVOS;               use URVOS;

package Theorems.Surfaces with SPARK_Mode, Ghost is

   --  Unless a surface was told to have failed, and unless a law flies, the
   --  servos get what figure 13 makes of the commands, bit for bit.
   procedure Nothing_Told_Is_Figure_13
     (Commands : Uplink_Buffer; Now : Health; By_Law : Boolean)
   with
     Global => null,
     Pre    => Now.Failed = None or else not By_Law,
     Post   =>
       Servos (Commands, Told_Of (Now, By_Law)) = Transform (Commands);

   --  Whatever has failed: the words are in the converter's range, no surface
   --  that is well is sent beyond its stops, one that has failed gets what
   --  figure 13 says, and so does what is no surface.
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

   --  A surface that is where its model is, within the allowance, is not
   --  named; nor is any by sensors that are old, or just after a start.
   procedure Who_Follows_Is_Not_Named
     (Item : Monitor; Sensors : Downlink_Buffer; Which : Surface)
   with
     Global => null,
     Pre    =>
       not Item.Failed (Which)
       and then
         (Is_Old (Sensors)
          or else Item.Settling > 0
          or else Off (Model_After (Item, Which),
                       Places_Of (Sensors) (Which)) <= Allowance),
     Post   => not Next (Item, Sensors).Failed (Which);

   --  Who was named is so after every frame and after a warm start.
   procedure A_Failure_Is_Not_Forgotten
     (Item : Monitor; Sensors : Downlink_Buffer; Which : Surface)
   with
     Global => null,
     Pre    => Item.Failed (Which),
     Post   =>
       Next (Item, Sensors).Failed (Which)
       and then Restarted (Item).Failed (Which);

   --  Half a degree of an aileron in each of 24 scans, 0.48 s, is certainty,
   --  however little doubt there was.
   Seen_Off : constant := 50;
   Enough   : constant := 24;
   type Distances is array (1 .. Enough) of Distance;

   procedure Half_A_Second_Is_Certainty
     (Before : Doubt_Level; Off : Distances; After : out Doubt_Level)
   with
     Global => null,
     Pre    => (for all Each of Off => Each >= Seen_Off),
     Post   => After = Certainty;

   --  With certainty comes the name, in the same frame.
   procedure Certainty_Is_Named
     (Item : Monitor; Sensors : Downlink_Buffer; Which : Surface)
   with
     Global => null,
     Pre    =>
       not Is_Old (Sensors)
       and then Item.Settling = 0
       and then Next_Doubt
         (Item.Doubts (Which),
          Off (Model_After (Item, Which), Places_Of (Sensors) (Which))) =
            Certainty
       and then
         (if Item.Doubts (Which) = Certainty then Item.Failed (Which)),
     Post   => Next (Item, Sensors).Failed (Which);

   --  An engine within its bounds, or of which nothing is known, is not told;
   --  nor one that has not been outside for half a second. None is forgotten.
   procedure An_Engine_Within_Its_Bounds_Is_Not_Told
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
          or else Item.Doubt < URV.Engine_Monitor.Certainty - 1
        then not URV.Engine_Monitor.Next
          (Item, Power, Speed, Airspeed, Is_Known).Failed);

end Theorems.Surfaces;
