package body URVOS.Semaphore_Calls with SPARK_Mode is

   procedure Claim_Step
     (Caller    : Claimant;
      Patience  : in out Wait;
      Claimed   : out Boolean;
      Try_Again : out Boolean)
   is
      Now    : Clock_Tick;
      Holder : Claimant;
   begin
      --  The clock is read first: once the wait is over there is one more
      --  try, so that a V at the last moment is not missed.
      Read_Clock (Now);
      Try_Claim (Caller, Claimed, Holder);
      Try_Again := not Claimed and then not Is_Over (Patience, Now);
      if Try_Again then
         Note_Look (Patience, Now);
      elsif not Claimed then
         Report_Not_Claimed (Caller, Holder);
      end if;
   end Claim_Step;

   procedure Claim (Caller : Claimant; Claimed : out Boolean) is
      Now       : Clock_Tick;
      Patience  : Wait;
      Try_Again : Boolean;
   begin
      Read_Clock (Now);
      Patience := Begun (Now, Claim_Wait);
      loop
         Claim_Step (Caller, Patience, Claimed, Try_Again);
         exit when not Try_Again;
         Exit_Processor;
         pragma Loop_Variant (Decreases => Looks_Left (Patience));
      end loop;
   end Claim;

   procedure Release (Caller : Claimant; Released : out Boolean) is
      Holder : Task_Id;
   begin
      Try_Release (Caller, Released, Holder);
      if not Released then
         Report_Not_Owned (Caller, Holder);
      end if;
   end Release;

end URVOS.Semaphore_Calls;
