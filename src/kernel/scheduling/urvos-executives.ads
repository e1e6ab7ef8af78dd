--  Runs the tasks of one processor in virtual time (report, sections 2.2 and
--  3.3; FRM-2 to FRM-4, KRN-1 to KRN-4, D-25).
--
--  A task is run in steps, each up to its next kernel call. The scheduler
--  says which task is next; here its step is run to the end. Between two
--  ticks of the clock nothing happens to the tasks, so one that calls EXIT
--  and gets the processor back runs on at the next tick.

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
package URVOS.Executives
  with
    SPARK_Mode,
    Abstract_State => Task_Management,
    Initializes    => Task_Management
is

   --  Loads the tasks of a tree and runs those that are due. The tasks that
   --  were there before are gone.
   procedure Start (Tree : Task_Tree; Now : Clock_Tick);

   --  The clock has ticked: runs the tasks that are due. A clock that runs
   --  back is not believed.
   procedure Clock_Interrupt (Now : Clock_Tick);

   --  How often a task has overrun, since the program began.
   function Overruns return Count
   with Global => Task_Management;

end URVOS.Executives;
