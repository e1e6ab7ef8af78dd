--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Semaphores with SPARK_Mode is

   procedure Try_Claim
     (Item    : in out Semaphore;
      Caller  : Claimant;
      Claimed : out Boolean;
      Holder  : out Claimant)
   is
   begin
      Claimed := Is_Available (Item);
      if Claimed then
         Item.Claimed_By := Caller;
      end if;
      Holder := Item.Claimed_By;
   end Try_Claim;

   procedure Release
     (Item     : in out Semaphore;
      Caller   : Claimant;
      Released : out Boolean;
      Holder   : out Task_Id)
   is
   begin
      Released := Item.Claimed_By = Caller;
      if Released then
         Item.Claimed_By := No_Task;
      end if;
      Holder := Item.Claimed_By;
   end Release;

end URVOS.Semaphores;
