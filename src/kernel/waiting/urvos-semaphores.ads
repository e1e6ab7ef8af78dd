--  SPDX-License-Identifier: Apache-2.0

--  A semaphore that knows who has claimed it (report, section 3.5; SEM-1,
--  SEM-2).
--
--  P gives up waiting after a while and goes on without the semaphore. The
--  V that belongs to it comes all the same. So that this V does not release
--  another task's claim, only the owner's V releases.
--
--  A task that claims what it owns already is told like any other that it
--  is not available.

with URVOS.Task_Trees; use URVOS.Task_Trees;

package URVOS.Semaphores with Pure, SPARK_Mode is

   --  Who can claim.
   subtype Claimant is Task_Id range No_Task + 1 .. Task_Id'Last;

   type Semaphore is private;

   --  The task whose claim it is, No_Task when it is available.
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

   --  One try of a P. Holder is the owner, whether it is the caller now or
   --  somebody has come before.
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

   --  V. Of somebody who does not own it, it releases nothing. Holder is
   --  the owner after it.
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
