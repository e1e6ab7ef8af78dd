--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Latency with SPARK_Mode is

   procedure Scans_End_In_Their_Minor_Frame is null;

   procedure A_Downlink_Waits_For_Its_Uplink (Item : Situation) is
   begin
      In_Step_Is_In_Time (Item);
   end A_Downlink_Waits_For_Its_Uplink;

   procedure A_Downlink_Comes_Before_TELIN (Line : Line_Delay) is null;

   procedure In_Step_Both_Are_Bounded (Item : Situation; Line : Line_Delay)
   is
      pragma Unreferenced (Line);
   begin
      In_Step_Is_In_Time (Item);
   end In_Step_Both_Are_Bounded;

end Theorems.Latency;
