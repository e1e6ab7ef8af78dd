--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Surfaces with SPARK_Mode is

   procedure Nothing_Told_Is_Figure_13
     (Commands : Uplink_Buffer; Now : Health; By_Law : Boolean) is null;

   procedure Limits_Are_Kept
     (Commands : Uplink_Buffer; Now : Health; Given : PWM_Buffer) is null;

   procedure Who_Follows_Is_Not_Named
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

   procedure An_Engine_Within_Its_Bounds_Is_Not_Told
     (Item     : URV.Engine_Monitor.Monitor;
      Power    : Lever;
      Speed    : Level;
      Airspeed : Level;
      Is_Known : Boolean) is null;

end Theorems.Surfaces;
