with URVOS.Executives;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URV.Errors;         use URV.Errors;

package body GSC.Virtual_Time with SPARK_Mode is

   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   procedure Report_Overrun (Who : Task_Id);

   package Processor is new URVOS.Executives (Step, Report_Overrun);

   --  Every task sleeps until its offset in the next major frame (FRM-2,
   --  FRM-3).
   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call) is
   begin
      if Is_Task (Who) then
         Run_Step (Task_Of (Who), First_Run);
         Call := (Sleep_Call, Next_Release (Now, Offsets (Task_Of (Who))));
      else
         Call := (Name => Terminate_Call, others => <>);
      end if;
   end Step;

   procedure Report_Overrun (Who : Task_Id) is
   begin
      Errors.Report (Task_Overrun, Word (Who));
   end Report_Overrun;

   procedure Start (Condition : Start_Condition; Now : Clock_Tick) is
      Passed : Boolean;
   begin
      Begin_Again (Condition, Now, Passed);
      if Passed then
         Processor.Start (Task_Tree_Of (Now), Now);
      else
         Processor.Start (Empty_Tree, Now);
      end if;
   end Start;

   procedure Clock_Interrupt (Now : Clock_Tick) is
   begin
      Errors.Set_Time (Now);
      Processor.Clock_Interrupt (Now);
   end Clock_Interrupt;

   function Overruns return Count is (Processor.Overruns);

end GSC.Virtual_Time;
