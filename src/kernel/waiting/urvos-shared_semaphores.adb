package body URVOS.Shared_Semaphores
  with
    SPARK_Mode,
    Refined_State => (Flag => Guarded_Flag)
is

   protected Guarded_Flag is

      procedure Try_Claim
        (Caller  : Claimant;
         Claimed : out Boolean;
         Holder  : out Claimant);

      procedure Release
        (Caller   : Claimant;
         Released : out Boolean;
         Holder   : out Task_Id);

      procedure Reset;

      function Snapshot return Semaphore;

   private
      State : Semaphore;
   end Guarded_Flag;

   protected body Guarded_Flag is

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

   end Guarded_Flag;

   procedure Try_Claim
     (Caller  : Claimant;
      Claimed : out Boolean;
      Holder  : out Claimant)
   is
   begin
      Guarded_Flag.Try_Claim (Caller, Claimed, Holder);
   end Try_Claim;

   procedure Release
     (Caller   : Claimant;
      Released : out Boolean;
      Holder   : out Task_Id)
   is
   begin
      Guarded_Flag.Release (Caller, Released, Holder);
   end Release;

   procedure Reset is
   begin
      Guarded_Flag.Reset;
   end Reset;

   procedure Inspect (Snapshot : out Semaphore) is
   begin
      Snapshot := Guarded_Flag.Snapshot;
   end Inspect;

end URVOS.Shared_Semaphores;
