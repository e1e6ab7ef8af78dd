--  SPDX-License-Identifier: Apache-2.0

--  Runs the tasks of one processor (report, sections 2.2 and 3.3; FRM-2 to
--  FRM-4, KRN-1 to KRN-4, D-25).
--
--  A task runs in steps, each up to its next kernel call. The scheduler
--  chooses the next task, and the executive runs its step to the end. The
--  caller (URVOS.Virtual_Nodes, URVOS.Real_Time_Nodes, URVOS.Bare_Nodes)
--  reports each clock tick and has steps run between ticks.

with URVOS.Frames;       use URVOS.Frames;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

generic
   --  Runs a task's next step and gives the call that ends it. The first step
   --  of a loaded task is its initialisation.
   with procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   --  A task was released late, or ran into its next release (FRM-4).
   with procedure Report_Overrun (Who : Task_Id);

   --  Sets Now to the clock's tick, and Has_Moved, if the clock has moved
   --  since the step began.
   with procedure Read_Clock
     (Now : in out Clock_Tick; Has_Moved : in out Boolean) is null;
package URVOS.Executives
  with
    SPARK_Mode,
    Abstract_State => Task_Management,
    Initializes    => Task_Management
is

   --  The time by which tasks are released.
   function Time return Clock_Tick
   with Global => Task_Management;

   --  Loads the tasks of a tree. The tasks that were there before are gone.
   procedure Start (Tree : Task_Tree; Now : Clock_Tick)
   with Post => Time = Now;

   --  The clock has ticked: the tasks that are due are ready to run. A clock
   --  that runs back is ignored.
   procedure Clock_Interrupt (Now : Clock_Tick)
   with Post => Time = Tick'Max (Time'Old, Now);

   --  No task has the processor.
   function Is_Idle return Boolean
   with Global => Task_Management;

   --  Runs the next step of the task that has the processor, if any.
   --  Runs_On: this task called EXIT and has the processor again.
   procedure Run_Step (Runs_On : out Boolean)
   with Post => Time >= Time'Old;

   --  Runs all due steps. In virtual time only an interrupt changes a task's
   --  inputs between two ticks. A task that calls EXIT and keeps the processor
   --  therefore continues in the next call: at the next tick or after an
   --  interrupt.
   procedure Run_Until_Idle;

   --  The number of overruns since the program began.
   function Overruns return Count
   with Global => Task_Management;

end URVOS.Executives;
