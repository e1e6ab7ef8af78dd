--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Alike_Schedulers with SPARK_Mode is

   --  What is the same is alike, and who is alike one that is alike a third
   --  is alike the third.

   procedure Prove_Equals_Are_Alike (One, Other : Scheduler)
   with
     Global => null,
     Pre    =>
       Is_The_Same (One, Other) or else Is_The_Same (Other, One),
     Post   => Are_Alike (One, Other);

   procedure Prove_Alike (First, Middle, Last : Scheduler)
   with
     Global => null,
     Pre    => Are_Alike (First, Middle) and then Are_Alike (Middle, Last),
     Post   => Are_Alike (First, Last);

   --  Among all but one the order is kept, in one scheduler and between two
   --  that were alike.

   procedure Prove_Others_Stand
     (Before, After : Scheduler;
      Except        : TCB_Number)
   with
     Global => null,
     Pre    =>
       Order_Is_Kept (Before, After, Except)
       and then Others_Stay (Before, After, Except),
     Post   => Others_Are_Alike (Before, After, Except);

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

   procedure Prove_Equals_Are_Alike (One, Other : Scheduler) is
   begin
      pragma Assert (Answers_Are_Alike (One, Other));
   end Prove_Equals_Are_Alike;

   procedure Prove_Alike (First, Middle, Last : Scheduler) is
      pragma Unreferenced (Middle);
   begin
      pragma Assert (Answers_Are_Alike (First, Last));
   end Prove_Alike;

   procedure Prove_Still_Alike
     (One_Before, One, Other_Before, Other : Scheduler) is
   begin
      Prove_Equals_Are_Alike (One, One_Before);
      Prove_Equals_Are_Alike (Other_Before, Other);
      Prove_Alike (One, One_Before, Other_Before);
      Prove_Alike (One, Other_Before, Other);
   end Prove_Still_Alike;

   procedure Prove_One_Is_Ahead (S : Scheduler) is
   begin
      pragma Assert (Places_Differ (S));
   end Prove_One_Is_Ahead;

   procedure Prove_Sleepers_Are_Behind (S : Scheduler) is null;

   procedure Prove_One_Best (S : Scheduler; A, B : TCB_Number) is null;

   procedure Prove_Others_Stand
     (Before, After : Scheduler;
      Except        : TCB_Number) is null;

   procedure Prove_Others_Are_Alike
     (One_Before, One, Other_Before, Other : Scheduler;
      Moved                                : TCB_Number) is null;

   procedure Prove_Orders_Are_Alike
     (One, Other : Scheduler;
      Moved      : TCB_Number) is
      pragma Unreferenced (Moved);
   begin
      Prove_One_Is_Ahead (One);
      Prove_One_Is_Ahead (Other);
   end Prove_Orders_Are_Alike;

   procedure Prove_Still_Alike_But
     (One_Before, One, Other_Before, Other : Scheduler;
      Moved                                : TCB_Number) is
   begin
      Prove_Others_Stand (One_Before, One, Moved);
      Prove_Others_Stand (Other_Before, Other, Moved);
      Prove_Others_Are_Alike (One_Before, One, Other_Before, Other, Moved);
      Prove_Orders_Are_Alike (One, Other, Moved);
      pragma Assert (Answers_Are_Alike (One, Other));
   end Prove_Still_Alike_But;

   procedure Prove_Others_Wait
     (Before, After : Scheduler;
      Caller, Best  : TCB_Number) is null;

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

   procedure Prove_Turns_Are_Alike (One, Other : Scheduler) is null;

end Theorems.Alike_Schedulers;
