--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Scheduler_Results with SPARK_Mode is

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
      pragma Assert (Is_Idle (One) = Is_Idle (Other));
      if not Is_Idle (One) then
         pragma Assert (Running_TCB (One) = Running_TCB (Other));
      end if;
      pragma Assert
        (for all Which in TCB_Number =>
           Queue_Of (One, Which) = Queue_Of (Other, Which));
      Prove_Turns_Are_Alike (One, Other);
      pragma Assert (Answers_Are_Alike (One, Other));
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
      Prove_Still_Alike_But (One_Before, One, Other_Before, Other, Moved);
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
         Prove_Still_Alike_But (One_Before, One, Other_Before, Other, Moved);
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
      pragma Assert (Answers_Are_Alike (One, Other));
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
         pragma Assert (Is_The_Best (One_Before, Running_TCB (Other)));
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
         pragma Assert (Answers_Are_Alike (One, Other));
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
      Prove_Still_Alike_But (One_Before, One, Other_Before, Other, Moved);
   end Of_Sleep;

   procedure Of_Terminate_Caller (One, Other : in out Scheduler) is
      One_Before   : constant Scheduler := One;
      Other_Before : constant Scheduler := Other;
      Moved        : constant TCB_Number := Running_TCB (One);
   begin
      Of_Questions (One, Other);
      Terminate_Caller (One);
      Terminate_Caller (Other);
      Prove_Still_Alike_But (One_Before, One, Other_Before, Other, Moved);
   end Of_Terminate_Caller;

end Theorems.Scheduler_Results;
