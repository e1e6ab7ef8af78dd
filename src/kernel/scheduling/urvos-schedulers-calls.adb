--  SPDX-License-Identifier: Apache-2.0

with URVOS.Schedulers.Lemmas; use URVOS.Schedulers.Lemmas;
with URVOS.Schedulers.Places; use URVOS.Schedulers.Places;

package body URVOS.Schedulers.Calls with SPARK_Mode is

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
            then Queue_Of (S, Which) = Queue_Of (Before, Which)
              and then S.Blocks (Which) = Before.Blocks (Which)));
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
      Before : constant Scheduler := S with Ghost;
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
      pragma Assert
        (for all Which in TCB_Number =>
           Queue_Of (S, Which) =
             (if Which = Chosen then Running else Queue_Of (Before, Which)));
      pragma Assert
        (for all Which in TCB_Number =>
           Place_Of (S.Row, Which) = Place_Of (Before.Row, Which)
           and then
             (if Which /= Chosen
              then S.Blocks (Which) = Before.Blocks (Which)));
      Prove_Queues_In_Order (Before, S, Chosen);
      Prove_Sleepers_Stay (Before, S);
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
      Prove_Next_Free (S, Which);
      Load (S, Tree (Which));
      pragma Assert (Is_Loaded (S, Which, Tree (Which)));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other /= Which then Is_Unchanged (Before, S, Other)));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other /= Which
              and then Queue_Of (S, Other) = Queue_Of (S, Which)
            then Other < Which
              and then Is_Ahead (S, Which, Other) =
                         not Is_Ahead (S, Other, Which)));
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
      pragma Assert
        (for all Which in TCB_Number =>
           (if Which /= First
            then Queue_Of (S, Which) = Queue_Of (Before, Which)
              and then S.Blocks (Which) = Before.Blocks (Which)));
      pragma Assert (Is_In_Its_Place (S, First));
      Prove_Queues_In_Order (Before, S, First);
   end Wake_First;

   procedure Wake_Due (S : in out Scheduler; Now : Clock_Tick) is
      Before : constant Scheduler := S with Ghost;
      Last   : Scheduler with Ghost;
      First  : TCB_Number;
   begin
      pragma Assert
        (for all A in TCB_Number =>
           (for all B in TCB_Number =>
              (if A /= B then Is_Ahead (S, A, B) = not Is_Ahead (S, B, A))));
      pragma Assert (Is_In_Wake_Order (Before, S));
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
      declare
         Woken : constant Scheduler := S with Ghost;
      begin
         S.Now := Now;
         pragma Assert
           (for all Which in TCB_Number =>
              Queue_Of (S, Which) = Queue_Of (Woken, Which)
              and then Place_Of (S.Row, Which) = Place_Of (Woken.Row, Which));
         pragma Assert (Ready_In_Order (S));
         pragma Assert (Timer_In_Order (S));
      end;
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
      pragma Assert
        (for all Which in TCB_Number =>
           (if Which /= Caller
            then Queue_Of (S, Which) = Queue_Of (Before, Which)
              and then S.Blocks (Which) = Before.Blocks (Which)));
      pragma Assert (Is_In_Its_Place (S, Caller));
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
         begin
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
      pragma Assert
        (for all Which in TCB_Number =>
           (if Which /= Caller
            then Queue_Of (S, Which) = Queue_Of (Before, Which)
              and then S.Blocks (Which) = Before.Blocks (Which)));
      pragma Assert (Is_In_Its_Place (S, Caller));
      Prove_Queues_In_Order (Before, S, Caller);
   end Sleep;

   procedure Terminate_Caller (S : in out Scheduler) is
      Before : constant Scheduler := S with Ghost;
   begin
      Move (S.Row, 1, Place'Last);
      S.Busy := False;

      Prove_Order_After_Move
        (Before, S, Moved => Running_TCB (Before), To => Place'Last);
      pragma Assert
        (for all Which in TCB_Number =>
           Queue_Of (S, Which) =
             (if Which = Running_TCB (Before)
              then Free
              else Queue_Of (Before, Which)));
      Prove_Queues_In_Order (Before, S, Moved => Running_TCB (Before));
      Prove_Sleepers_Stay (Before, S);
   end Terminate_Caller;

end URVOS.Schedulers.Calls;
