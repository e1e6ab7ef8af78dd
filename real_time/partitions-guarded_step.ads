--  SPDX-License-Identifier: Apache-2.0

--  Runs a step of a task in the partition, measures its time, and catches an
--  unexpected exception of the processor, in the role of the target's
--  exception vector (KRN-6).
--
--  In a node that was stopped a transaction is not made, and has failed: its
--  data would be old (SAF-4).

with Partitions.Measurements; use Partitions.Measurements;
with URVOS.Frames;            use URVOS.Frames;
with URVOS.Kernel_Calls;      use URVOS.Kernel_Calls;

generic
   type Task_Name is (<>);
   type Distributions is array (Task_Name) of Distribution;

   --  The duration of the transactions, and their ends after the tick at which
   --  their minor frame began; in tenths of microseconds. If a transaction
   --  calls EXIT its last step is measured.
   Costs     : in out Distributions;
   Responses : in out Distributions;

   with function Has_Stood_Still return Boolean;
   with procedure Run_Step
     (Who       : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   --  For observers: the transaction is over.
   with procedure Observe (Who : Task_Name);

   --  The step has failed: the processor restarts.
   with procedure Fail;
procedure Partitions.Guarded_Step
  (Who       : Task_Name;
   First_Run : Boolean;
   Now       : Clock_Tick;
   Call      : out Kernel_Call);
