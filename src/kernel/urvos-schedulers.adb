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
         Move (S.Row, From, To);
         S.Ready := S.Ready + 1;
      else
         To := Place (Behind_Tick (S, Header.Start_Time));
         Move (S.Row, From, To);
         S.Sleeping := S.Sleeping + 1;
      end if;
      S.Blocks (TCB) :=
        (Id          => Header.Id,
         Priority    => Header.Initial_Priority,
         Release     => Header.Start_Time,
         New_Release => True,
         First_Run   => True);

      pragma Assert (Place_Of (Before.Row, TCB) = From);
      pragma Assert (Place_Of (S.Row, TCB) = To and then To <= From);
      pragma Assert
        (for all Which in TCB_Number =>
           (if Which /= TCB
            then Place_Of (S.Row, Which) /= To
              and then Place_Of (Before.Row, Which) /= From
              and then Queue_Of (S, Which) = Queue_Of (Before, Which)
              and then S.Blocks (Which) = Before.Blocks (Which)));
      pragma Assert (Order_Is_Kept (Before, S, Except => TCB));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other /= TCB
              and then Queue_Of (S, Other) = Queue_Of (S, TCB)
            then Place_Of (Before.Row, Other) < From));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other /= TCB and then Place_Of (Before.Row, Other) < From
            then Is_Ahead (S, Other, TCB) =
                   (Place_Of (Before.Row, Other) < To)));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other /= TCB
              and then Queue_Of (S, Other) = Queue_Of (S, TCB)
            then Is_Ahead (S, Other, TCB) =
              (if Queue_Of (S, Other) = Ready
               then Priority_Of (S, Other) >= Header.Initial_Priority
               else Release_Of (S, Other) <= Header.Start_Time)));
      pragma Assert (Ready_In_Order (S));
      pragma Assert (Timer_In_Order (S));
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

   procedure Start
     (S    : out Scheduler;
      Tree : Task_Tree;
      Now  : Clock_Tick) is
   begin
      S := Empty_Scheduler (Now);
      pragma Assert
        (for all A in TCB_Number =>
           (for all B in TCB_Number => Is_Ahead (S, A, B) = (A < B)));
      for Which in Tree'Range loop
         exit when Tree (Which).Id = No_Task;
         Load (S, Tree (Which));
         pragma Loop_Invariant (Is_Sound (S));
         pragma Loop_Invariant (Is_Idle (S));
         pragma Loop_Invariant (Clock (S) = Now);
         pragma Loop_Invariant (Is_In_Tree (Tree, Which));
         pragma Loop_Invariant
           (for all I in TCB_Number =>
              (if I <= Which
               then Id_Of (S, I) = Tree (I).Id
                 and then Priority_Of (S, I) = Tree (I).Initial_Priority
                 and then Release_Of (S, I) = Tree (I).Start_Time
                 and then Is_First_Run (S, I)
                 and then Queue_Of (S, I) =
                   (if Tree (I).Start_Time <= Now then Ready else Timer)
               else Queue_Of (S, I) = Free));
         pragma Loop_Invariant
           (for all A in TCB_Number =>
              (for all B in TCB_Number =>
                 (if A > Which and then B > Which
                  then Is_Ahead (S, A, B) = (A < B))));
      end loop;
      Dispatch (S);
   end Start;

   procedure Wake (S : in out Scheduler; Now : Clock_Tick) is
      Before : constant Scheduler := S with Ghost;
      First  : TCB_Number;
   begin
      while S.Sleeping > 0 loop
         First := TCB_At (S.Row, Place (Ready_Last (S) + 1));
         exit when S.Blocks (First).Release > Now;
         Move
           (S.Row,
            Place (Ready_Last (S) + 1),
            Place (Behind_Priority (S, S.Blocks (First).Priority)));
         S.Ready := S.Ready + 1;
         S.Sleeping := S.Sleeping - 1;

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
         pragma Loop_Invariant
           (for all A in TCB_Number =>
              (for all B in TCB_Number =>
                 (if Queue_Of (S, A) = Ready and then Queue_Of (S, B) = Ready
                  then Is_Ahead (S, A, B) =
                    (Priority_Of (S, A) > Priority_Of (S, B)
                     or else (Priority_Of (S, A) = Priority_Of (S, B)
                              and then Is_Ahead (Before, A, B))))));
         pragma Loop_Invariant
           (for all A in TCB_Number =>
              (for all B in TCB_Number =>
                 (if Queue_Of (S, B) = Timer
                  then
                    (if Queue_Of (S, A) = Timer
                     then Is_Ahead (S, A, B) = Is_Ahead (Before, A, B)
                     elsif Queue_Of (S, A) = Ready
                     then Is_Ahead (Before, A, B)))));
      end loop;
      S.Now := Now;
   end Wake;

   procedure Exit_Call (S : in out Scheduler) is
      Before : constant Scheduler := S with Ghost;
      Caller : constant TCB_Number := TCB_At (S.Row, 1);
      Level  : constant Priority := S.Blocks (Caller).Priority;
      To     : constant Integer := Behind_Priority (S, Level) - 1;
   begin
      --  The best of the ready queue is at its head.
      if S.Ready = 0
        or else S.Blocks (TCB_At (S.Row, 2)).Priority <= Level
      then
         pragma Assert
           (for all Which in TCB_Number =>
              (if Queue_Of (S, Which) = Ready
                 and then Which /= TCB_At (S.Row, 2)
               then Is_Ahead (S, TCB_At (S.Row, 2), Which)));
         pragma Assert (not Has_Higher_Ready (S));
         return;
      end if;

      Move (S.Row, 1, Place (To));
      S.Busy := False;
      S.Ready := S.Ready + 1;

      pragma Assert (Place_Of (Before.Row, Caller) = 1);
      pragma Assert (Place_Of (S.Row, Caller) = Place (To));
      pragma Assert
        (for all Which in TCB_Number =>
           (if Which /= Caller
            then Place_Of (S.Row, Which) /= Place (To)
              and then Place_Of (Before.Row, Which) > 1
              and then Queue_Of (S, Which) = Queue_Of (Before, Which)));
      pragma Assert (Order_Is_Kept (Before, S, Except => Caller));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other /= Caller
            then Is_Ahead (S, Other, Caller) =
                   (Place_Of (Before.Row, Other) <= Place (To))));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other /= Caller and then Queue_Of (S, Other) = Ready
            then Is_Ahead (S, Other, Caller) =
                   (Priority_Of (S, Other) >= Level)));
      pragma Assert (Ready_In_Order (S));
      pragma Assert (Timer_In_Order (S));
      pragma Assert (Is_Ahead (S, TCB_At (Before.Row, 2), Caller));
      Dispatch (S);
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

      pragma Assert (Place_Of (Before.Row, Caller) = 1);
      pragma Assert (Place_Of (S.Row, Caller) = To);
      pragma Assert
        (for all Which in TCB_Number =>
           (if Which /= Caller
            then Place_Of (S.Row, Which) /= To
              and then Place_Of (Before.Row, Which) > 1
              and then Queue_Of (S, Which) = Queue_Of (Before, Which)
              and then S.Blocks (Which) = Before.Blocks (Which)));
      pragma Assert (Order_Is_Kept (Before, S, Except => Caller));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other /= Caller
            then Is_Ahead (S, Other, Caller) =
                   (Place_Of (Before.Row, Other) <= To)));
      pragma Assert
        (for all Other in TCB_Number =>
           (if Other /= Caller and then Queue_Of (S, Other) = Timer
            then Is_Ahead (S, Other, Caller) =
                   (Release_Of (S, Other) <= Release)));
      pragma Assert (Ready_In_Order (S));
      pragma Assert (Timer_In_Order (S));
   end Sleep;

   procedure Terminate_Caller (S : in out Scheduler) is
   begin
      Move (S.Row, 1, Place'Last);
      S.Busy := False;
   end Terminate_Caller;

end URVOS.Schedulers;
