--  SPDX-License-Identifier: Apache-2.0

--  A node on a bare machine: one processor, no Ada tasks (report, sections
--  2.2, 2.3 and 3.1 to 3.3; FRM-1, FRM-4, FRM-6, KRN-6, BRD-1).
--
--  The timer's interrupt counts ticks. Outside interrupts the machine calls
--  Serve while there is work, and sleeps otherwise. A tick that comes while
--  a task runs is seen when the task's step ends, so an overrun is counted
--  as URVOS.Real_Time_Nodes counts it.

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

   --  Power up, the reset switch, or a restart of the processor in the middle
   --  of anything: the next Serve starts the node. Until one start at power
   --  up has ended, each start is one at power up.
   procedure Begin_Start
     (Condition : Start_Condition;
      Schedule  : Schedule_Name := Report)
   with Global => (In_Out => (Events, Task_Management));

   --  The timer's interrupt.
   procedure Clock_Interrupt
   with Global => (In_Out => Events);

   --  A tick has not been served, or a start is wanted.
   function Has_Work return Boolean
   with
     Volatile_Function,
     Global => (Input => Events);

   --  Follows the clock by all ticks since the last call, and runs the tasks
   --  that are due.
   procedure Serve;

   --  An interrupt has been handled, between two ticks: a task that looks
   --  for its result, with EXIT between its looks, looks again.
   procedure Look_Again;

   --  How often a task has overrun.
   function Overruns return Count
   with Global => (Input => Task_Management);

   --  The self-test of the last start has failed: no task runs.
   function Is_Refused return Boolean
   with Global => (Input => Task_Management);

end URVOS.Bare_Nodes;
