--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Surfaces with SPARK_Mode is

   procedure Nothing_Reported_Is_Figure_13
     (Commands : Uplink_Buffer; Now : Health; By_Law : Boolean) is null;

   procedure Limits_Are_Kept
     (Commands : Uplink_Buffer; Now : Health; Given : PWM_Buffer) is null;

   procedure A_Sound_Servo_Stays_Within
     (Before, After : Servo;
      Range_Of      : Bounds;
      Goals         : Bounds;
      Goal          : Fine;
      Slowest       : Rate_Limit) is null;

   procedure A_Sound_Servo_Is_Never_Reported
     (Item    : Monitor;
      Which   : Surface;
      Steps   : Servo_Steps;
      Goals   : Goal_Steps;
      Sensors : Downlink_Buffer)
   is
      Asked   : constant Bounds := Goals_Of (Which, Words_Of (Item, Which));
      Slowest : constant Rate_Limit := Slowest_Rate (Which);
      Held    : Bounds := Item.Ranges (Which);
   begin
      if Item.Unknown = 0 then
         A_Sound_Servo_Stays_Within
           (Steps (0), Steps (1), Held, Asked, Goals (1), Slowest);
         Held := After_Step (Held, Asked, Slowest);
         A_Sound_Servo_Stays_Within
           (Steps (1), Steps (2), Held, Asked, Goals (2), Slowest);
         Held := After_Step (Held, Asked, Slowest);
         A_Sound_Servo_Stays_Within
           (Steps (2), Steps (3), Held, Asked, Goals (3), Slowest);
         Held := After_Step (Held, Asked, Slowest);
         A_Sound_Servo_Stays_Within
           (Steps (3), Steps (4), Held, Asked, Goals (4), Slowest);
         Held := After_Step (Held, Asked, Slowest);
         A_Sound_Servo_Stays_Within
           (Steps (4), Steps (5), Held, Asked, Goals (5), Slowest);
         Held := After_Step (Held, Asked, Slowest);
      else
         Held := Anywhere;
      end if;
      pragma Assert (Held = Bounds_After (Item, Which));
      pragma Assert (Off_Now (Item, Sensors, Which) <= Allowance);
   end A_Sound_Servo_Is_Never_Reported;

   procedure A_Start_Holds_Every_Servo
     (Item  : Monitor;
      Which : Surface;
      Any   : Servo;
      Sent  : Surface_Demands) is null;

   procedure A_Surface_That_Follows_Is_Not_Reported
     (Item : Monitor; Sensors : Downlink_Buffer; Which : Surface) is null;

   procedure A_Failure_Is_Not_Forgotten
     (Item : Monitor; Sensors : Downlink_Buffer; Which : Surface) is null;

   procedure Half_A_Second_Is_Certainty
     (Before : Doubt_Level; Off : Distances; After : out Doubt_Level)
   is
   begin
      After := Before;
      for Scan in Off'Range loop
         After := Next_Doubt (After, Off (Scan));
         pragma Loop_Invariant (After >= Scan * (Seen_Off - Allowance));
      end loop;
   end Half_A_Second_Is_Certainty;

   procedure Certainty_Is_Named
     (Item : Monitor; Sensors : Downlink_Buffer; Which : Surface) is null;

   procedure An_Engine_Within_Its_Bounds_Is_Not_Reported
     (Item     : URV.Engine_Monitor.Monitor;
      Power    : Lever;
      Speed    : Level;
      Airspeed : Level;
      Is_Known : Boolean) is null;

   procedure A_Sound_Throttle_Is_Within
     (Item     : URV.Engine_Monitor.Monitor;
      Power    : Lever;
      Speed    : Level;
      Airspeed : Level) is null;

end Theorems.Surfaces;
