--  SPDX-License-Identifier: Apache-2.0

--  The simulation is one thread, so no protected object is contended. The
--  linker replaces GNAT's lock operations by these (sim/urv_sim.gpr): the
--  unchanged text of the nodes does not pay for locks there.
--
--  A program that withs this package must have no tasks: the binder checks
--  that.

pragma Restrictions (Max_Tasks => 0);

with System;

package Sim.One_Thread is

   procedure Lock (Object : System.Address) is null
   with
     Export,
     Convention    => C,
     External_Name => "__wrap_system__tasking__protected_objects__lock";

   procedure Lock_Read_Only (Object : System.Address) is null
   with
     Export,
     Convention    => C,
     External_Name =>
       "__wrap_system__tasking__protected_objects__lock_read_only";

   procedure Unlock (Object : System.Address) is null
   with
     Export,
     Convention    => C,
     External_Name => "__wrap_system__tasking__protected_objects__unlock";

end Sim.One_Thread;
