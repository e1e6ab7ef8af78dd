--  SPDX-License-Identifier: Apache-2.0

--  The calls of a scheduler (report, sections 3.2 and 3.3; KRN-1 to KRN-4,
--  FRM-4), in place. Each does the same as its model in URVOS.Schedulers.

package URVOS.Schedulers.Calls with Pure, SPARK_Mode is

   --  No task besides the running one is ready.
   function Is_Alone (S : Scheduler) return Boolean is
     (for all Which in TCB_Number => Queue_Of (S, Which) /= Ready)
   with Global => null;

   --  Loads the tasks of a tree and runs the first task.
   procedure Start (S : out Scheduler; Tree : Task_Tree; Now : Clock_Tick)
   with
     Global => null,
     Post   => S = After_Dispatch (Loaded_Tree (Tree, Now));

   procedure Load (S : in out Scheduler; Header : Task_Header)
   with
     Global => null,
     Pre    => Header.Id /= No_Task and then Has_Free_TCB (S),
     Post   => S = After_Load (S'Old, Header);

   procedure Dispatch (S : in out Scheduler)
   with
     Global => null,
     Post   => S = After_Dispatch (S'Old);

   --  The same. Others_Wait: a task besides the running one may be ready. If
   --  not, none is.
   procedure Dispatch (S : in out Scheduler; Others_Wait : out Boolean)
   with
     Global => null,
     Post   =>
       S = After_Dispatch (S'Old)
       and then (Others_Wait or else Is_Alone (S));

   procedure Wake (S : in out Scheduler; Now : Clock_Tick)
   with
     Global => null,
     Pre    => Now >= Clock (S),
     Post   => S = After_Wake (S'Old, Now);

   procedure Exit_Call (S : in out Scheduler)
   with
     Global => null,
     Pre    => not Is_Idle (S),
     Post   => S = After_Exit (S'Old);

   procedure Sleep (S : in out Scheduler; Until_Tick : Tick)
   with
     Global => null,
     Pre    => not Is_Idle (S),
     Post   =>
       S = After_Sleep (S'Old, Until_Tick)
       and then (if Is_Alone (S'Old) then Is_Alone (S));

   procedure Terminate_Caller (S : in out Scheduler)
   with
     Global => null,
     Pre    => not Is_Idle (S),
     Post   => S = After_Terminate (S'Old);

end URVOS.Schedulers.Calls;
