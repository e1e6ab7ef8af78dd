--  SPDX-License-Identifier: Apache-2.0

--  A step of a task in the partition: what it runs, how long that takes, and
--  what catches an unexpected exception of the processor, which the target
--  has as an exception vector (KRN-6).
--
--  A transaction of a node that has stood still is not made, and has failed:
--  what it would pass on is old (SAF-4).

with Partitions.Measurements; use Partitions.Measurements;
with URVOS.Frames;            use URVOS.Frames;
with URVOS.Kernel_Calls;      use URVOS.Kernel_Calls;

generic
   type Task_Name is (<>);
   type Distributions is array (Task_Name) of Distribution;

   --  What the transactions take, and when they end after the tick at which
   --  their minor frame began; in tenths of microseconds. Of a transaction
   --  that calls EXIT the last step is measured.
   Costs     : in out Distributions;
   Responses : in out Distributions;

   with function Has_Stood_Still return Boolean;
   with procedure Run_Step
     (Who       : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   --  For who watches: the transaction is over.
   with procedure Observe (Who : Task_Name);

   --  The step has failed: the processor restarts.
   with procedure Fail;
procedure Partitions.Guarded_Step
  (Who       : Task_Name;
   First_Run : Boolean;
   Now       : Clock_Tick;
   Call      : out Kernel_Call);
