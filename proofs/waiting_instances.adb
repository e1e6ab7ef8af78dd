--  SPDX-License-Identifier: Apache-2.0

with URV.Errors; use URV.Errors;

package body Waiting_Instances with SPARK_Mode is

   procedure Report_Not_Claimed (Caller, Holder : Claimant) is
      pragma Unreferenced (Holder);
   begin
      Errors.Report (Semaphore_Not_Claimed, Word (Caller));
   end Report_Not_Claimed;

   procedure Report_Not_Owned (Caller : Claimant; Holder : Task_Id) is
      pragma Unreferenced (Holder);
   begin
      Errors.Report (Semaphore_Not_Owned, Word (Caller));
   end Report_Not_Owned;

   procedure Claim (Caller : Claimant; Claimed : out Boolean) is
      Now       : Clock_Tick := Shown;
      Timeout   : Wait       := Begun (Now, Resource_Calls.Claim_Wait);
      Try_Again : Boolean;
   begin
      loop
         Resource_Calls.Claim_Step
           (Caller, Now, Timeout, Claimed, Try_Again);
         exit when not Try_Again;
         Now := Shown;
         pragma Loop_Variant (Decreases => Looks_Left (Timeout));
      end loop;
   end Claim;

   procedure Receive_Within
     (Ticks : Wait_Ticks;
      Item  : out Channel_Words;
      Fresh : out Boolean)
   is
      Now        : Clock_Tick := Shown;
      Timeout    : Wait       := Begun (Now, Ticks);
      Look_Again : Boolean;
   begin
      loop
         Variable_Calls.Receive_Step
           (Now, Timeout, Item, Fresh, Look_Again);
         exit when not Look_Again;
         Now := Shown;
         pragma Loop_Variant (Decreases => Looks_Left (Timeout));
      end loop;
   end Receive_Within;

end Waiting_Instances;
