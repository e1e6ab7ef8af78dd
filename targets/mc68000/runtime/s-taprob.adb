--  SPDX-License-Identifier: Apache-2.0

--  The instructions are those of urv_mask_interrupts and
--  urv_restore_interrupts, in line.

with System.Machine_Code; use System.Machine_Code;

package body System.Tasking.Protected_Objects is

   procedure Initialize_Protection
     (Object : not null access Protection; Ceiling_Priority : Integer) is
   begin
      Object.Masked :=
        (if Ceiling_Priority in System.Priority then 0 else 16#0700#);
      Object.Saved := 0;
   end Initialize_Protection;

   procedure Finalize_Protection (Object : in out Protection) is null;

   procedure Lock (Object : not null access Protection) is
      Before, During : Status;
   begin
      Asm ("move.w %%sr, %0" & ASCII.LF & ASCII.HT
           & "move.w %2, %1" & ASCII.LF & ASCII.HT
           & "or.w %0, %1" & ASCII.LF & ASCII.HT
           & "move.w %1, %%sr",
           Outputs  =>
             (Status'Asm_Output ("=&d", Before),
              Status'Asm_Output ("=&d", During)),
           Inputs   => Status'Asm_Input ("m", Object.Masked),
           Clobber  => "memory",
           Volatile => True);
      Object.Saved := Before;
   end Lock;

   procedure Lock_Read_Only (Object : not null access Protection) is
   begin
      Lock (Object);
   end Lock_Read_Only;

   procedure Unlock (Object : not null access Protection) is
   begin
      Asm ("move.w %0, %%sr",
           Inputs   => Status'Asm_Input ("m", Object.Saved),
           Clobber  => "memory",
           Volatile => True);
   end Unlock;

end System.Tasking.Protected_Objects;
