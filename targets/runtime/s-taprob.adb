--  SPDX-License-Identifier: Apache-2.0

package body System.Tasking.Protected_Objects is

   --  The target's operations; see targets.ads

   function Mask return Integer
   with Import, Convention => C, External_Name => "urv_mask_interrupts";

   procedure Restore (Before : Integer)
   with Import, Convention => C, External_Name => "urv_restore_interrupts";

   procedure Initialize_Protection
     (Object : not null access Protection; Ceiling_Priority : Integer) is
   begin
      Object.Ceiling := Ceiling_Priority;
      Object.Saved := 0;
   end Initialize_Protection;

   procedure Finalize_Protection (Object : in out Protection) is null;

   procedure Lock (Object : not null access Protection) is
      Before : constant Integer := Mask;
   begin
      Object.Saved := Before;
   end Lock;

   procedure Lock_Read_Only (Object : not null access Protection)
     renames Lock;

   procedure Unlock (Object : not null access Protection) is
   begin
      Restore (Object.Saved);
   end Unlock;

end System.Tasking.Protected_Objects;
