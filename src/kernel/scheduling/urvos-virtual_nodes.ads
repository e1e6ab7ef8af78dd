--  SPDX-License-Identifier: Apache-2.0

--  A node in virtual time: whoever drives it tells it when the clock ticks
--  (KRN-1 to KRN-6, EXT-4, D-23).
--
--  A step takes no time. So one processor's tasks run to their ends before
--  the next one's, and what they do is the same each time.

with URVOS.Frames;       use URVOS.Frames;
with URVOS.Node_Software;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

generic
   with package Software is new URVOS.Node_Software (<>);
package URVOS.Virtual_Nodes with SPARK_Mode is

   --  The node starts. Its tasks begin with the next major frame; after a
   --  failed self-test there are none.
   procedure Start
     (Condition  : Start_Condition;
      Now        : Clock_Tick;
      Processors : Processor_Number := 1;
      Schedule   : Schedule_Name    := Report);

   --  The clock has ticked, for every processor.
   procedure Clock_Interrupt (Now : Clock_Tick);

   --  An interrupt has been handled, between two ticks: a task that looks for
   --  what it brought, with EXIT between its looks, looks again.
   procedure Look_Again;

   --  How often a task has overrun, on any processor.
   function Overruns return Count;

end URVOS.Virtual_Nodes;
