--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Schedulers with SPARK_Mode is

   --  The place in the ready queue behind all of a priority.
   function Behind_Priority
     (S     : Scheduler;
      Level : Priority) return Integer
   with
     Global => null,
     Pre    => Queues_Fit (S) and then Ready_In_Order (S),
     Post   =>
       Behind_Priority'Result in Running_Last (S) + 1 .. Ready_Last (S) + 1
       and then
         (for all Which in TCB_Number =>
            (if Queue_Of (S, Which) = Ready
             then (Place_Number (S, Which) < Behind_Priority'Result)
                  = (Priority_Of (S, Which) >= Level)));

   --  The place in the timer queue behind all of a tick.
   function Behind_Tick
     (S       : Scheduler;
      Release : Tick) return Integer
   with
     Global => null,
     Pre    => Queues_Fit (S) and then Timer_In_Order (S),
     Post   =>
       Behind_Tick'Result in Ready_Last (S) + 1 .. Timer_Last (S) + 1
       and then
         (for all Which in TCB_Number =>
            (if Queue_Of (S, Which) = Timer
             then (Place_Number (S, Which) < Behind_Tick'Result)
                  = (Release_Of (S, Which) <= Release)));

   --  One TCB was moved along the row. The others keep their order, and
   --  those that it passed are on its other side.
   procedure Prove_Order_After_Move
     (Before, After : Scheduler;
      Moved         : TCB_Number;
      To            : Place)
   with
     Ghost,
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
   with
     Ghost,
     Global => null;

   --  If one TCB has changed its queue, and stands in its place there, the
   --  queues are in order as before.
   procedure Prove_Queues_In_Order
     (Before, After : Scheduler;
      Moved         : TCB_Number)
   with
     Ghost,
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
   with
     Ghost,
     Global => null;

   --  Gives the idle processor to the best ready task.
   procedure Choose (S : in out Scheduler)
   with
     Global => null,
     Pre    => Is_Sound (S) and then Is_Idle (S) and then S.Ready > 0,
     Post   =>
       Is_Sound (S)
       and then not Is_Idle (S)
       and then Is_Dispatched (S'Old, S, Running_TCB (S))
       and then Is_Best_Ready (S'Old, Running_TCB (S));

   --  The caller has gone to its place in the ready queue, the best task
   --  there runs instead.
   procedure Prove_Handed_Over
     (Before, Waiting, After : Scheduler;
      Caller, Best           : TCB_Number)
   with
     Ghost,
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

   procedure Prove_Handed_Over
     (Before, Waiting, After : Scheduler;
      Caller, Best           : TCB_Number) is
   begin
      pragma Assert
        (for all Which in TCB_Number =>
           Queue_Of (After, Which) =
             (if Which = Best then Running else Queue_Of (Waiting, Which)));
      pragma Assert (Queue_Of (After, Caller) = Ready);
      pragma Assert (Is_Best_Ready (Before, Best));
   end Prove_Handed_Over;

   procedure Prove_Order_After_Move
     (Before, After : Scheduler;
      Moved         : TCB_Number;
      To            : Place) is null;

   procedure Prove_Queues_In_Order
     (Before, After : Scheduler;
      Moved         : TCB_Number) is null;

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
   with
     Ghost,
     Global => null;

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
   with
     Ghost,
     Global => null;

   --  Of the free TCBs that with the lowest number is the first.
   procedure Prove_Next_Free (S : Scheduler; Which : TCB_Number)
   with
     Ghost,
     Global => null,
     Pre    =>
       Is_Sound (S)
       and then Queue_Of (S, Which) = Free
       and then
         (for all Other in TCB_Number =>
            (if Queue_Of (S, Other) = Free and then Other /= Which
             then Is_Ahead (S, Which, Other))),
     Post   => Has_Free_TCB (S) and then Next_Free_TCB (S) = Which;

   procedure Prove_Next_Free (S : Scheduler; Which : TCB_Number) is
      First : constant TCB_Number :=
        TCB_At (S.Row, Place (Timer_Last (S) + 1));
   begin
      pragma Assert (Queue_Of (S, First) = Free);
      pragma Assert (not Is_Ahead (S, Which, First));
   end Prove_Next_Free;

   --  The tasks of the tree have been loaded, and the best of them runs.
   procedure Prove_Started
     (Loaded, After : Scheduler;
      Tree          : Task_Tree;
      Best          : TCB_Number)
   with
     Ghost,
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

   procedure Prove_Started
     (Loaded, After : Scheduler;
      Tree          : Task_Tree;
      Best          : TCB_Number) is
   begin
      pragma Assert
        (for all Which in TCB_Number =>
           Queue_Of (After, Which) =
             (if Which = Best then Running else Queue_Of (Loaded, Which)));
      pragma Assert
        (for all Which in TCB_Number =>
           (if Is_In_Tree (Tree, Which)
            then Id_Of (After, Which) = Tree (Which).Id));
   end Prove_Started;

   --  Loads one more task of the tree.
   procedure Load_Next
     (S     : in out Scheduler;
      Tree  : Task_Tree;
      Which : TCB_Number)
   with
     Global => null,
     Pre    => Is_Loaded_To (S, Tree, Integer (Which) - 1),
     Post   =>
       Is_Loaded_To (S, Tree, Integer (Which))
       and then Clock (S) = Clock (S'Old);

   --  Loads the tasks of a tree, one TCB for each header, in their order.
   procedure Load_Tree
     (S    : out Scheduler;
      Tree : Task_Tree;
      Now  : Clock_Tick)
   with
     Global => null,
     Post   =>
       Is_Sound (S)
       and then Is_Idle (S)
       and then Clock (S) = Now
       and then Overruns (S) = 0
       and then
         (for all Which in TCB_Number =>
            (if Is_In_Tree (Tree, Which)
             then Is_Loaded (S, Which, Tree (Which))
             else Queue_Of (S, Which) = Free))
       and then Equals_Are_In_Turn (S);

   --  The head of the timer queue, if there is one, is due.
   function Sleeper_Is_Due
     (S   : Scheduler;
      Now : Clock_Tick) return Boolean
   is
     (S.Sleeping > 0
      and then
        Release_Of (S, TCB_At (S.Row, Place (Ready_Last (S) + 1))) <= Now)
   with
     Global => null,
     Pre    => Queues_Fit (S);

   --  Who sleeps on is behind one that is not due.
   procedure Prove_None_Is_Due (S : Scheduler; Now : Clock_Tick)
   with
     Ghost,
     Global => null,
     Pre    => Is_Sound (S) and then not Sleeper_Is_Due (S, Now),
     Post   =>
       (for all Which in TCB_Number =>
          (if Queue_Of (S, Which) = Timer
           then Release_Of (S, Which) > Now));

   --  The head of the timer queue goes to its place in the ready queue.
   procedure Wake_First (S : in out Scheduler; First : TCB_Number)
   with
     Global => null,
     Pre    =>
       Is_Sound (S)
       and then S.Sleeping > 0
       and then First = TCB_At (S.Row, Place (Ready_Last (S) + 1)),
     Post   =>
       Is_Sound (S)
       and then S.Blocks = S.Blocks'Old
       and then S.Busy = S.Busy'Old
       and then S.Now = S.Now'Old
       and then S.Late = S.Late'Old
       and then S.Sleeping = S.Sleeping'Old - 1
       and then
         (for all Which in TCB_Number =>
            (if Which = First
             then Queue_Of (S'Old, Which) = Timer
               and then Queue_Of (S, Which) = Ready
             else Queue_Of (S, Which) = Queue_Of (S'Old, Which)))
       and then Order_Is_Kept (S'Old, S, Except => First)
       and then Is_In_Its_Place (S, First)
       and then
         (for all Which in TCB_Number =>
            (if Queue_Of (S, Which) = Timer
             then Is_Ahead (S'Old, First, Which)));

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
   with
     Ghost,
     Global => null;

   --  One more is woken.
   procedure Prove_Wake_Order
     (Before, Last, After : Scheduler;
      First               : TCB_Number)
   with
     Ghost,
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

   --  All who have slept long enough go to the ready queue. The clock is
   --  still to be set.
   procedure Wake_Due (S : in out Scheduler; Now : Clock_Tick)
   with
     Global => null,
     Pre    => Is_Sound (S) and then Now >= S.Now,
     Post   =>
       Is_Sound (S)
       and then S.Blocks = S.Blocks'Old
       and then S.Busy = S.Busy'Old
       and then S.Now = S.Now'Old
       and then S.Late = S.Late'Old
       and then
         (for all Which in TCB_Number =>
            Queue_Of (S, Which) =
              (if Queue_Of (S'Old, Which) = Timer
                 and then Release_Of (S, Which) <= Now
               then Ready
               else Queue_Of (S'Old, Which)))
       and then Is_In_Wake_Order (S'Old, S);

   --  The running task goes behind those of its priority in the ready
   --  queue.
   procedure Give_Way (S : in out Scheduler)
   with
     Global => null,
     Pre    => Is_Sound (S) and then not Is_Idle (S),
     Post   =>
       Is_Sound (S)
       and then Is_Idle (S)
       and then S.Blocks = S.Blocks'Old
       and then S.Now = S.Now'Old
       and then S.Late = S.Late'Old
       and then
         (for all Which in TCB_Number =>
            Queue_Of (S, Which) =
              (if Which = Running_TCB (S'Old)
               then Ready
               else Queue_Of (S'Old, Which)))
       and then Order_Is_Kept (S'Old, S, Except => Running_TCB (S'Old))
       and then Is_In_Its_Place (S, Running_TCB (S'Old));

   procedure Prove_None_Is_Due (S : Scheduler; Now : Clock_Tick) is
   begin
      if S.Sleeping > 0 then
         declare
            First : constant TCB_Number :=
              TCB_At (S.Row, Place (Ready_Last (S) + 1));
         begin
            pragma Assert (Queue_Of (S, First) = Timer);
            pragma Assert
              (for all Which in TCB_Number =>
                 (if Queue_Of (S, Which) = Timer and then Which /= First
                  then Is_Ahead (S, First, Which)));
            pragma Assert (Release_Of (S, First) > Now);
         end;
      end if;
   end Prove_None_Is_Due;

   procedure Prove_Wake_Order
     (Before, Last, After : Scheduler;
      First               : TCB_Number)
   is
   begin
      pragma Assert
        (for all A in TCB_Number =>
           (for all B in TCB_Number =>
              (if A /= First and then B /= First
                 and then Queue_Of (After, A) = Ready
                 and then Queue_Of (After, B) = Ready
               then Is_Ahead (After, A, B) =
                 (Priority_Of (After, A) > Priority_Of (After, B)
                  or else (Priority_Of (After, A) = Priority_Of (After, B)
                           and then Is_Ahead (Before, A, B))))));
      pragma Assert
        (for all A in TCB_Number =>
           (if A /= First and then Queue_Of (Last, A) = Ready
            then Is_Ahead (Before, A, First)));
      pragma Assert
        (for all A in TCB_Number =>
           (if A /= First and then Queue_Of (After, A) = Ready
            then Is_Ahead (After, First, A) = not Is_Ahead (After, A, First)));
   end Prove_Wake_Order;

   function Behind_Priority
     (S     : Scheduler;
      Level : Priority) return Integer is
   begin
      for Where in Running_Last (S) + 1 .. Ready_Last (S) loop
         if S.Blocks (TCB_At (S.Row, Place (Where))).Priority < Level then
            return Where;
         end if;
         pragma Loop_Invariant
           (for all Which in TCB_Number =>
              (if Place_Number (S, Which) in Running_Last (S) + 1 .. Where
               then Priority_Of (S, Which) >= Level));
      end loop;
      return Ready_Last (S) + 1;
   end Behind_Priority;

   function Behind_Tick
     (S       : Scheduler;
      Release : Tick) return Integer is
   begin
      for Where in Ready_Last (S) + 1 .. Timer_Last (S) loop
         if S.Blocks (TCB_At (S.Row, Place (Where))).Release > Release then
            return Where;
         end if;
         pragma Loop_Invariant
           (for all Which in TCB_Number =>
              (if Place_Number (S, Which) in Ready_Last (S) + 1 .. Where
               then Release_Of (S, Which) <= Release));
      end loop;
      return Timer_Last (S) + 1;
   end Behind_Tick;

   function Empty_Scheduler (Now : Clock_Tick) return Scheduler is
     ((Now => Now, others => <>));

   procedure Load (S : in out Scheduler; Header : Task_Header) is
      Before : constant Scheduler := S with Ghost;
      TCB    : constant TCB_Number := Next_Free_TCB (S);
      From   : constant Place := Place (Timer_Last (S) + 1);
      To     : Place;
   begin
      if Header.Start_Time <= S.Now then
         To := Place (Behind_Priority (S, Header.Initial_Priority));
         S.Ready := S.Ready + 1;
      else
         To := Place (Behind_Tick (S, Header.Start_Time));
         S.Sleeping := S.Sleeping + 1;
      end if;
      Move (S.Row, From, To);
      S.Blocks (TCB) :=
        (Id          => Header.Id,
         Priority    => Header.Initial_Priority,
         Release     => Header.Start_Time,
         New_Release => True,
         First_Run   => True);

      Prove_Order_After_Move (Before, S, TCB, To);
      pragma Assert
        (for all Which in TCB_Number =>
           (if Which /= TCB
            then Queue_Of (S, Which) = Queue_Of (Before, Which)));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other /= TCB
              and then Queue_Of (S, Other) = Queue_Of (S, TCB)
            then Place_Of (Before.Row, Other) < From));
      pragma Assert (Is_In_Its_Place (S, TCB));
      Prove_Queues_In_Order (Before, S, TCB);
      pragma Assert (Sleepers_Are_Not_Due (S));
   end Load;

   procedure Choose (S : in out Scheduler) is
      Chosen : constant TCB_Number := TCB_At (S.Row, 1);
   begin
      S.Busy := True;
      S.Ready := S.Ready - 1;
      if S.Blocks (Chosen).New_Release
        and then S.Blocks (Chosen).Release < S.Now
      then
         S.Late := Incremented (S.Late);
      end if;
      S.Blocks (Chosen).New_Release := False;
   end Choose;

   procedure Dispatch (S : in out Scheduler) is
   begin
      if not S.Busy and then S.Ready > 0 then
         Choose (S);
      end if;
   end Dispatch;

   procedure Load_Next
     (S     : in out Scheduler;
      Tree  : Task_Tree;
      Which : TCB_Number)
   is
      Before : constant Scheduler := S with Ghost;
   begin
      pragma Assert (Queue_Of (S, Which) = Free);
      Prove_Next_Free (S, Which);
      Load (S, Tree (Which));
      pragma Assert (Is_Loaded (S, Which, Tree (Which)));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other /= Which then Is_Unchanged (Before, S, Other)));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other > Which then Queue_Of (S, Other) = Free
            else Is_Loaded (S, Other, Tree (Other))));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other /= Which
              and then Queue_Of (S, Other) = Queue_Of (S, Which)
            then Other < Which
              and then Is_Ahead (S, Which, Other) =
                         not Is_Ahead (S, Other, Which)));
      pragma Assert
        (for all A in TCB_Number =>
           (for all B in TCB_Number =>
              (if A /= Which and then B /= Which
                 and then Queue_Of (S, A) = Queue_Of (S, B)
               then Is_Ahead (S, A, B) = Is_Ahead (Before, A, B))));
      pragma Assert (Equals_Are_In_Turn (S));
   end Load_Next;

   procedure Load_Tree
     (S    : out Scheduler;
      Tree : Task_Tree;
      Now  : Clock_Tick) is
   begin
      S := Empty_Scheduler (Now);
      for Which in Tree'Range loop
         if Tree (Which).Id = No_Task then
            pragma Assert
              (for all Later in Which .. TCB_Number'Last =>
                 not Is_In_Tree (Tree, Later));
            return;
         end if;
         Load_Next (S, Tree, Which);
         pragma Loop_Invariant (Is_Loaded_To (S, Tree, Integer (Which)));
         pragma Loop_Invariant (Clock (S) = Now);
         pragma Loop_Invariant (Is_In_Tree (Tree, Which));
      end loop;
   end Load_Tree;

   procedure Start
     (S    : out Scheduler;
      Tree : Task_Tree;
      Now  : Clock_Tick) is
   begin
      Load_Tree (S, Tree, Now);
      if S.Ready > 0 then
         declare
            Loaded : constant Scheduler := S with Ghost;
         begin
            Choose (S);
            Prove_Started (Loaded, S, Tree, Running_TCB (S));
         end;
      end if;
   end Start;

   procedure Wake_First (S : in out Scheduler; First : TCB_Number) is
      Before : constant Scheduler := S with Ghost;
      From   : constant Place := Place (Ready_Last (S) + 1);
      To     : constant Place :=
        Place (Behind_Priority (S, S.Blocks (First).Priority));
   begin
      Move (S.Row, From, To);
      S.Ready := S.Ready + 1;
      S.Sleeping := S.Sleeping - 1;

      Prove_Order_After_Move (Before, S, First, To);
      Prove_Queues_In_Order (Before, S, First);
   end Wake_First;

   procedure Wake_Due (S : in out Scheduler; Now : Clock_Tick) is
      Before : constant Scheduler := S with Ghost;
      Last   : Scheduler with Ghost;
      First  : TCB_Number;
   begin
      while Sleeper_Is_Due (S, Now) loop
         Last := S;
         First := TCB_At (S.Row, Place (Ready_Last (S) + 1));
         Wake_First (S, First);
         Prove_Wake_Order (Before, Last, S, First);

         pragma Loop_Variant (Decreases => S.Sleeping);
         pragma Loop_Invariant (Is_Sound (S));
         pragma Loop_Invariant (S.Blocks = Before.Blocks);
         pragma Loop_Invariant
           (S.Busy = Before.Busy
            and then S.Now = Before.Now
            and then S.Late = Before.Late);
         pragma Loop_Invariant
           (for all Which in TCB_Number =>
              (if Queue_Of (Before, Which) /= Timer
               then Queue_Of (S, Which) = Queue_Of (Before, Which)
               else Queue_Of (S, Which) = Timer
                 or else
                   (Queue_Of (S, Which) = Ready
                    and then Release_Of (S, Which) <= Now)));
         pragma Loop_Invariant (Is_In_Wake_Order (Before, S));
      end loop;

      Prove_None_Is_Due (S, Now);
   end Wake_Due;

   procedure Wake (S : in out Scheduler; Now : Clock_Tick) is
   begin
      Wake_Due (S, Now);
      S.Now := Now;
   end Wake;

   procedure Give_Way (S : in out Scheduler) is
      Before : constant Scheduler := S with Ghost;
      Caller : constant TCB_Number := TCB_At (S.Row, 1);
      To     : constant Place :=
        Place (Behind_Priority (S, S.Blocks (Caller).Priority) - 1);
   begin
      Move (S.Row, 1, To);
      S.Busy := False;
      S.Ready := S.Ready + 1;

      Prove_Order_After_Move (Before, S, Caller, To);
      Prove_Queues_In_Order (Before, S, Caller);
   end Give_Way;

   procedure Exit_Call (S : in out Scheduler) is
      Before : constant Scheduler := S with Ghost;
      Caller : constant TCB_Number := TCB_At (S.Row, 1);
   begin
      --  The best of the ready queue is at its head.
      if S.Ready > 0
        and then S.Blocks (TCB_At (S.Row, 2)).Priority >
                 S.Blocks (Caller).Priority
      then
         pragma Assert (Queue_Of (S, TCB_At (S.Row, 2)) = Ready);
         pragma Assert (Has_Higher_Ready (S));
         Give_Way (S);
         declare
            Waiting : constant Scheduler := S with Ghost;
            First   : constant TCB_Number := TCB_At (Before.Row, 2)
            with Ghost;
         begin
            pragma Assert (Queue_Of (Waiting, First) = Ready);
            Choose (S);
            pragma Assert (Running_TCB (S) /= Caller);
            Prove_Handed_Over
              (Before, Waiting, S, Caller, Best => Running_TCB (S));
         end;
      else
         pragma Assert
           (for all Which in TCB_Number =>
              (if Queue_Of (S, Which) = Ready
                 and then Which /= TCB_At (S.Row, 2)
               then Is_Ahead (S, TCB_At (S.Row, 2), Which)));
         pragma Assert (not Has_Higher_Ready (S));
      end if;
   end Exit_Call;

   procedure Sleep (S : in out Scheduler; Until_Tick : Tick) is
      Before  : constant Scheduler := S with Ghost;
      Caller  : constant TCB_Number := TCB_At (S.Row, 1);
      Release : constant Tick := Wake_Up_Tick (S.Now, Until_Tick);
      To      : constant Place := Place (Behind_Tick (S, Release) - 1);
   begin
      if Has_Overrun (S) then
         S.Late := Incremented (S.Late);
      end if;
      Move (S.Row, 1, To);
      S.Busy := False;
      S.Sleeping := S.Sleeping + 1;
      S.Blocks (Caller).Release := Release;
      S.Blocks (Caller).New_Release := True;
      S.Blocks (Caller).First_Run := False;

      Prove_Order_After_Move (Before, S, Caller, To);
      Prove_Queues_In_Order (Before, S, Caller);
   end Sleep;

   procedure Terminate_Caller (S : in out Scheduler) is
      Before : constant Scheduler := S with Ghost;
   begin
      Move (S.Row, 1, Place'Last);
      S.Busy := False;

      Prove_Order_After_Move
        (Before, S, Moved => Running_TCB (Before), To => Place'Last);
   end Terminate_Caller;

end URVOS.Schedulers;
