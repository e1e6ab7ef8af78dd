--  SPDX-License-Identifier: Apache-2.0

with STM32_PWM;        use STM32_PWM;
with STM32_PWM.Pulses; use STM32_PWM.Pulses;

package body Servo_Outputs is

   Pulses_Run : Boolean := False;

   function Timer_Of (Channel : Channel_Number) return Timer_Name is
     (Timer_Name'Val ((Channel - 1) / 4));

   function Output_Of (Channel : Channel_Number) return Output_Number is
     (Output_Number ((Channel - 1) mod 4 + 1));

   --  The outputs without a servo have pulses, too, but no pins.
   procedure Start (Area : Data_Area);

   procedure Start (Area : Data_Area) is
      Lengths : array (Timer_Name) of Pulse_List;
   begin
      for Channel in Channel_Number loop
         Lengths (Timer_Of (Channel)) (Output_Of (Channel)) :=
           Pulse_Of (Area (Channel));
      end loop;
      for Timer in Timer_Name loop
         Set_Up (Timer, Lengths (Timer));
      end loop;
   end Start;

   procedure Open is
   begin
      Pulses_Run := False;
   end Open;

   procedure Write (Area : Data_Area) is
   begin
      if Pulses_Run then
         for Channel in 1 .. Last_Channel loop
            Write
              (Timer_Of (Channel), Output_Of (Channel),
               Pulse_Of (Area (Channel)));
         end loop;
      else
         Start (Area);
         Pulses_Run := True;
      end if;
   end Write;

end Servo_Outputs;
