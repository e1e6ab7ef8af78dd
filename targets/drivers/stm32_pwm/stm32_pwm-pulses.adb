--  SPDX-License-Identifier: Apache-2.0

package body STM32_PWM.Pulses with SPARK_Mode is

   Saved_Pulses : constant Modes :=
     (First_Is_Saved | Second_Is_Saved => True,
      First | Second                   => PWM_1);

   --  The outputs are off until the update event has taken all values.
   procedure Set_Up (Timer : Timer_Name; Lengths : Pulse_List) is
   begin
      Write_Outputs (Timer, No_Output);
      Write_Control (Timer, (Counts => False, Reload_Is_Saved => True));
      Write_Modes (Timer, Outputs_1_2, Saved_Pulses);
      Write_Modes (Timer, Outputs_3_4, Saved_Pulses);
      Write_Prescaler (Timer, Clock_MHz - 1);
      Write_Reload (Timer, Period - 1);
      for Output in Output_Number loop
         Write_Compare (Timer, Output, Lengths (Output));
         pragma Loop_Invariant
           (Same_Settings (State (Timer), State (Timer)'Loop_Entry)
            and then State (Timer).Written.Prescaler = Clock_MHz - 1
            and then State (Timer).Written.Reload = Period - 1
            and then
              (for all Done in 1 .. Output =>
                 State (Timer).Written.Compare (Done) = Lengths (Done)));
      end loop;
      pragma Assert (Are_Pulses (State (Timer).Written));
      Generate_Update (Timer);
      pragma Assert (Are_Pulses (State (Timer).In_Use));
      Write_Outputs (Timer, All_Outputs);
      pragma Assert (Makes_Pulses (State (Timer)));
      Write_Control (Timer, (Counts => True, Reload_Is_Saved => True));
      pragma Assert (Is_Saved (State (Timer)));
      pragma Assert (Are_Pulses (State (Timer).Written));
      pragma Assert (Are_Pulses (State (Timer).In_Use));
   end Set_Up;

   procedure Write
     (Timer  : Timer_Name;
      Output : Output_Number;
      Length : Pulse) is
   begin
      Write_Compare (Timer, Output, Length);
   end Write;

end STM32_PWM.Pulses;
