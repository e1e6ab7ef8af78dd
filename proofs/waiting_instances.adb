with URV.Errors; use URV.Errors;

package body Waiting_Instances with SPARK_Mode is

   procedure Read_Clock (Now : out Clock_Tick) is
   begin
      Now := Shown;
   end Read_Clock;

   procedure Exit_Processor is
   begin
      Exits := Incremented (Exits);
   end Exit_Processor;

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

end Waiting_Instances;
