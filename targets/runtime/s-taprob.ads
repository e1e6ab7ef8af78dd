--  SPDX-License-Identifier: Apache-2.0

--  The lock of a protected object on one processor: no interrupt is taken
--  while it is held. The compiler calls this unit by these names, in line. Each
--  machine has a body.

package System.Tasking.Protected_Objects is
   pragma Preelaborate;

   type Protection is limited record
      Ceiling : Integer;

      --  The interrupt mask before the lock was taken.
      Saved   : Integer;
   end record;

   type Protection_Access is access all Protection;

   procedure Initialize_Protection
     (Object : not null access Protection; Ceiling_Priority : Integer);

   procedure Finalize_Protection (Object : in out Protection);

   procedure Lock (Object : not null access Protection)
   with Inline_Always;

   procedure Lock_Read_Only (Object : not null access Protection)
   with Inline_Always;

   procedure Unlock (Object : not null access Protection)
   with Inline_Always;

end System.Tasking.Protected_Objects;
