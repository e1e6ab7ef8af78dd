--  SPDX-License-Identifier: Apache-2.0

--  Unit tests of the kernel.

with AUnit.Test_Suites;

package Kernel_Suite is

   --  FRM-6: frames of 9 to 11 ticks, and what keeps them in step.
   package Frame_Locks_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Frame_Locks_Tests;

   --  MBX-1 to MBX-5 and INI-8: the mailbox, alone and between two tasks.
   package Mailboxes_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Mailboxes_Tests;

   --  SEM-1, SEM-2: who has a semaphore, and how long a P waits for it.
   package Semaphores_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Semaphores_Tests;

   --  MBX-3, MBX-5: RECV with a wait, and that every wait ends.
   package Receive_Calls_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Receive_Calls_Tests;

   --  SEM-1, SEM-2, MBX-3, KRN-2: two tasks under the real scheduler, one that
   --  waits and one of higher priority that it waits for.
   package Waiting_Tasks_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Waiting_Tasks_Tests;

   --  EXT-1: the error log and the shell that guards a node's one.
   package Error_Log_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Error_Log_Tests;

   --  KRN-1 to KRN-4, FRM-4: which task runs.
   package Schedulers_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Schedulers_Tests;

   --  KRN-1 to KRN-4, FRM-4: histories of calls, with the state after each as
   --  the report's sections 3.2 and 3.3 give it. They were written by hand.
   package Scheduler_Histories_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Scheduler_Histories_Tests;

   --  FRM-2 to FRM-4: when the tasks of a node run.
   package Executives_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Executives_Tests;

   --  FRM-1, FRM-4, KRN-1 to KRN-3: when tasks run whose steps take time.
   package Clocked_Executives_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Clocked_Executives_Tests;

   --  Tests of the nodes' lists of tasks and of what follows from them.
   package Task_Lists_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Task_Lists_Tests;

   --  EXT-4, INI-2, KRN-5: how the processors of a node start together.
   package Start_Orders_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Start_Orders_Tests;

end Kernel_Suite;
