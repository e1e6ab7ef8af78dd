--  SPDX-License-Identifier: Apache-2.0

with URV.Laws.Frames;        use URV.Laws.Frames;
with URVOS.Schedulers.Calls; use URVOS.Schedulers.Calls;

package body Canaries.Mechanisms with SPARK_Mode is

   procedure Ailerons_Go_The_Other_Way
     (Trim      : Roll_Trim;
      Reference : Bank_Command;
      Now       : Readings;
      Output    : Saturation;
      By        : Gain)
   is null;

   procedure Elevators_Go_The_Other_Way
     (Trim      : Pitch_Trim;
      Reference : Pitch_Command;
      Now       : Readings;
      Output    : Saturation;
      By        : Gain)
   is null;

   procedure The_Lever_Goes_The_Other_Way
     (Trim : Power_Trim; Wanted, Airspeed : Level; Output : Saturation)
   is null;

   procedure Pitch_Is_Of_The_Bank
     (Before   : URV.Laws.Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      After    : out URV.Laws.Memory)
   is
   begin
      After := Next (Before, Commands, Sensors, By);
   end Pitch_Is_Of_The_Bank;

   procedure Gaps_Cost_Nothing (Before : Link_Memory; By : Times)
   is null;

   procedure Flaps_Roll_To_Their_Own_Side
     (Wanted : Surface_Demands; Now : Health)
   is null;

   procedure The_Place_Is_That_Of_Before
     (Before  : Monitor;
      Sensors : Downlink_Buffer;
      Which   : Surface;
      After   : out Monitor)
   is
      pragma Unreferenced (Which);
   begin
      After := Next (Before, Sensors);
   end The_Place_Is_That_Of_Before;

   procedure Wake_At_The_Old_Time (S : in out Scheduler; Now : Clock_Tick)
   is
      pragma Unreferenced (Now);
   begin
      Wake (S, Clock (S));
   end Wake_At_The_Old_Time;

   procedure The_Log_Is_Kept (Log : URV.Errors.Error_Log; Kind : Error_Kind)
   is null;

   procedure A_Start_Marks_No_Log
     (CORE : URV.CORE_Memory.Memory; Which : Log_Row_Number)
   is null;

end Canaries.Mechanisms;
