--  A semaphore that tasks share (report, section 3.5; SEM-1, SEM-2).
--
--  The protected object takes the place of the indivisible test-and-set.
--  Nobody waits here: URVOS.Semaphore_Calls does.

with URVOS.Semaphores; use URVOS.Semaphores;
with URVOS.Task_Trees; use URVOS.Task_Trees;

generic
package URVOS.Shared_Semaphores
  with
    SPARK_Mode,
    Abstract_State =>
      (Flag with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => Flag
is

   procedure Try_Claim
     (Caller  : Claimant;
      Claimed : out Boolean;
      Holder  : out Claimant)
   with
     Global  => (In_Out => Flag),
     Depends => ((Flag, Claimed, Holder) => (Flag, Caller));

   procedure Release
     (Caller   : Claimant;
      Released : out Boolean;
      Holder   : out Task_Id)
   with
     Global  => (In_Out => Flag),
     Depends => ((Flag, Released, Holder) => (Flag, Caller));

   --  Makes it available, whoever has claimed it (INI-8).
   procedure Reset
   with Global => (In_Out => Flag);

   --  The semaphore as it stands, for whoever watches over the node.
   procedure Inspect (Snapshot : out Semaphore)
   with
     Global  => (Input => Flag),
     Depends => (Snapshot => Flag);

end URVOS.Shared_Semaphores;
