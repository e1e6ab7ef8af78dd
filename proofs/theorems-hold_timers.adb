--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Hold_Timers with SPARK_Mode is

   procedure Without_A_Controller_The_Outputs_Are_Safe
     (Item : in out Board_State; Ticks : Positive)
   is
      Before : constant Board_State := Item;
      Safe   : constant Data_Area := Unattended_Area (Item.Words);
   begin
      for Tick in 1 .. Ticks loop
         pragma Loop_Invariant
           (Item.Words = Safe
            or else
              (Item.Words = Before.Words
               and then Natural (Item.Untouched) >= Tick - 1
               and then Item.Untouched < Hold_Ticks)
            or else (Item = Before and then Tick = 1));
         pragma Loop_Invariant
           (Item.Words (Channel_Of (Brake)) =
              Before.Words (Channel_Of (Brake)));
         Item := Ticked (Item, Unattended_Area (Item.Words));
      end loop;
   end Without_A_Controller_The_Outputs_Are_Safe;

   procedure With_A_Controller_Nothing_Moves
     (Item : in out Board_State; Gaps : Gap_List)
   is
      Before : constant Board_State := Item;
   begin
      for Each of Gaps loop
         pragma Loop_Invariant (Item = Before);
         for Tick in 1 .. Each loop
            pragma Loop_Invariant (Item.Words = Before.Words);
            pragma Loop_Invariant (Item.Changed = Before.Changed);
            pragma Loop_Invariant (Gap (Item.Untouched) = Tick - 1);
            Item := Ticked (Item, Unattended_Area (Item.Words));
         end loop;
         Item := Touched (Item);
      end loop;
   end With_A_Controller_Nothing_Moves;

   procedure A_Write_Is_Obeyed (Item : Board_State; Area : Data_Area)
   is null;

end Theorems.Hold_Timers;
