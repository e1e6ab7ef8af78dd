--  SPDX-License-Identifier: Apache-2.0

package body Kernel_Suite is

   package body Frame_Locks_Tests is separate;

   package body Mailboxes_Tests is separate;

   package body Semaphores_Tests is separate;

   package body Receive_Calls_Tests is separate;

   package body Waiting_Tasks_Tests is separate;

   package body Error_Log_Tests is separate;

   package body Schedulers_Tests is separate;

   package body Scheduler_Histories_Tests is separate;

   package body Executives_Tests is separate;

   package body Clocked_Executives_Tests is separate;

   package body Task_Lists_Tests is separate;

   package body Start_Orders_Tests is separate;

end Kernel_Suite;
