--  SPDX-License-Identifier: Apache-2.0

--  Simulated timers. Before each access an event of Simulated_Line ends the
--  period of a timer that counts.

with Simulated_Line;

package body STM32_PWM.Registers with SPARK_Mode => Off is

   --  At first the timers count, with wrong values.
   Timers : array (Timer_Name) of Timer_Model :=
     (others =>
        (Settings => (Counts => True, Reload_Is_Saved => False),
         Modes    =>
           (others =>
              (First_Is_Saved | Second_Is_Saved => False,
               First | Second                   => Frozen)),
         Switches => No_Output,
         Written  =>
           (Prescaler => 7, Reload => 99, Compare => (others => 50)),
         In_Use   =>
           (Prescaler => 0, Reload => 9, Compare => (others => 5))));

   procedure Advance (Timer : Timer_Name);

   procedure Advance (Timer : Timer_Name) is
      This   : Timer_Model renames Timers (Timer);
      Events : Simulated_Line.Event_Count;
   begin
      Simulated_Line.Begin_Access (Events);
      if Events > 0 and then This.Settings.Counts then
         This := Updated (This);
      end if;
   end Advance;

   function State (Timer : Timer_Name) return Timer_Model is
     (Timers (Timer));

   procedure Write_Control (Timer : Timer_Name; Value : Control) is
   begin
      Advance (Timer);
      Timers (Timer).Settings := Value;
   end Write_Control;

   procedure Write_Modes
     (Timer : Timer_Name;
      Pair  : Output_Pair;
      Value : Modes) is
   begin
      Advance (Timer);
      Timers (Timer).Modes (Pair) := Value;
   end Write_Modes;

   procedure Write_Outputs (Timer : Timer_Name; Value : Outputs) is
   begin
      Advance (Timer);
      Timers (Timer).Switches := Value;
   end Write_Outputs;

   procedure Write_Prescaler (Timer : Timer_Name; Value : Register_16) is
   begin
      Advance (Timer);
      Timers (Timer).Written.Prescaler := Value;
   end Write_Prescaler;

   procedure Write_Reload (Timer : Timer_Name; Value : Register_16) is
   begin
      Advance (Timer);
      Timers (Timer).Written.Reload := Value;
      if not Timers (Timer).Settings.Reload_Is_Saved then
         Timers (Timer).In_Use.Reload := Value;
      end if;
   end Write_Reload;

   procedure Write_Compare
     (Timer  : Timer_Name;
      Output : Output_Number;
      Value  : Register_16)
   is
      This     : Timer_Model renames Timers (Timer);
      Pair     : constant Output_Pair :=
        (if Output <= 2 then Outputs_1_2 else Outputs_3_4);
      Is_Saved : constant Boolean :=
        (if Output mod 2 = 1 then This.Modes (Pair).First_Is_Saved
         else This.Modes (Pair).Second_Is_Saved);
   begin
      Advance (Timer);
      This.Written.Compare (Output) := Value;
      if not Is_Saved then
         This.In_Use.Compare (Output) := Value;
      end if;
   end Write_Compare;

   procedure Generate_Update (Timer : Timer_Name) is
   begin
      Advance (Timer);
      Timers (Timer) := Updated (Timers (Timer));
   end Generate_Update;

end STM32_PWM.Registers;
