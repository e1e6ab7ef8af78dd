--  The ground's node in real time: each task of the node an Ada task, one
--  kernel that says whose turn it is.
--
--  The steps of the tasks are formal, and so are the first phases of a start,
--  so that the partition can put round each what catches an unexpected
--  exception (KRN-6).

with Ada.Real_Time; use Ada.Real_Time;
with GSC.Turns;

generic
   with procedure AD_Step
     (First_Run : Boolean; Failed : out Boolean);
   with procedure TELIN_Step
     (First_Run : Boolean; Failed : out Boolean);
   with procedure GDCIN_Step
     (First_Run : Boolean; Failed : out Boolean);
   with procedure GDCOUT_Step
     (First_Run : Boolean; Failed : out Boolean);
   with procedure TELOUT_Step
     (First_Run : Boolean; Failed : out Boolean);
   with procedure CORE_Step
     (First_Run : Boolean; Failed : out Boolean);
   with procedure LOG_Step
     (First_Run : Boolean; Failed : out Boolean);
   with procedure SELF_TEST_Step
     (First_Run : Boolean; Failed : out Boolean);

   with procedure Observe_Tick (Late : Time_Span);

   --  Phases 1 and 2 of a start: see URVOS.Real_Time_Kernels.
   with procedure Begin_Start
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean) is Begin_Again;
package GSC.Real_Time
  with
    SPARK_Mode,
    Abstract_State => (Processor with Synchronous, External),
    Initializes    => Processor
is

   --  Power up: see URVOS.Real_Time_Kernels.
   procedure Switch_On
   with Global => (In_Out => (Turns.Scheduler.Task_Management, Processor));

end GSC.Real_Time;
