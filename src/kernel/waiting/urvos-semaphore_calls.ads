--  SPDX-License-Identifier: Apache-2.0

--  P and V (report, section 3.5; SEM-1, SEM-2, MBX-5).
--
--     Timeout := Begun (Now, Claim_Wait);
--     --  In this step and, after EXIT, in those that follow:
--     Claim_Step (Caller, Now, Timeout, Claimed, Try_Again);
--     --  The resource is used, claimed or not.
--     Release (Caller, Released);
--
--  P tries once a step. Between tries the task ends its step with EXIT, so
--  that the semaphore's owner can run. After two ticks it tries for the last
--  time and continues, if necessary without the semaphore, which is then
--  reported.

with URVOS.Frames;            use URVOS.Frames;
with URVOS.Semaphores;        use URVOS.Semaphores;
with URVOS.Shared_Semaphores; use URVOS.Shared_Semaphores;
with URVOS.Task_Trees;        use URVOS.Task_Trees;
with URVOS.Waits;             use URVOS.Waits;

generic
   Resource : in out Flag;

   --  Caller's P continued without the semaphore; Holder owns it.
   with procedure Report_Not_Claimed (Caller, Holder : Claimant);

   --  Caller's V released nothing; Holder owns the semaphore.
   with procedure Report_Not_Owned (Caller : Claimant; Holder : Task_Id);
package URVOS.Semaphore_Calls with SPARK_Mode is

   --  The wait of a P.
   Claim_Wait : constant Wait_Ticks := 2;

   --  One try of a P whose wait was begun with Claim_Wait ticks. Try_Again is
   --  False when the P has ended, with or without the semaphore. A P tries at
   --  most 200,001 times, and 100,001 times if the clock has stopped.
   procedure Claim_Step
     (Caller    : Claimant;
      Now       : Clock_Tick;
      Timeout   : in out Wait;
      Claimed   : out Boolean;
      Try_Again : out Boolean)
   with
     Post =>
       (if Claimed then not Try_Again)
       and then
         (if Try_Again
          then Looks_Left (Timeout) < Looks_Left (Timeout'Old)
            and then Last_Seen (Timeout) >= Last_Seen (Timeout'Old)
          else Timeout = Timeout'Old);

   --  V.
   procedure Release (Caller : Claimant; Released : out Boolean);

end URVOS.Semaphore_Calls;
