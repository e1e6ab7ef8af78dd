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

   --  The best ready task was the best before the caller came to it.
   procedure Prove_Best_Ready
     (Before, After : Scheduler;
      Caller, Best  : TCB_Number)
   with
     Ghost,
     Global => null,
     Pre    =>
       Best /= Caller
       and then Is_Best_Ready (After, Best)
       and then Before.Blocks = After.Blocks
       and then Queue_Of (Before, Caller) /= Ready
       and then
         (for all Which in TCB_Number =>
            (if Which /= Caller
             then Queue_Of (After, Which) = Queue_Of (Before, Which)))
       and then Order_Is_Kept (Before, After, Except => Caller),
     Post   => Is_Best_Ready (Before, Best);

   procedure Prove_Order_After_Move
     (Before, After : Scheduler;
      Moved         : TCB_Number;
      To            : Place) is null;

   procedure Prove_Queues_In_Order
     (Before, After : Scheduler;
      Moved         : TCB_Number) is null;

   procedure Prove_Best_Ready
     (Before, After : Scheduler;
      Caller, Best  : TCB_Number) is null;

   --  A task's TCB is as it was loaded.
   function Is_Loaded
     (S      : Scheduler;
      Which  : TCB_Number;
      Header : Task_Header) return Boolean
   is
     (Id_Of (S, Which) = Header.Id
      and then Priority_Of (S, Which) = Header.Initial_Priority
      and then Release_Of (S, Which) = Header.Start_Time
      and then Is_First_Run (S, Which)
      and then Queue_Of (S, Which) =
        (if Header.Start_Time <= Clock (S) then Ready else Timer))
   with
     Ghost,
     Global => null;

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
       and then
         (for all Which in TCB_Number =>
            (if Is_In_Tree (Tree, Which)
             then Is_Loaded (S, Which, Tree (Which))
             else Queue_Of (S, Which) = Free));

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
   --  being ahead of those that sleep on.
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
               then Is_Ahead (Before, A, B)))))
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

   procedure Dispatch (S : in out Scheduler) is
      Chosen : TCB_Number;
   begin
      if not S.Busy and then S.Ready > 0 then
         S.Busy := True;
         S.Ready := S.Ready - 1;
         Chosen := TCB_At (S.Row, 1);
         if S.Blocks (Chosen).New_Release
           and then S.Blocks (Chosen).Release < S.Now
         then
            S.Late := Incremented (S.Late);
         end if;
         S.Blocks (Chosen).New_Release := False;
      end if;
   end Dispatch;

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
         pragma Assert (Next_Free_TCB (S) = Which);
         Load (S, Tree (Which));
         pragma Loop_Invariant (Is_Sound (S));
         pragma Loop_Invariant (Is_Idle (S));
         pragma Loop_Invariant (Clock (S) = Now);
         pragma Loop_Invariant (Is_In_Tree (Tree, Which));
         pragma Loop_Invariant
           (for all I in TCB_Number'First .. Which =>
              Is_Loaded (S, I, Tree (I)));
         pragma Loop_Invariant
           (for all A in TCB_Number =>
              (if A > Which then Queue_Of (S, A) = Free));
         pragma Loop_Invariant
           (for all A in TCB_Number =>
              (for all B in TCB_Number =>
                 (if A > Which and then B > A then Is_Ahead (S, A, B))));
      end loop;
   end Load_Tree;

   procedure Start
     (S    : out Scheduler;
      Tree : Task_Tree;
      Now  : Clock_Tick) is
   begin
      Load_Tree (S, Tree, Now);
      Dispatch (S);
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

      --  Who sleeps on is behind one that is not due.
      pragma Assert
        (for all Which in TCB_Number =>
           (if Queue_Of (S, Which) = Timer
            then Release_Of (S, Which) > Now));
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
         Give_Way (S);
         declare
            Waiting : constant Scheduler := S with Ghost;
         begin
            Dispatch (S);
            Prove_Best_Ready (Before, Waiting, Caller, Running_TCB (S));
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
   begin
      Move (S.Row, 1, Place'Last);
      S.Busy := False;
   end Terminate_Caller;

end URVOS.Schedulers;
