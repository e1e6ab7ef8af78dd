--  SPDX-License-Identifier: Apache-2.0

package body MC68681.Timers with SPARK_Mode is

   procedure Start (Chip : Chip_Name; Half_Period : Timer_Count) is
   begin
      Write_Auxiliary (Chip, Timer_On_Own_Clock);
      Write_Count_High (Chip, Count_Half (Half_Period / 256));
      Write_Count_Low (Chip, Count_Half (Half_Period mod 256));
      Start_Timer (Chip);
   end Start;

   --  The flag is reset only when it was set: the end of a period between the
   --  two accesses would else be lost.
   procedure Take_Period (Chip : Chip_Name; Is_Due : out Boolean) is
      Pending : Interrupt_Set;
   begin
      Read_Interrupts (Chip, Pending);
      Is_Due := Pending.Timer;
      if Is_Due then
         Answer_Timer (Chip);
      end if;
   end Take_Period;

   procedure Use_Interrupts
     (Chip     : Chip_Name;
      Vector   : Byte;
      Receiver : Boolean) is
   begin
      Write_Vector (Chip, Vector);
      Write_Interrupts
        (Chip, (Timer => True, Receiver_A => Receiver, others => False));
   end Use_Interrupts;

end MC68681.Timers;
