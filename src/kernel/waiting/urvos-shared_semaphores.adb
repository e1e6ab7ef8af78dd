--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Shared_Semaphores with SPARK_Mode is

   protected body Flag is

      procedure Try_Claim
        (Caller  : Claimant;
         Claimed : out Boolean;
         Holder  : out Claimant)
      is
      begin
         Semaphores.Try_Claim (State, Caller, Claimed, Holder);
      end Try_Claim;

      procedure Release
        (Caller   : Claimant;
         Released : out Boolean;
         Holder   : out Task_Id)
      is
      begin
         Semaphores.Release (State, Caller, Released, Holder);
      end Release;

      procedure Reset is
      begin
         State := Available_Semaphore;
      end Reset;

      function Snapshot return Semaphore is (State);

   end Flag;

end URVOS.Shared_Semaphores;
