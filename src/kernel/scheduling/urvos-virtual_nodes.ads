--  SPDX-License-Identifier: Apache-2.0

--  A node in virtual time: the caller supplies each clock tick (KRN-1 to
--  KRN-6, EXT-4, D-23).
--
--  A step takes no time. All steps of one processor run before those of the
--  next, so each run gives the same results.

with URVOS.Frames;       use URVOS.Frames;
with URVOS.Node_Software;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

generic
   with package Software is new URVOS.Node_Software (<>);
package URVOS.Virtual_Nodes with SPARK_Mode is

   --  Starts the node. Unless the self-test has failed, its tasks are loaded
   --  and initialised at once. Their transactions begin with the next major
   --  frame.
   procedure Start
     (Condition  : Start_Condition;
      Now        : Clock_Tick;
      Processors : Processor_Number := 1;
      Schedule   : Schedule_Name    := Report);

   --  The clock has ticked, for every processor.
   procedure Clock_Interrupt (Now : Clock_Tick);

   --  Called after an interrupt, between two ticks. A task that calls EXIT
   --  while it waits for the interrupt's result looks again.
   procedure Look_Again;

   --  The number of overruns of all tasks on all processors.
   function Overruns return Count;

end URVOS.Virtual_Nodes;
