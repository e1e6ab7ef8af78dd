--  SPDX-License-Identifier: Apache-2.0

--  The processor of a task that waits in steps: its clock, and the other
--  tasks, which run while it has called EXIT.
--
--     Begin_At (100, Exits_Per_Tick => 4, Others_Run => Send_It'Access);
--     --  The task's steps, and an Exit_Processor between any two.
--     Expect ("it ended", Now, 102);

with URVOS.Frames; use URVOS.Frames;

package Waiting_Rig is

   --  The work of the other tasks when they run.
   type Action is access procedure;

   --  The clock, and the number of EXITs of the task.
   Now   : Clock_Tick := 0;
   Exits : Natural    := 0;

   --  Starts the clock. It ticks at every Exits_Per_Tick-th EXIT; at 0 it
   --  never ticks.
   procedure Begin_At
     (Start          : Clock_Tick;
      Exits_Per_Tick : Natural;
      Others_Run     : Action := null);

   procedure Exit_Processor;

end Waiting_Rig;
