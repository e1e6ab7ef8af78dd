--  SPDX-License-Identifier: Apache-2.0

--  P, V and RECV with a wait, as tasks use them, for the proof (SEM-1, SEM-2,
--  MBX-3, MBX-5). Step after step, with EXIT between steps, each of them ends,
--  whatever the clock shows. They never run.

with URVOS;            use URVOS;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Receive_Calls;
with URVOS.Semaphore_Calls;
with URVOS.Semaphores; use URVOS.Semaphores;
with URVOS.Shared_Semaphores;
with URVOS.Task_Trees; use URVOS.Task_Trees;
with URVOS.Waits;      use URVOS.Waits;
with URV.Buffers;      use URV.Buffers;
with URV.Mailboxes;    use URV.Mailboxes;
with URV.Shared_Errors;

package Waiting_Instances with SPARK_Mode is

   Resource : URVOS.Shared_Semaphores.Flag;

   Variable : For_Stick_Words.Variable;

   Errors : URV.Shared_Errors.Shared_Log;

   --  The clock's value. Nothing is known of it, not even that it advances.
   Shown : Clock_Tick := 0 with Volatile, Async_Writers;

   procedure Report_Not_Claimed (Caller, Holder : Claimant)
   with Global => (In_Out => Errors);

   procedure Report_Not_Owned (Caller : Claimant; Holder : Task_Id)
   with Global => (In_Out => Errors);

   package Resource_Calls is new URVOS.Semaphore_Calls
     (Resource, Report_Not_Claimed, Report_Not_Owned);

   package Variable_Calls is
     new URVOS.Receive_Calls (For_Stick_Words, Variable);

   --  All steps of a P.
   procedure Claim (Caller : Claimant; Claimed : out Boolean)
   with
     Global => (Input => Shown, In_Out => (Resource, Errors));

   --  All steps of a RECV.
   procedure Receive_Within
     (Ticks : Wait_Ticks;
      Item  : out Channel_Words;
      Fresh : out Boolean)
   with
     Global => (Input => Shown, In_Out => Variable);

end Waiting_Instances;
