--  SPDX-License-Identifier: Apache-2.0

--  The calls of a scheduler (report, sections 3.2 and 3.3; KRN-1 to KRN-4,
--  FRM-4), in place. Each does the same as its model in URVOS.Schedulers.

package URVOS.Schedulers.Calls with Pure, SPARK_Mode is

   --  Successive TCBs; none if the first follows the last.
   type TCB_Range is record
      First : TCB_Number := TCB_Number'First;
      Last  : TCB_Count  := TCB_Number'Last;
   end record
   with Alignment => 2;

   All_TCBs : constant TCB_Range := (others => <>);

   No_TCBs : constant TCB_Range :=
     (First => TCB_Number'Last, Last => No_TCB);

   function Is_In (Which : TCB_Number; TCBs : TCB_Range) return Boolean is
     (Which in TCBs.First .. TCBs.Last)
   with Global => null;

   --  The smallest range with the TCBs of both.
   function Union (Left, Right : TCB_Range) return TCB_Range is
     ((First => TCB_Number'Min (Left.First, Right.First),
       Last  => TCB_Count'Max (Left.Last, Right.Last)))
   with
     Global => null,
     Post   =>
       (for all Which in TCB_Number =>
          (if Is_In (Which, Left) or else Is_In (Which, Right)
           then Is_In (Which, Union'Result)));

   --  The ready queue has no TCB outside a range.
   function Ready_Are_In (S : Scheduler; TCBs : TCB_Range) return Boolean is
     (for all Which in TCB_Number =>
        (if Queue_Of (S, Which) = Ready then Is_In (Which, TCBs)))
   with Global => null;

   --  No TCB but Except has become ready or gone to sleep.
   function Queues_Shrink
     (Before, After : Scheduler;
      Except        : TCB_Count := No_TCB) return Boolean
   is
     (for all Which in TCB_Number =>
        (if Which /= Except and then Queue_Of (After, Which) in Ready | Timer
         then Queue_Of (Before, Which) = Queue_Of (After, Which)
           and then TCB (Before, Which).Ready_At =
                      TCB (After, Which).Ready_At))
   with Ghost, Global => null;

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

   --  The same. It searches May_Be_Ready alone, and reduces it if it can.
   procedure Dispatch (S : in out Scheduler; May_Be_Ready : in out TCB_Range)
   with
     Global => null,
     Pre    => Ready_Are_In (S, May_Be_Ready),
     Post   =>
       S = After_Dispatch (S'Old)
       and then Queues_Shrink (S'Old, S)
       and then Ready_Are_In (S, May_Be_Ready);

   procedure Wake (S : in out Scheduler; Now : Clock_Tick)
   with
     Inline,
     Global => null,
     Pre    => Now >= Clock (S),
     Post   =>
       S = After_Wake (S'Old, Now)
       and then
         (for all Which in TCB_Number =>
            (Queue_Of (S'Old, Which) in Ready | Timer) =
              (Queue_Of (S, Which) in Ready | Timer)
            and then TCB (S'Old, Which).Ready_At = TCB (S, Which).Ready_At);

   procedure Exit_Call (S : in out Scheduler)
   with
     Global => null,
     Pre    => not Is_Idle (S),
     Post   =>
       S = After_Exit (S'Old)
       and then Queues_Shrink (S'Old, S, Except => Running_TCB (S'Old))
       and then Queue_Of (S, Running_TCB (S'Old)) in Running | Ready
       and then Clock (S) = Clock (S'Old)
       and then not Is_Idle (S);

   procedure Sleep (S : in out Scheduler; Until_Tick : Tick)
   with
     Global => null,
     Pre    => not Is_Idle (S),
     Post   =>
       S = After_Sleep (S'Old, Until_Tick)
       and then Queues_Shrink (S'Old, S, Except => Running_TCB (S'Old))
       and then Queue_Of (S, Running_TCB (S'Old)) = Timer
       and then TCB (S, Running_TCB (S'Old)).Ready_At =
                  Tick'Max (Until_Tick, Clock (S'Old) + 1);

   procedure Terminate_Caller (S : in out Scheduler)
   with
     Global => null,
     Pre    => not Is_Idle (S),
     Post   =>
       S = After_Terminate (S'Old) and then Queues_Shrink (S'Old, S);

end URVOS.Schedulers.Calls;
