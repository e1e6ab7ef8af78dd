--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Scheduling with SPARK_Mode is

   procedure No_Task_Is_Woken (S : Scheduler; Now : Clock_Tick) is null;

   procedure The_Caller_Runs_On (S : Scheduler) is null;

   procedure The_Caller_Is_Kept (S : Scheduler) is null;

   procedure No_Task_Is_Late (S : Scheduler) is null;

end Canaries.Scheduling;
