--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Semaphore_Calls with SPARK_Mode is

   procedure Claim_Step
     (Caller    : Claimant;
      Now       : Clock_Tick;
      Timeout   : in out Wait;
      Claimed   : out Boolean;
      Try_Again : out Boolean)
   is
      Holder : Claimant;
   begin
      Resource.Try_Claim (Caller, Claimed, Holder);
      Try_Again := not Claimed and then not Is_Over (Timeout, Now);
      if Try_Again then
         Note_Look (Timeout, Now);
      elsif not Claimed then
         Report_Not_Claimed (Caller, Holder);
      end if;
   end Claim_Step;

   procedure Release (Caller : Claimant; Released : out Boolean) is
      Holder : Task_Id;
   begin
      Resource.Release (Caller, Released, Holder);
      if not Released then
         Report_Not_Owned (Caller, Holder);
      end if;
   end Release;

end URVOS.Semaphore_Calls;
