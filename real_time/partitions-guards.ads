--  SPDX-License-Identifier: Apache-2.0

--  The partition in the role of the target's exception vector: operations that
--  catch an unexpected exception of the processor (KRN-6).

with Partitions.Measurements; use Partitions.Measurements;
with URVOS.Frames;            use URVOS.Frames;
with URVOS.Kernel_Calls;      use URVOS.Kernel_Calls;
with URVOS.Starts;            use URVOS.Starts;

package Partitions.Guards is

   --  An operation that an interrupt makes the processor execute. An
   --  unexpected exception in it belongs to the processor and is not
   --  propagated.
   generic
      with procedure Interrupt;
      with procedure Raise_Processor_Exception;
   procedure Call;

   --  Runs the first two phases of a start. After an unexpected exception the
   --  start has failed, and is repeated; a start at power up remains a cold
   --  start.
   generic
      with procedure Begin_Again
        (Condition : Start_Condition;
         Now       : Clock_Tick;
         Passed    : out Boolean);
      with procedure Request_Start (Condition : Start_Condition);
   procedure Start
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);

   --  Runs a step of a task and measures its time. In a node that was stopped
   --  a transaction is not made, and has failed: its data would be old
   --  (SAF-4).
   generic
      type Task_Name is (<>);
      type Distributions is array (Task_Name) of Distribution;

      --  The duration of the transactions, and their ends after the tick at
      --  which their minor frame began; in tenths of microseconds. If a
      --  transaction calls EXIT its last step is measured.
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
   procedure Step
     (Who       : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

end Partitions.Guards;
