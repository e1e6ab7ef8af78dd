--  SPDX-License-Identifier: Apache-2.0

--  The lock of a protected object on one processor (BRD-1, BRD-4). No interrupt
--  is taken while it is held, unless the object gives a priority below those of
--  interrupts: then only tasks call it, and a task runs until it calls the
--  kernel. The compiler calls this unit by these names, in line. Each machine
--  has a body.

package System.Tasking.Protected_Objects is
   pragma Preelaborate;

   --  A processor's status register with its interrupt mask.
   type Status is mod 2 ** 16;

   type Protection is limited record
      --  The bits that the lock sets.
      Masked : Status;

      --  The status before the lock was taken. It is written when interrupts
      --  are masked: a handler may take the same lock before.
      Saved  : Status;
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
