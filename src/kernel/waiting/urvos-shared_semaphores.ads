--  SPDX-License-Identifier: Apache-2.0

--  A semaphore that tasks share (report, section 3.5; SEM-1, SEM-2).
--
--  The protected object takes the place of the indivisible test-and-set.
--  Nobody waits here: URVOS.Semaphore_Calls does.

with URVOS.Semaphores; use URVOS.Semaphores;
with URVOS.Task_Trees; use URVOS.Task_Trees;

package URVOS.Shared_Semaphores with SPARK_Mode is

   protected type Flag is

      procedure Try_Claim
        (Caller  : Claimant;
         Claimed : out Boolean;
         Holder  : out Claimant);

      procedure Release
        (Caller   : Claimant;
         Released : out Boolean;
         Holder   : out Task_Id);

      --  Makes it available, whoever has claimed it (INI-8).
      procedure Reset;

      --  The semaphore as it stands, for whoever watches over the node.
      function Snapshot return Semaphore;

   private
      State : Semaphore;
   end Flag;

end URVOS.Shared_Semaphores;
