--  SPDX-License-Identifier: Apache-2.0

--  A semaphore that records its owner (report, section 3.5; SEM-1, SEM-2).
--
--  P waits for a limited time and then continues without the semaphore. The
--  matching V follows in any case. Only the owner's V releases, so this V
--  cannot release another task's claim.
--
--  A task that claims its own semaphore again gets the same answer as any
--  other: not available.

with URVOS.Task_Trees; use URVOS.Task_Trees;

package URVOS.Semaphores with Pure, SPARK_Mode is

   --  The tasks that can claim.
   subtype Claimant is Task_Id range No_Task + 1 .. Task_Id'Last;

   type Semaphore is private;

   --  The task that has claimed it, or No_Task if it is available.
   function Owner (This : Semaphore) return Task_Id
   with Global => null;

   function Is_Available (This : Semaphore) return Boolean is
     (Owner (This) = No_Task)
   with Global => null;

   --  A semaphore in its first state (INI-8).
   function Available_Semaphore return Semaphore
   with
     Global => null,
     Post   => Is_Available (Available_Semaphore'Result);

   --  One try of a P. Holder is the owner after the try: the caller, or the
   --  task that claimed it earlier.
   procedure Try_Claim
     (This    : in out Semaphore;
      Caller  : Claimant;
      Claimed : out Boolean;
      Holder  : out Claimant)
   with
     Global  => null,
     Depends => ((This, Holder) => (This, Caller), Claimed => This),
     Post    =>
       Claimed = Is_Available (This'Old)
       and then Owner (This) =
         (if Claimed then Caller else Owner (This'Old))
       and then Holder = Owner (This);

   --  V. A caller that is not the owner releases nothing. Holder is the owner
   --  afterwards.
   procedure Release
     (This     : in out Semaphore;
      Caller   : Claimant;
      Released : out Boolean;
      Holder   : out Task_Id)
   with
     Global => null,
     Post   =>
       Released = (Owner (This'Old) = Caller)
       and then Owner (This) =
         (if Released then No_Task else Owner (This'Old))
       and then Holder = Owner (This);

private

   type Semaphore is record
      Claimed_By : Task_Id := No_Task;
   end record;

   function Owner (This : Semaphore) return Task_Id is (This.Claimed_By);

   function Available_Semaphore return Semaphore is
     ((Claimed_By => No_Task));

end URVOS.Semaphores;
