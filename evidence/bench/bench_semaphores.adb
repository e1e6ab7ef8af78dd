--  SPDX-License-Identifier: Apache-2.0

with URVOS.Semaphores; use URVOS.Semaphores;
with URVOS.Shared_Semaphores;
with URVOS.Task_Trees; use URVOS.Task_Trees;

package body Bench_Semaphores is

   Item : URVOS.Shared_Semaphores.Flag;

   procedure Claim_And_Release (Turn : Positive) is
      pragma Unreferenced (Turn);
      Claimed  : Boolean;
      Released : Boolean;
      Other    : Claimant;
      Holder   : Task_Id;
   begin
      Item.Try_Claim (1, Claimed, Other);
      Item.Release (1, Released, Holder);
      if not (Claimed and then Released) then
         raise Program_Error;
      end if;
   end Claim_And_Release;

end Bench_Semaphores;
