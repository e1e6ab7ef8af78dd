--  SPDX-License-Identifier: Apache-2.0

--  What the scheduler's code needs for its proof (KRN-1 to KRN-4).

with URVOS.Schedulers.Changes; use URVOS.Schedulers.Changes;

private package URVOS.Schedulers.Lemmas with Pure, SPARK_Mode, Ghost is

   --  The TCB stands in its queue where its priority or its tick says.
   function Is_In_Its_Place
     (S     : Scheduler;
      Which : TCB_Number) return Boolean
   is
     (for all Other in TCB_Number =>
        (if Other /= Which and then Queue_Of (S, Other) = Queue_Of (S, Which)
         then
           (if Queue_Of (S, Which) = Ready
            then Is_Ahead (S, Other, Which) =
                   (Priority_Of (S, Other) >= Priority_Of (S, Which))
            elsif Queue_Of (S, Which) = Timer
            then Is_Ahead (S, Other, Which) =
                   (Release_Of (S, Other) <= Release_Of (S, Which)))))
   with Global => null;

   --  One TCB was moved along the row. The others keep their order, and
   --  those that it passed are on its other side.
   procedure Prove_Order_After_Move
     (Before, After : Scheduler;
      Moved         : TCB_Number;
      To            : Place)
   with
     Global => null,
     Pre    =>
       (for all Which in TCB_Number =>
          Place_Of (After.Row, Which) =
            Place_After_Move
              (Place_Of (Before.Row, Which),
               From => Place_Of (Before.Row, Moved),
               To   => To))
       and then Is_Sound (Before.Row),
     Post   =>
       Order_Is_Kept (Before, After, Except => Moved)
       and then Place_Of (After.Row, Moved) = To
       and then
         (for all Other in TCB_Number =>
            (if Other /= Moved
             then Place_Of (Before.Row, Other) /=
                    Place_Of (Before.Row, Moved)
               and then Place_Of (After.Row, Other) /= To
               and then Is_Ahead (After, Other, Moved) =
                 (if Place_Of (Before.Row, Moved) < To
                  then Place_Of (Before.Row, Other) <= To
                  else Place_Of (Before.Row, Other) < To)));

   --  If one TCB has changed its queue, and stands in its place there, the
   --  queues are in order as before.
   procedure Prove_Queues_In_Order
     (Before, After : Scheduler;
      Moved         : TCB_Number)
   with
     Global => null,
     Pre    =>
       Ready_In_Order (Before)
       and then Timer_In_Order (Before)
       and then Order_Is_Kept (Before, After, Except => Moved)
       and then
         (for all Which in TCB_Number =>
            (if Which /= Moved
             then Queue_Of (After, Which) = Queue_Of (Before, Which)
               and then After.Blocks (Which) = Before.Blocks (Which)))
       and then Is_In_Its_Place (After, Moved),
     Post   => Ready_In_Order (After) and then Timer_In_Order (After);

   --  If nobody else sleeps, and the time is the same, none is due.
   procedure Prove_Sleepers_Stay (Before, After : Scheduler)
   with
     Global => null,
     Pre    =>
       Sleepers_Are_Not_Due (Before)
       and then Clock (After) = Clock (Before)
       and then
         (for all Which in TCB_Number =>
            (if Queue_Of (After, Which) = Timer
             then Queue_Of (Before, Which) = Timer
               and then Release_Of (After, Which) =
                          Release_Of (Before, Which))),
     Post   => Sleepers_Are_Not_Due (After);

   --  The first of the ready queue has been given the processor.
   function Is_Dispatched
     (Before, After : Scheduler;
      Chosen        : TCB_Number) return Boolean
   is
     (not Before.Busy
      and then Before.Ready > 0
      and then After.Busy
      and then After.Ready = Before.Ready - 1
      and then After.Sleeping = Before.Sleeping
      and then After.Now = Before.Now
      and then
        (for all Which in TCB_Number =>
           Place_Of (After.Row, Which) = Place_Of (Before.Row, Which)
           and then (Place_Of (Before.Row, Which) = 1) = (Which = Chosen)
           and then After.Blocks (Which) =
             (Before.Blocks (Which) with delta
                New_Release => Before.Blocks (Which).New_Release
                  and then Which /= Chosen))
      and then After.Late =
        (if Before.Blocks (Chosen).New_Release
           and then Before.Blocks (Chosen).Release < Before.Now
         then Incremented (Before.Late)
         else Before.Late))
   with Global => null;

   --  The caller has gone to its place in the ready queue, the best task
   --  there runs instead.
   procedure Prove_Handed_Over
     (Before, Waiting, After : Scheduler;
      Caller, Best           : TCB_Number)
   with
     Global => null,
     Pre    =>
       Best /= Caller
       and then Waiting.Blocks = Before.Blocks
       and then Waiting.Now = Before.Now
       and then Waiting.Late = Before.Late
       and then Queue_Of (Before, Caller) = Running
       and then
         (for all Which in TCB_Number =>
            Queue_Of (Waiting, Which) =
              (if Which = Caller then Ready else Queue_Of (Before, Which)))
       and then Order_Is_Kept (Before, Waiting, Except => Caller)
       and then Is_In_Its_Place (Waiting, Caller)
       and then Is_Best_Ready (Waiting, Best)
       and then Is_Dispatched (Waiting, After, Best),
     Post   => Is_Handed_Over (Before, After, Caller, Best);

   --  A task's TCB is as it was loaded.
   function Is_Loaded
     (S      : Scheduler;
      Which  : TCB_Number;
      Header : Task_Header) return Boolean
   is
     (Id_Of (S, Which) = Header.Id
      and then Priority_Of (S, Which) = Header.Initial_Priority
      and then Release_Of (S, Which) = Header.Start_Time
      and then Is_New_Release (S, Which)
      and then Is_First_Run (S, Which)
      and then Queue_Of (S, Which) =
        (if Header.Start_Time <= Clock (S) then Ready else Timer))
   with Global => null;

   --  The first Number tasks of the tree have the first TCBs, the others are
   --  free.
   function Is_Loaded_To
     (S      : Scheduler;
      Tree   : Task_Tree;
      Number : TCB_Count) return Boolean
   is
     (Is_Sound (S)
      and then Is_Idle (S)
      and then Overruns (S) = 0
      and then
        (for all Which in TCB_Number =>
           (if Integer (Which) <= Number
            then Is_Loaded (S, Which, Tree (Which))
            else Queue_Of (S, Which) = Free))
      and then Equals_Are_In_Turn (S))
   with Global => null;

   --  Of the free TCBs that with the lowest number is the first.
   procedure Prove_Next_Free (S : Scheduler; Which : TCB_Number)
   with
     Global => null,
     Pre    =>
       Is_Sound (S)
       and then Queue_Of (S, Which) = Free
       and then
         (for all Other in TCB_Number =>
            (if Queue_Of (S, Other) = Free and then Other /= Which
             then Is_Ahead (S, Which, Other))),
     Post   => Has_Free_TCB (S) and then Next_Free_TCB (S) = Which;

   --  The tasks of the tree have been loaded, and the best of them runs.
   procedure Prove_Started
     (Loaded, After : Scheduler;
      Tree          : Task_Tree;
      Best          : TCB_Number)
   with
     Global => null,
     Pre    =>
       (for all Which in TCB_Number =>
          (if Is_In_Tree (Tree, Which)
           then Is_Loaded (Loaded, Which, Tree (Which))
           else Queue_Of (Loaded, Which) = Free))
       and then Equals_Are_In_Turn (Loaded)
       and then Is_Best_Ready (Loaded, Best)
       and then Is_Dispatched (Loaded, After, Best),
     Post   =>
       (for all Which in TCB_Number =>
          (if Is_In_Tree (Tree, Which)
           then Id_Of (After, Which) = Tree (Which).Id
             and then Priority_Of (After, Which) =
                        Tree (Which).Initial_Priority
             and then Release_Of (After, Which) = Tree (Which).Start_Time
             and then Is_New_Release (After, Which) = (Which /= Best)
             and then Is_First_Run (After, Which)
             and then
               (if Tree (Which).Start_Time <= Clock (After)
                then Queue_Of (After, Which) in Ready | Running
                else Queue_Of (After, Which) = Timer)
           else Queue_Of (After, Which) = Free))
       and then Equals_Are_In_Turn (After)
       and then
         (for all Which in TCB_Number =>
            (if Queue_Of (After, Which) = Ready
             then Priority_Of (After, Which) < Priority_Of (After, Best)
               or else
                 (Priority_Of (After, Which) = Priority_Of (After, Best)
                  and then Which > Best)));

   --  Who sleeps on is behind one that is not due.
   procedure Prove_None_Is_Due (S : Scheduler; Now : Clock_Tick)
   with
     Global => null,
     Pre    => Is_Sound (S) and then not Sleeper_Is_Due (S, Now),
     Post   =>
       (for all Which in TCB_Number =>
          (if Queue_Of (S, Which) = Timer
           then Release_Of (S, Which) > Now));

   --  Some sleepers have been woken: the ready queue is in the order of
   --  priorities, and within them as it was before, all the woken ones
   --  being ahead of those that sleep on. Nobody else has moved.
   function Is_In_Wake_Order (Before, After : Scheduler) return Boolean is
     (for all A in TCB_Number =>
        (for all B in TCB_Number =>
           (if Queue_Of (After, A) = Ready and then Queue_Of (After, B) = Ready
            then Is_Ahead (After, A, B) =
              (Priority_Of (After, A) > Priority_Of (After, B)
               or else (Priority_Of (After, A) = Priority_Of (After, B)
                        and then Is_Ahead (Before, A, B)))
            elsif Queue_Of (After, B) = Timer
            then
              (if Queue_Of (After, A) = Timer
               then Is_Ahead (After, A, B) = Is_Ahead (Before, A, B)
               elsif Queue_Of (After, A) = Ready
               then Is_Ahead (Before, A, B))
            elsif Queue_Of (After, A) = Free
              and then Queue_Of (After, B) = Free
            then Is_Ahead (After, A, B) = Is_Ahead (Before, A, B))))
   with Global => null;

   --  One more is woken.
   procedure Prove_Wake_Order
     (Before, Last, After : Scheduler;
      First               : TCB_Number)
   with
     Global => null,
     Pre    =>
       Is_Sound (Before.Row)
       and then Is_Sound (After.Row)
       and then Is_In_Wake_Order (Before, Last)
       and then Last.Blocks = After.Blocks
       and then Queue_Of (Last, First) = Timer
       and then Queue_Of (After, First) = Ready
       and then
         (for all Which in TCB_Number =>
            (if Which /= First
             then Queue_Of (After, Which) = Queue_Of (Last, Which)))
       and then Order_Is_Kept (Last, After, Except => First)
       and then Is_In_Its_Place (After, First)
       and then
         (for all Which in TCB_Number =>
            (if Queue_Of (After, Which) = Timer
             then Is_Ahead (Last, First, Which))),
     Post   => Is_In_Wake_Order (Before, After);

end URVOS.Schedulers.Lemmas;
