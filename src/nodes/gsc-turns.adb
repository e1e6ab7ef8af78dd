with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with URV.Errors;                   use URV.Errors;

package body GSC.Turns
  with
    SPARK_Mode,
    Refined_State =>
      (Waiting =>
         (AD_Turn, TELIN_Turn, GDCIN_Turn, GDCOUT_Turn,
          TELOUT_Turn, CORE_Turn, LOG_Turn, SELF_TEST_Turn))
is

   AD_Turn        : Suspension_Object;
   TELIN_Turn     : Suspension_Object;
   GDCIN_Turn     : Suspension_Object;
   GDCOUT_Turn    : Suspension_Object;
   TELOUT_Turn    : Suspension_Object;
   CORE_Turn      : Suspension_Object;
   LOG_Turn       : Suspension_Object;
   SELF_TEST_Turn : Suspension_Object;

   procedure Resume (Id : Task_Id) is
   begin
      if Is_Task (Id) then
         case Task_Of (Id) is
            when AD_Task        => Set_True (AD_Turn);
            when TELIN_Task     => Set_True (TELIN_Turn);
            when GDCIN_Task     => Set_True (GDCIN_Turn);
            when GDCOUT_Task    => Set_True (GDCOUT_Turn);
            when TELOUT_Task    => Set_True (TELOUT_Turn);
            when CORE_Task      => Set_True (CORE_Turn);
            when LOG_Task       => Set_True (LOG_Turn);
            when SELF_TEST_Task => Set_True (SELF_TEST_Turn);
         end case;
      end if;
   end Resume;

   procedure Report_Overrun (Id : Task_Id) is
   begin
      Errors.Report (Task_Overrun, Word (Id));
   end Report_Overrun;

   procedure Await_AD is
   begin
      Suspend_Until_True (AD_Turn);
   end Await_AD;

   procedure Await_TELIN is
   begin
      Suspend_Until_True (TELIN_Turn);
   end Await_TELIN;

   procedure Await_GDCIN is
   begin
      Suspend_Until_True (GDCIN_Turn);
   end Await_GDCIN;

   procedure Await_GDCOUT is
   begin
      Suspend_Until_True (GDCOUT_Turn);
   end Await_GDCOUT;

   procedure Await_TELOUT is
   begin
      Suspend_Until_True (TELOUT_Turn);
   end Await_TELOUT;

   procedure Await_CORE is
   begin
      Suspend_Until_True (CORE_Turn);
   end Await_CORE;

   procedure Await_LOG is
   begin
      Suspend_Until_True (LOG_Turn);
   end Await_LOG;

   procedure Await_SELF_TEST is
   begin
      Suspend_Until_True (SELF_TEST_Turn);
   end Await_SELF_TEST;

end GSC.Turns;
