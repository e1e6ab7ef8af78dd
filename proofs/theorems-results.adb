package body Theorems.Results with SPARK_Mode is

   --  Equals are alike, and who is alike one that is alike a third is alike
   --  the third.

   procedure Prove_Equals_Are_Alike (One, Other : Scheduler)
   with
     Global => null,
     Pre    => One = Other,
     Post   => Are_Alike (One, Other);

   procedure Prove_Equals_Are_Alike (One, Other : Scheduler) is null;

   procedure Prove_Alike (First, Middle, Last : Scheduler)
   with
     Global => null,
     Pre    => Are_Alike (First, Middle) and then Are_Alike (Middle, Last),
     Post   => Are_Alike (First, Last);

   procedure Prove_Alike (First, Middle, Last : Scheduler) is null;

   --  Both are still what they were.
   procedure Prove_Still_Alike
     (One_Before, One, Other_Before, Other : Scheduler)
   with
     Global => null,
     Pre    =>
       Are_Alike (One_Before, Other_Before)
       and then One = One_Before
       and then Other = Other_Before,
     Post   => Are_Alike (One, Other);

   procedure Prove_Still_Alike
     (One_Before, One, Other_Before, Other : Scheduler) is
   begin
      Prove_Equals_Are_Alike (One, One_Before);
      Prove_Equals_Are_Alike (Other_Before, Other);
      Prove_Alike (One, One_Before, Other_Before);
      Prove_Alike (One, Other_Before, Other);
   end Prove_Still_Alike;

   --  Of two TCBs one is ahead.
   function One_Is_Ahead (S : Scheduler) return Boolean is
     (for all A in TCB_Number =>
        (for all B in TCB_Number =>
           Is_Ahead (S, A, B) = (A /= B and then not Is_Ahead (S, B, A))))
   with Global => null;

   procedure Prove_One_Is_Ahead (S : Scheduler)
   with
     Global => null,
     Pre    => Is_Sound (S),
     Post   => One_Is_Ahead (S);

   procedure Prove_One_Is_Ahead (S : Scheduler) is null;

   --  Who is ready is ahead of who sleeps.
   procedure Prove_Sleepers_Are_Behind (S : Scheduler)
   with
     Global => null,
     Post   =>
       (for all A in TCB_Number =>
          (for all B in TCB_Number =>
             (if Queue_Of (S, A) = Ready and then Queue_Of (S, B) = Timer
              then Is_Ahead (S, A, B) and then not Is_Ahead (S, B, A))));

   procedure Prove_Sleepers_Are_Behind (S : Scheduler) is null;

   --  There is one best.
   procedure Prove_One_Best (S : Scheduler; A, B : TCB_Number)
   with
     Global => null,
     Pre    =>
       One_Is_Ahead (S)
       and then Is_Best_Ready (S, A)
       and then Is_Best_Ready (S, B),
     Post   => A = B;

   procedure Prove_One_Best (S : Scheduler; A, B : TCB_Number) is null;

   --  Among all but one, those that share a queue stand in the same order.
   function Others_Are_Alike
     (One, Other : Scheduler;
      Except     : TCB_Number) return Boolean
   is
     (for all A in TCB_Number =>
        (for all B in TCB_Number =>
           (if A /= Except and then B /= Except
              and then Queue_Of (One, A) = Queue_Of (One, B)
            then Is_Ahead (One, A, B) = Is_Ahead (Other, A, B))))
   with
     Global   => null,
     Annotate => (GNATprove, Inline_For_Proof);

   --  The queues are the same in both, of all but one.
   function Others_Stay
     (One, Other : Scheduler;
      Except     : TCB_Number) return Boolean
   is
     (for all Which in TCB_Number =>
        (if Which /= Except
         then Queue_Of (One, Which) = Queue_Of (Other, Which)))
   with
     Global   => null,
     Annotate => (GNATprove, Inline_For_Proof);

   procedure Prove_Others_Stand
     (Before, After : Scheduler;
      Except        : TCB_Number)
   with
     Global => null,
     Pre    =>
       Order_Is_Kept (Before, After, Except)
       and then Others_Stay (Before, After, Except),
     Post   => Others_Are_Alike (Before, After, Except);

   procedure Prove_Others_Stand
     (Before, After : Scheduler;
      Except        : TCB_Number) is null;

   --  The same TCB has changed its queue in two schedulers, and stands in
   --  both behind the same.

   procedure Prove_Others_Are_Alike
     (One_Before, One, Other_Before, Other : Scheduler;
      Moved                                : TCB_Number)
   with
     Global => null,
     Pre    =>
       Orders_Are_Alike (One_Before, Other_Before)
       and then Others_Stay (One_Before, One, Except => Moved)
       and then Others_Stay (One_Before, Other_Before, Except => Moved)
       and then Others_Are_Alike (One_Before, One, Except => Moved)
       and then Others_Are_Alike (Other_Before, Other, Except => Moved),
     Post   => Others_Are_Alike (One, Other, Except => Moved);

   procedure Prove_Others_Are_Alike
     (One_Before, One, Other_Before, Other : Scheduler;
      Moved                                : TCB_Number) is null;

   procedure Prove_Orders_Are_Alike
     (One, Other : Scheduler;
      Moved      : TCB_Number)
   with
     Global => null,
     Pre    =>
       One_Is_Ahead (One)
       and then One_Is_Ahead (Other)
       and then Others_Are_Alike (One, Other, Except => Moved)
       and then
         (for all Which in TCB_Number =>
            (if Which /= Moved
               and then Queue_Of (One, Which) = Queue_Of (One, Moved)
             then Is_Ahead (One, Which, Moved) =
                    Is_Ahead (Other, Which, Moved))),
     Post   => Orders_Are_Alike (One, Other);

   procedure Prove_Orders_Are_Alike
     (One, Other : Scheduler;
      Moved      : TCB_Number) is null;

   --  The processor has been handed over. Who had no part in it stands as it
   --  stood.
   procedure Prove_Others_Wait
     (Before, After : Scheduler;
      Caller, Best  : TCB_Number)
   with
     Global => null,
     Pre    => Is_Handed_Over (Before, After, Caller, Best),
     Post   =>
       Is_Best_Ready (Before, Best)
       and then
         (for all Which in TCB_Number =>
            Queue_Of (After, Which) =
              (if Which = Best then Running
               elsif Which = Caller then Ready
               else Queue_Of (Before, Which)))
       and then
         (for all A in TCB_Number =>
            (for all B in TCB_Number =>
               (if A not in Best | Caller and then B not in Best | Caller
                  and then Queue_Of (After, A) = Queue_Of (After, B)
                then Is_Ahead (After, A, B) = Is_Ahead (Before, A, B))));

   procedure Prove_Others_Wait
     (Before, After : Scheduler;
      Caller, Best  : TCB_Number) is null;

   --  So it has in both, between the same two.
   procedure Prove_Others_Wait_Alike
     (One_Before, One, Other_Before, Other : Scheduler;
      Caller, Best                         : TCB_Number)
   with
     Global => null,
     Pre    =>
       One_Is_Ahead (One)
       and then One_Is_Ahead (Other)
       and then Orders_Are_Alike (One_Before, Other_Before)
       and then Is_Handed_Over (One_Before, One, Caller, Best)
       and then Is_Handed_Over (Other_Before, Other, Caller, Best)
       and then
         (for all Which in TCB_Number =>
            Queue_Of (One_Before, Which) = Queue_Of (Other_Before, Which)
            and then (Queue_Of (One_Before, Which) = Running)
                     = (Which = Caller)),
     Post   => Others_Are_Alike (One, Other, Except => Caller);

   procedure Prove_Others_Wait_Alike
     (One_Before, One, Other_Before, Other : Scheduler;
      Caller, Best                         : TCB_Number) is
   begin
      Prove_Others_Wait (One_Before, One, Caller, Best);
      Prove_Others_Wait (Other_Before, Other, Caller, Best);
      pragma Assert
        (for all Which in TCB_Number =>
           (if Queue_Of (One, Which) = Running then Which = Best));
   end Prove_Others_Wait_Alike;

   procedure Of_Move
     (Row      : Arrangement;
      From, To : Arrangements.Place;
      Same     : out Boolean)
   is
      One, Other : Arrangement := Row;
   begin
      Move (One, From, To);
      Move (Other, From, To);
      Same :=
        (for all Which in TCB_Number =>
           Place_Of (One, Which) = Place_Of (Other, Which))
        and then (for all Where in Arrangements.Place =>
             TCB_At (One, Where) = TCB_At (Other, Where));
   end Of_Move;

   procedure Of_Add
     (Log       : Error_Log;
      Which     : Kind;
      Now       : Clock_Tick;
      Detail    : Word;
      How_Often : Positive_Count;
      Same      : out Boolean)
   is
      One, Other : Error_Log := Log;
   begin
      Add (One, Which, Now, Detail, How_Often);
      Add (Other, Which, Now, Detail, How_Often);
      Same :=
        (for all Each in Kind =>
           History_Of (One, Each) = History_Of (Other, Each))
        and then Total (One) = Total (Other)
        and then Latest (One) = Latest (Other);
   end Of_Add;

   procedure Of_Send
     (Box  : Mailbox;
      Item : Word;
      Same : out Boolean)
   is
      One, Other       : Mailbox := Box;
      Success, As_Well : Boolean;
   begin
      Send (One, Item, Success);
      Send (Other, Item, As_Well);
      Same :=
        Contents (One) = Contents (Other)
        and then Produced (One) = Produced (Other)
        and then Consumed (One) = Consumed (Other)
        and then Misses (One) = Misses (Other)
        and then Success = As_Well;
   end Of_Send;

   procedure Of_Look
     (Box  : Mailbox;
      Same : out Boolean)
   is
      One, Other     : Mailbox := Box;
      Item, Its_Like : Word;
      Fresh, As_Well : Boolean;
   begin
      Look (One, Item, Fresh);
      Look (Other, Its_Like, As_Well);
      Same :=
        Contents (One) = Contents (Other)
        and then Produced (One) = Produced (Other)
        and then Consumed (One) = Consumed (Other)
        and then Misses (One) = Misses (Other)
        and then Item = Its_Like
        and then Fresh = As_Well;
   end Of_Look;

   procedure Of_Receive
     (Box  : Mailbox;
      Same : out Boolean)
   is
      One, Other     : Mailbox := Box;
      Item, Its_Like : Word;
      Fresh, As_Well : Boolean;
   begin
      Receive (One, Item, Fresh);
      Receive (Other, Its_Like, As_Well);
      Same :=
        Contents (One) = Contents (Other)
        and then Produced (One) = Produced (Other)
        and then Consumed (One) = Consumed (Other)
        and then Misses (One) = Misses (Other)
        and then Item = Its_Like
        and then Fresh = As_Well;
   end Of_Receive;

   procedure Of_Take_Byte
     (Item : Check;
      Data : Byte;
      Same : out Boolean)
   is
      One, Other        : Check := Item;
      Outcome, Its_Like : Outcome_Kind;
   begin
      Take_Byte (One, Data, Outcome);
      Take_Byte (Other, Data, Its_Like);
      Same :=
        One = Other
        and then Outcome = Its_Like;
   end Of_Take_Byte;

   procedure Of_Try_Claim
     (Item   : Semaphore;
      Caller : Claimant;
      Same   : out Boolean)
   is
      One, Other       : Semaphore := Item;
      Claimed, As_Well : Boolean;
      Holder, Its_Like : Claimant;
   begin
      Try_Claim (One, Caller, Claimed, Holder);
      Try_Claim (Other, Caller, As_Well, Its_Like);
      Same :=
        Owner (One) = Owner (Other)
        and then Claimed = As_Well
        and then Holder = Its_Like;
   end Of_Try_Claim;

   procedure Of_Release
     (Item   : Semaphore;
      Caller : Claimant;
      Same   : out Boolean)
   is
      One, Other        : Semaphore := Item;
      Released, As_Well : Boolean;
      Holder, Its_Like  : Task_Id;
   begin
      Release (One, Caller, Released, Holder);
      Release (Other, Caller, As_Well, Its_Like);
      Same :=
        Owner (One) = Owner (Other)
        and then Released = As_Well
        and then Holder = Its_Like;
   end Of_Release;

   procedure Of_Note_Look
     (Item : Wait;
      Now  : Clock_Tick;
      Same : out Boolean)
   is
      One, Other : Wait := Item;
   begin
      Note_Look (One, Now);
      Note_Look (Other, Now);
      Same :=
        Ticks_Left (One) = Ticks_Left (Other)
        and then Last_Seen (One) = Last_Seen (Other)
        and then Looks (One) = Looks (Other);
   end Of_Note_Look;

   procedure Of_Questions (One, Other : Scheduler) is
   begin
      if not Is_Idle (One) then
         pragma Assert (Queue_Of (One, Running_TCB (One)) = Running);
         pragma Assert (Queue_Of (Other, Running_TCB (One)) = Running);
      end if;
   end Of_Questions;

   procedure Of_Start
     (Tree       : Task_Tree;
      Now        : Clock_Tick;
      One, Other : out Scheduler) is
   begin
      Start (One, Tree, Now);
      Start (Other, Tree, Now);
   end Of_Start;

   procedure Of_Load
     (One, Other : in out Scheduler;
      Header     : Task_Header) is
      One_Before   : constant Scheduler := One;
      Other_Before : constant Scheduler := Other;
      Moved        : constant TCB_Number := Next_Free_TCB (One);
   begin
      Of_Questions (One, Other);
      Load (One, Header);
      Load (Other, Header);
      Prove_Others_Stand (One_Before, One, Moved);
      Prove_Others_Stand (Other_Before, Other, Moved);
      Prove_Others_Are_Alike (One_Before, One, Other_Before, Other, Moved);
      Prove_One_Is_Ahead (One);
      Prove_One_Is_Ahead (Other);
      Prove_Orders_Are_Alike (One, Other, Moved);
   end Of_Load;

   procedure Of_Dispatch (One, Other : in out Scheduler) is
      One_Before   : constant Scheduler := One;
      Other_Before : constant Scheduler := Other;
      Moved        : TCB_Number;
   begin
      pragma Assert
        (for all Which in TCB_Number =>
           Queue_Of (One_Before, Which) = Queue_Of (Other_Before, Which));
      Of_Questions (One, Other);
      Dispatch (One);
      Dispatch (Other);
      if Is_Idle (One_Before) and then not Is_Settled (One_Before) then
         Moved := Running_TCB (One);
         Prove_One_Is_Ahead (One_Before);
         Prove_One_Best (One_Before, Moved, Running_TCB (Other));
         pragma Assert (Running_TCB (Other) = Moved);
         pragma Assert
           (for all Which in TCB_Number =>
              Queue_Of (One, Which) =
                (if Which = Moved then Running
                 else Queue_Of (One_Before, Which)));
         pragma Assert
           (for all Which in TCB_Number =>
              Queue_Of (Other, Which) =
                (if Which = Moved then Running
                 else Queue_Of (Other_Before, Which)));
         pragma Assert
           (for all Which in TCB_Number =>
              Queue_Of (One, Which) = Queue_Of (Other, Which));
         Prove_Others_Stand (One_Before, One, Moved);
         Prove_Others_Stand (Other_Before, Other, Moved);
         Prove_Others_Are_Alike (One_Before, One, Other_Before, Other, Moved);
         Prove_One_Is_Ahead (One);
         Prove_One_Is_Ahead (Other);
         Prove_Orders_Are_Alike (One, Other, Moved);
         pragma Assert (Are_Alike (One, Other));
      else
         Prove_Still_Alike (One_Before, One, Other_Before, Other);
      end if;
   end Of_Dispatch;

   procedure Of_Wake (One, Other : in out Scheduler; Now : Clock_Tick) is
   begin
      Prove_Sleepers_Are_Behind (One);
      Prove_Sleepers_Are_Behind (Other);
      Wake (One, Now);
      Wake (Other, Now);
      Prove_One_Is_Ahead (One);
      Prove_One_Is_Ahead (Other);
   end Of_Wake;

   procedure Of_Exit_Call (One, Other : in out Scheduler) is
      One_Before   : constant Scheduler := One;
      Other_Before : constant Scheduler := Other;
      Caller       : constant TCB_Number := Running_TCB (One);
      Best         : TCB_Number;
   begin
      pragma Assert
        (for all Which in TCB_Number =>
           Queue_Of (One_Before, Which) = Queue_Of (Other_Before, Which));
      Of_Questions (One_Before, Other_Before);
      Exit_Call (One);
      Exit_Call (Other);
      if Has_Higher_Ready (One_Before) then
         Best := Running_TCB (One);
         Prove_Others_Wait (One_Before, One, Caller, Best);
         Prove_Others_Wait (Other_Before, Other, Caller, Running_TCB (Other));
         pragma Assert (Is_Best_Ready (One_Before, Running_TCB (Other)));
         Prove_One_Is_Ahead (One_Before);
         Prove_One_Best (One_Before, Best, Running_TCB (Other));
         pragma Assert (Running_TCB (Other) = Best);
         pragma Assert
           (for all Which in TCB_Number =>
              Queue_Of (One, Which) = Queue_Of (Other, Which));
         Prove_One_Is_Ahead (One);
         Prove_One_Is_Ahead (Other);
         Prove_Others_Wait_Alike
           (One_Before, One, Other_Before, Other, Caller, Best);
         Prove_Orders_Are_Alike (One, Other, Caller);
         pragma Assert (Are_Alike (One, Other));
      else
         Prove_Still_Alike (One_Before, One, Other_Before, Other);
      end if;
   end Of_Exit_Call;

   procedure Of_Sleep (One, Other : in out Scheduler; Until_Tick : Tick) is
      One_Before   : constant Scheduler := One;
      Other_Before : constant Scheduler := Other;
      Moved        : constant TCB_Number := Running_TCB (One);
   begin
      Of_Questions (One, Other);
      Sleep (One, Until_Tick);
      Sleep (Other, Until_Tick);
      pragma Assert (Release_Of (One, Moved) = Release_Of (Other, Moved));
      pragma Assert (Is_Unchanged (One, Other, Moved));
      Prove_Others_Stand (One_Before, One, Moved);
      Prove_Others_Stand (Other_Before, Other, Moved);
      Prove_Others_Are_Alike (One_Before, One, Other_Before, Other, Moved);
      Prove_One_Is_Ahead (One);
      Prove_One_Is_Ahead (Other);
      Prove_Orders_Are_Alike (One, Other, Moved);
   end Of_Sleep;

   procedure Of_Terminate_Caller (One, Other : in out Scheduler) is
      One_Before   : constant Scheduler := One;
      Other_Before : constant Scheduler := Other;
      Moved        : constant TCB_Number := Running_TCB (One);
   begin
      Of_Questions (One, Other);
      Terminate_Caller (One);
      Terminate_Caller (Other);
      Prove_Others_Stand (One_Before, One, Moved);
      Prove_Others_Stand (Other_Before, Other, Moved);
      Prove_Others_Are_Alike (One_Before, One, Other_Before, Other, Moved);
      Prove_One_Is_Ahead (One);
      Prove_One_Is_Ahead (Other);
      Prove_Orders_Are_Alike (One, Other, Moved);
   end Of_Terminate_Caller;

   procedure Of_Take
     (Pair : Buffer_Pair;
      Same : out Boolean)
   is
      One, Other     : Buffer_Pair := Pair;
      Data, Its_Like : Block_Data;
      Fresh, As_Well : Boolean;
   begin
      Take (One, Data, Fresh);
      Take (Other, Its_Like, As_Well);
      Same :=
        One = Other
        and then Data = Its_Like
        and then Fresh = As_Well;
   end Of_Take;

   procedure Of_Put
     (Pair : Buffer_Pair;
      Data : Block_Data;
      Same : out Boolean)
   is
      One, Other         : Buffer_Pair := Pair;
      Overwrote, As_Well : Boolean;
   begin
      Put (One, Data, Overwrote);
      Put (Other, Data, As_Well);
      Same :=
        One = Other
        and then Overwrote = As_Well;
   end Of_Put;

   procedure Of_Store
     (Item  : Scan;
      Value : Word;
      Same  : out Boolean)
   is
      One, Other     : Scan := Item;
      Next, Its_Like : Next_Step;
   begin
      Store (One, Value, Next);
      Store (Other, Value, Its_Like);
      Same :=
        One = Other
        and then Next = Its_Like;
   end Of_Store;

end Theorems.Results;
