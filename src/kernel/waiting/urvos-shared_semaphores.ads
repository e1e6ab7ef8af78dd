--  SPDX-License-Identifier: Apache-2.0

--  A semaphore that tasks share (report, section 3.5; SEM-1, SEM-2).
--
--  The protected object replaces the indivisible test-and-set. No task waits
--  here; URVOS.Semaphore_Calls waits.

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

      --  Makes it available, whichever task has claimed it (INI-8).
      procedure Reset;

      --  The present semaphore, for monitors of the node.
      function Snapshot return Semaphore;

   private
      State : Semaphore;
   end Flag;

end URVOS.Shared_Semaphores;
