--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Schedulers.Lemmas with SPARK_Mode is

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

   procedure Prove_Sleepers_Stay (Before, After : Scheduler) is null;

   procedure Prove_Next_Free (S : Scheduler; Which : TCB_Number) is
      First : constant TCB_Number :=
        TCB_At (S.Row, Place (Timer_Last (S) + 1));
   begin
      pragma Assert (Queue_Of (S, First) = Free);
      pragma Assert (not Is_Ahead (S, Which, First));
   end Prove_Next_Free;

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
      pragma Assert
        (for all Which in TCB_Number =>
           Priority_Of (After, Which) = Priority_Of (Loaded, Which)
           and then Release_Of (After, Which) = Release_Of (Loaded, Which));
      pragma Assert
        (for all A in TCB_Number =>
           (for all B in TCB_Number =>
              Is_Ahead (After, A, B) = Is_Ahead (Loaded, A, B)));
      pragma Assert
        (for all A in TCB_Number =>
           (for all B in TCB_Number =>
              (if Queue_Of (After, A) = Queue_Of (After, B)
               then
                 (if Queue_Of (After, A) = Running
                  then A = B
                  else Queue_Of (Loaded, A) = Queue_Of (After, A)
                    and then Queue_Of (Loaded, B) = Queue_Of (After, B)))));
   end Prove_Started;

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

end URVOS.Schedulers.Lemmas;
