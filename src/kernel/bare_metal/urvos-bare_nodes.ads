--  SPDX-License-Identifier: Apache-2.0

--  A node on a bare machine: one processor, no Ada tasks (report, sections
--  2.2, 2.3 and 3.1 to 3.3; FRM-1, FRM-4, FRM-6, KRN-6, BRD-1).
--
--  The timer's interrupt counts ticks. Outside interrupts the machine calls
--  Serve while there is work, then Run_Step until no task has the processor or
--  one runs on, and sleeps otherwise. It serves its devices after each step. A
--  tick during a task's step is seen when the step ends. Overruns are counted
--  as in URVOS.Real_Time_Nodes.

with URVOS.Node_Software;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

generic
   with package Software is new URVOS.Node_Software (<>);
package URVOS.Bare_Nodes
  with
    SPARK_Mode,
    Abstract_State =>
      ((Events with Synchronous, External), Task_Management),
    Initializes    => (Events, Task_Management)
is

   --  Requests a start: at power up, at the reset switch, or when the
   --  processor restarts at any point. The next Serve starts the node. Until
   --  phases 1 and 2 of the first start are over, every start is a cold start.
   procedure Begin_Start
     (Condition : Start_Condition;
      Schedule  : Schedule_Name := Report)
   with Global => (In_Out => (Events, Task_Management));

   --  The timer's interrupt.
   procedure Clock_Interrupt
   with Inline, Global => (In_Out => Events);

   --  A tick has not been served, or a start is requested.
   function Has_Work return Boolean
   with
     Volatile_Function,
     Global => (Input => Events);

   --  If there is work, advances the clock by all ticks since the last call.
   --  The tasks that are due are ready, and the first has the processor.
   procedure Serve;

   --  No task has the processor.
   function Is_Idle return Boolean
   with Global => (Input => Task_Management);

   --  Runs the next step of the task that has the processor, if any.
   --  Runs_On: this task called EXIT and has the processor again. It looks
   --  again after the next tick or interrupt.
   procedure Run_Step (Runs_On : out Boolean);

   --  The number of overruns of all tasks.
   function Overruns return Count
   with Global => (Input => Task_Management);

   --  The self-test of the last start has failed: no task runs.
   function Is_Refused return Boolean
   with Global => (Input => Task_Management);

end URVOS.Bare_Nodes;
