--  P, V and RECV with a wait, as a task has them, for the proof (SEM-1,
--  SEM-2, MBX-3, MBX-5). Nothing runs.

with URVOS;            use URVOS;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Receive_Calls;
with URVOS.Semaphore_Calls;
with URVOS.Semaphores; use URVOS.Semaphores;
with URVOS.Shared_Mailboxes;
with URVOS.Shared_Semaphores;
with URVOS.Task_Trees; use URVOS.Task_Trees;
with URV.Buffers;      use URV.Buffers;
with URV.Mailboxes;
with URV.Shared_Errors;

package Waiting_Instances with SPARK_Mode is

   package Resource is new URVOS.Shared_Semaphores;

   package Variable is
     new URVOS.Shared_Mailboxes (URV.Mailboxes.For_Stick_Words);

   package Errors is new URV.Shared_Errors;

   --  Whatever a clock shows: nothing is known of it, not even that it runs.
   Shown : Clock_Tick := 0 with Volatile, Async_Writers;

   --  How often the processor was given away.
   Exits : Count := 0;

   procedure Read_Clock (Now : out Clock_Tick)
   with
     Global  => (Input => Shown),
     Depends => (Now => Shown);

   procedure Exit_Processor
   with
     Global => (In_Out => Exits),
     Post   => Exits = Incremented (Exits'Old);

   procedure Report_Not_Claimed (Caller, Holder : Claimant)
   with Global => (In_Out => Errors.Shared_Log);

   procedure Report_Not_Owned (Caller : Claimant; Holder : Task_Id)
   with Global => (In_Out => Errors.Shared_Log);

   package Resource_Calls is new URVOS.Semaphore_Calls
     (Try_Claim          => Resource.Try_Claim,
      Try_Release        => Resource.Release,
      Read_Clock         => Read_Clock,
      Report_Not_Claimed => Report_Not_Claimed,
      Report_Not_Owned   => Report_Not_Owned);

   procedure Claim is new Resource_Calls.Claim (Exit_Processor);

   package Variable_Calls is new URVOS.Receive_Calls
     (Message    => Channel_Words,
      Look       => Variable.Look,
      Receive    => Variable.Receive,
      Read_Clock => Read_Clock);

   procedure Receive_Within is
     new Variable_Calls.Receive_Within (Exit_Processor);

end Waiting_Instances;
