with URVOS.Real_Time_Kernels;
with URVOS.Real_Time_Tasks;

package body GSC.Real_Time
  with
    SPARK_Mode,
    Refined_State =>
      (Processor =>
         (Kernel.Power_Switch,
          AD_Runner.Runner,
          TELIN_Runner.Runner,
          GDCIN_Runner.Runner,
          GDCOUT_Runner.Runner,
          TELOUT_Runner.Runner,
          CORE_Runner.Runner,
          LOG_Runner.Runner,
          SELF_TEST_Runner.Runner))
is

   package Kernel is new URVOS.Real_Time_Kernels
     (Start_Tasks    => Turns.Scheduler.Start,
      Wake           => Turns.Scheduler.Wake,
      Request_Start  => Turns.Scheduler.Request_Start,
      End_Task_Step  => Turns.Scheduler.End_Step,
      Begin_Again    => Begin_Start,
      Task_Tree_Of   => Task_Tree_Of,
      Tell_Time      => Errors.Set_Time,
      Report_Overrun => Turns.Report_Overrun,
      Resume         => Turns.Resume,
      Observe_Tick   => Observe_Tick);

   package AD_Runner is new URVOS.Real_Time_Tasks
     (Offset        => Offsets (AD_Task),
      Wait_For_Turn => Turns.Await_AD,
      Begin_Step    => Turns.Scheduler.Begin_Step,
      Step          => AD_Step,
      End_Step      => Kernel.End_Step);

   package TELIN_Runner is new URVOS.Real_Time_Tasks
     (Offset        => Offsets (TELIN_Task),
      Wait_For_Turn => Turns.Await_TELIN,
      Begin_Step    => Turns.Scheduler.Begin_Step,
      Step          => TELIN_Step,
      End_Step      => Kernel.End_Step);

   package GDCIN_Runner is new URVOS.Real_Time_Tasks
     (Offset        => Offsets (GDCIN_Task),
      Wait_For_Turn => Turns.Await_GDCIN,
      Begin_Step    => Turns.Scheduler.Begin_Step,
      Step          => GDCIN_Step,
      End_Step      => Kernel.End_Step);

   package GDCOUT_Runner is new URVOS.Real_Time_Tasks
     (Offset        => Offsets (GDCOUT_Task),
      Wait_For_Turn => Turns.Await_GDCOUT,
      Begin_Step    => Turns.Scheduler.Begin_Step,
      Step          => GDCOUT_Step,
      End_Step      => Kernel.End_Step);

   package TELOUT_Runner is new URVOS.Real_Time_Tasks
     (Offset        => Offsets (TELOUT_Task),
      Wait_For_Turn => Turns.Await_TELOUT,
      Begin_Step    => Turns.Scheduler.Begin_Step,
      Step          => TELOUT_Step,
      End_Step      => Kernel.End_Step);

   package CORE_Runner is new URVOS.Real_Time_Tasks
     (Offset        => Offsets (CORE_Task),
      Wait_For_Turn => Turns.Await_CORE,
      Begin_Step    => Turns.Scheduler.Begin_Step,
      Step          => CORE_Step,
      End_Step      => Kernel.End_Step);

   package LOG_Runner is new URVOS.Real_Time_Tasks
     (Offset        => Offsets (LOG_Task),
      Wait_For_Turn => Turns.Await_LOG,
      Begin_Step    => Turns.Scheduler.Begin_Step,
      Step          => LOG_Step,
      End_Step      => Kernel.End_Step);

   package SELF_TEST_Runner is new URVOS.Real_Time_Tasks
     (Offset        => Offsets (SELF_TEST_Task),
      Wait_For_Turn => Turns.Await_SELF_TEST,
      Begin_Step    => Turns.Scheduler.Begin_Step,
      Step          => SELF_TEST_Step,
      End_Step      => Kernel.End_Step);

   procedure Switch_On is
   begin
      Kernel.Switch_On;
   end Switch_On;

end GSC.Real_Time;
