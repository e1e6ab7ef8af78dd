--  SPDX-License-Identifier: Apache-2.0

--  The instructions are those of urv_mask_interrupts and
--  urv_restore_interrupts, in line. The status register is in the high word of
--  Saved.

with System.Machine_Code; use System.Machine_Code;

package body System.Tasking.Protected_Objects is

   procedure Initialize_Protection
     (Object : not null access Protection; Ceiling_Priority : Integer) is
   begin
      Object.Ceiling := Ceiling_Priority;
      Object.Saved := 0;
   end Initialize_Protection;

   procedure Finalize_Protection (Object : in out Protection) is null;

   procedure Lock (Object : not null access Protection) is
   begin
      Asm ("move.w %%sr, %0" & ASCII.LF & ASCII.HT & "move.w #0x2700, %%sr",
           Outputs  => Integer'Asm_Output ("=m", Object.Saved),
           Clobber  => "memory",
           Volatile => True);
   end Lock;

   procedure Lock_Read_Only (Object : not null access Protection) is
   begin
      Lock (Object);
   end Lock_Read_Only;

   procedure Unlock (Object : not null access Protection) is
   begin
      Asm ("move.w %0, %%sr",
           Inputs   => Integer'Asm_Input ("m", Object.Saved),
           Clobber  => "memory",
           Volatile => True);
   end Unlock;

end System.Tasking.Protected_Objects;
