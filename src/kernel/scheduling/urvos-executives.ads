--  SPDX-License-Identifier: Apache-2.0

--  Runs the tasks of one processor (report, sections 2.2 and 3.3; FRM-2 to
--  FRM-4, KRN-1 to KRN-4, D-25).
--
--  A task is run in steps, each up to its next kernel call. The scheduler
--  says which task is next; here its step is run to the end. Who drives the
--  executive tells it when the clock has ticked, and has it run steps
--  between the ticks: URVOS.Virtual_Nodes, URVOS.Real_Time_Nodes.

with URVOS.Frames;       use URVOS.Frames;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

generic
   --  The next step of a task, and the call that it ends with. The first
   --  step of a task that was loaded is its initialisation.
   with procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   --  A task was released late, or ran into its next release (FRM-4).
   with procedure Report_Overrun (Who : Task_Id);

   --  Now is what the clock shows, should it have moved since a step began.
   with procedure Read_Clock (Now : in out Clock_Tick) is null;
package URVOS.Executives
  with
    SPARK_Mode,
    Abstract_State => Task_Management,
    Initializes    => Task_Management
is

   --  Loads the tasks of a tree. The tasks that were there before are gone.
   procedure Start (Tree : Task_Tree; Now : Clock_Tick);

   --  The clock has ticked: who is due is ready to run. A clock that runs
   --  back is not believed.
   procedure Clock_Interrupt (Now : Clock_Tick);

   --  No task has the processor.
   function Is_Idle return Boolean
   with Global => Task_Management;

   --  Runs the next step of the task that has the processor, if any.
   --  Runs_On tells that this task called EXIT and has the processor again.
   procedure Run_Step (Runs_On : out Boolean);

   --  Runs what is due. In virtual time nothing happens to the tasks between
   --  two ticks but what an interrupt brings. So one that calls EXIT and gets
   --  the processor back runs on when this is called again: at the next tick,
   --  or behind an interrupt.
   procedure Run_Until_Idle;

   --  How often a task has overrun, since the program began.
   function Overruns return Count
   with Global => Task_Management;

end URVOS.Executives;
