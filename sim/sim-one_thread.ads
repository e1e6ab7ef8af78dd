--  SPDX-License-Identifier: Apache-2.0

--  The simulation is one thread, so nobody contends for a protected object.
--  The linker gives these in place of GNAT's (sim/urv_sim.gpr): the same
--  text of the nodes does not pay for locks there (EVI-14).
--
--  Whoever withs this has no tasks: the binder sees to it.

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
