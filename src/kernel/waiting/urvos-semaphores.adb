--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Semaphores with SPARK_Mode is

   procedure Try_Claim
     (This    : in out Semaphore;
      Caller  : Claimant;
      Claimed : out Boolean;
      Holder  : out Claimant)
   is
   begin
      Claimed := Is_Available (This);
      if Claimed then
         This.Claimed_By := Caller;
      end if;
      Holder := This.Claimed_By;
   end Try_Claim;

   procedure Release
     (This     : in out Semaphore;
      Caller   : Claimant;
      Released : out Boolean;
      Holder   : out Task_Id)
   is
   begin
      Released := This.Claimed_By = Caller;
      if Released then
         This.Claimed_By := No_Task;
      end if;
      Holder := This.Claimed_By;
   end Release;

end URVOS.Semaphores;
