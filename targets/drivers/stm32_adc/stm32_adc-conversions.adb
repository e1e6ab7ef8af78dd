--  SPDX-License-Identifier: Apache-2.0

package body STM32_ADC.Conversions with SPARK_Mode is

   procedure Set_Up (Sampling : Sampling_Time; Interrupt : Boolean) is
   begin
      Write_Control_2 ((Is_On => False, Each_End => True));
      Write_Status ((others => False));
      Write_Control_1 ((others => Interrupt));
      Write_Sampling (Sampling);
      Write_Control_2 ((Is_On => True, Each_End => True));
   end Set_Up;

   procedure Start (Channel : Channel_Number) is
   begin
      Write_Channel (Channel);
      Write_Start;
   end Start;

   --  A conversion may end between the first look and the read: the second
   --  look shows whether the value may be that of another one.
   procedure Take (Result : out Reception) is
      Before, After : Status;
      Value         : Converted_Value;
   begin
      Result := (others => <>);
      Read_Status (Before);
      if Before.Converted or else Before.Overrun then
         Read_Data (Value);
         Read_Status (After);
         if After.Overrun then
            Result.Overrun := True;
            Write_Status ((Overrun => False, others => True));
         elsif Before.Converted then
            Result.Is_There := True;
            Result.Value := Value;
         end if;
      end if;
   end Take;

end STM32_ADC.Conversions;
