--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Scheduling with SPARK_Mode is

   --  A choice changes only the chosen task.
   procedure Prove_Choice (S : Scheduler)
   with
     Global => null,
     Post   =>
       (for all Which in TCB_Number =>
          TCB (After_Dispatch (S), Which).Release = TCB (S, Which).Release
          and then TCB (After_Dispatch (S), Which).Ready_At =
                     TCB (S, Which).Ready_At
          and then TCB (After_Dispatch (S), Which).Priority =
                     TCB (S, Which).Priority
          and then Queue_Of (After_Dispatch (S), Which) =
            (if Is_Idle (S) and then Which = Head_Of (S, Ready)
             then Running
             else Queue_Of (S, Which)));

   --  Composes two steps, from First to Middle and on to Last

   procedure Prove_Kept (First, Middle, Last : Scheduler)
   with
     Global => null,
     Pre    => Are_Kept (First, Middle) and then Are_Kept (Middle, Last),
     Post   => Are_Kept (First, Last);

   procedure Prove_Not_Early (First, Middle, Last : Scheduler)
   with
     Global => null,
     Pre    =>
       Clock (First) <= Clock (Middle)
       and then Clock (Middle) <= Clock (Last)
       and then No_Task_Is_Woken_Early (First, Middle)
       and then No_Task_Is_Woken_Early (Middle, Last),
     Post   => No_Task_Is_Woken_Early (First, Last);

   procedure Prove_Choice (S : Scheduler) is null;

   procedure Prove_Kept (First, Middle, Last : Scheduler) is null;

   procedure Prove_Not_Early (First, Middle, Last : Scheduler) is null;

   procedure One_Call (S : Scheduler; Call : Scheduler_Call) is
      Next : constant Scheduler := After (S, Call);
   begin
      if not Is_Allowed (S, Call) then
         return;
      end if;
      case Call.Kind is
         when Loads =>
            pragma Assert (Are_Kept (S, Next, Head_Of (S, Free)));
            pragma Assert (No_Task_Is_Woken_Early (S, Next));
            pragma Assert
              (if Sleepers_Wait_For_Release (S)
               then Sleepers_Wait_For_Release (Next));
         when Dispatches =>
            Prove_Choice (S);
            pragma Assert (Are_Kept (S, Next));
            pragma Assert (No_Task_Is_Woken_Early (S, Next));
            pragma Assert
              (if Sleepers_Wait_For_Release (S)
               then Sleepers_Wait_For_Release (Next));
         when Wakes =>
            pragma Assert (Are_Kept (S, Next));
            pragma Assert (No_Task_Is_Woken_Early (S, Next));
            pragma Assert
              (if Sleepers_Wait_For_Release (S)
               then Sleepers_Wait_For_Release (Next));
         when Exits =>
            pragma Assert (Are_Kept (S, Next));
            pragma Assert (No_Task_Is_Woken_Early (S, Next));
            pragma Assert
              (if Sleepers_Wait_For_Release (S)
               then Sleepers_Wait_For_Release (Next));
         when Sleeps =>
            pragma Assert (Are_Kept (S, Next));
            pragma Assert (No_Task_Is_Woken_Early (S, Next));
            pragma Assert
              (if Sleepers_Wait_For_Release (S)
               then Sleepers_Wait_For_Release (Next));
         when Terminates =>
            pragma Assert (Are_Kept (S, Next, Running_TCB (S)));
            pragma Assert (No_Task_Is_Woken_Early (S, Next));
            pragma Assert
              (if Sleepers_Wait_For_Release (S)
               then Sleepers_Wait_For_Release (Next));
      end case;
   end One_Call;

   procedure Any_Calls (S : Scheduler; Calls : Call_Sequence) is
   begin
      for Number in Calls'Range loop
         One_Call (After_All (S, Calls, Number - 1), Calls (Number));
         if (for all J in 1 .. Number =>
               Calls (J).Kind not in Loads | Terminates)
         then
            Prove_Kept
              (S, After_All (S, Calls, Number - 1),
               After_All (S, Calls, Number));
         end if;
         Prove_Not_Early
           (S, After_All (S, Calls, Number - 1), After_All (S, Calls, Number));
         pragma Loop_Invariant
           (Clock (After_All (S, Calls, Number)) >= Clock (S));
         pragma Loop_Invariant
           (if (for all J in 1 .. Number =>
                  Calls (J).Kind not in Loads | Terminates)
            then Are_Kept (S, After_All (S, Calls, Number)));
         pragma Loop_Invariant
           (No_Task_Is_Woken_Early (S, After_All (S, Calls, Number)));
         pragma Loop_Invariant
           (if Sleepers_Wait_For_Release (S)
            then Sleepers_Wait_For_Release (After_All (S, Calls, Number)));
      end loop;
   end Any_Calls;

   procedure Start_Loads_The_Tree (Tree : Task_Tree; Now : Clock_Tick) is
      S : constant Scheduler := Loaded_Tree (Tree, Now);
   begin
      pragma Assert (Sleepers_Wait_For_Release (S));
      Prove_Choice (S);
   end Start_Loads_The_Tree;

   procedure Dispatch_Chooses_The_Best (S : Scheduler) is
   begin
      Prove_Choice (S);
   end Dispatch_Chooses_The_Best;

   procedure Exit_Chooses_The_Best (S : Scheduler) is
   begin
      if Has_Higher_Ready (S) then
         pragma Assert
           (for all Which in TCB_Number =>
              (if Queue_Of (After_Exit (S), Which) = Ready
                 and then Which /= Running_TCB (S)
               then Queue_Of (S, Which) = Ready));
      end if;
   end Exit_Chooses_The_Best;

   procedure First_Come_First_Served (S : Scheduler; Call : Scheduler_Call) is
      Next : constant Scheduler := After (S, Call);
      Head : constant TCB_Count := Head_Of (S, Free);
   begin
      case Call.Kind is
         when Loads =>
            pragma Assert (Order_Is_Kept (S, Next, Head));
            if Call.Header.Start_Time <= Clock (S) then
               pragma Assert (Is_Behind_Equals (Next, Head));
            end if;
         when Dispatches =>
            Prove_Choice (S);
            pragma Assert (Order_Is_Kept (S, Next));
         when Wakes =>
            pragma Assert (Order_Is_Kept (S, Next));
         when Exits =>
            if Has_Higher_Ready (S) then
               pragma Assert
                 (for all Which in TCB_Number =>
                    (if Which /= Running_TCB (S)
                     then TCB (Next, Which).Priority =
                            TCB (S, Which).Priority
                       and then TCB (Next, Which).Ready_At =
                                  TCB (S, Which).Ready_At));
               pragma Assert
                 (for all A in TCB_Number =>
                    (for all B in TCB_Number =>
                       (if A /= Running_TCB (S) and then B /= Running_TCB (S)
                        then Came_First (Next, A, B) =
                               Came_First (S, A, B))));
               pragma Assert (Order_Is_Kept (S, Next, Running_TCB (S)));
               pragma Assert (Is_Behind_Equals (Next, Running_TCB (S)));
            end if;
         when Sleeps =>
            pragma Assert (Order_Is_Kept (S, Next, Running_TCB (S)));
         when Terminates =>
            pragma Assert (Order_Is_Kept (S, Next, Running_TCB (S)));
            pragma Assert (Is_Behind_Equals (Next, Running_TCB (S)));
      end case;
   end First_Come_First_Served;

   procedure Sleepers_Wake_In_Order (S : Scheduler; Now : Clock_Tick) is null;

end Theorems.Scheduling;
