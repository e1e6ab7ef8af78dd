with Ada.Real_Time;      use Ada.Real_Time;
with GSC.Real_Time;
with URVOS.Arrangements; use URVOS.Arrangements;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

package body Real_Time_GSC with SPARK_Mode is

   type Start_Condition is (Cold_Start, Processor_Restart);

   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Tree      : out Task_Tree);

   procedure Observe_Tick (Late : Time_Span) is null;

   procedure AD_Step (First_Run : Boolean; Failed : out Boolean);
   procedure TELIN_Step (First_Run : Boolean; Failed : out Boolean);
   procedure GDCIN_Step (First_Run : Boolean; Failed : out Boolean);
   procedure GDCOUT_Step (First_Run : Boolean; Failed : out Boolean);
   procedure TELOUT_Step (First_Run : Boolean; Failed : out Boolean);
   procedure CORE_Step (First_Run : Boolean; Failed : out Boolean);
   procedure LOG_Step (First_Run : Boolean; Failed : out Boolean);

   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Tree      : out Task_Tree)
   is
   begin
      if Condition = Cold_Start then
         GSC.CORE_Memory.Clear;
      end if;
      GSC.Telemetry_Board.Clear_Transmit_Half;
      GSC.AD_Board.Initialise;
      Tree := Empty_Tree;
      for Who in GSC.Task_Name loop
         Tree (TCB_Number'Val (GSC.Task_Name'Pos (Who))) :=
           (Id               => GSC.Task_Name'Pos (Who) + 1,
            Start_Time       => Now,
            Initial_Priority => 31 - GSC.Task_Name'Pos (Who));
      end loop;
   end Begin_Again;

   procedure AD_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         GSC.AD.Initialise;
      else
         GSC.AD.Run_Transaction;
      end if;
   end AD_Step;

   procedure TELIN_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         GSC.TELIN.Initialise;
      else
         GSC.TELIN.Run_Transaction;
      end if;
   end TELIN_Step;

   procedure GDCIN_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if not First_Run then
         GSC.GDCIN.Run_Transaction;
      end if;
   end GDCIN_Step;

   procedure GDCOUT_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if not First_Run then
         GSC.GDCOUT.Run_Transaction;
      end if;
   end GDCOUT_Step;

   procedure TELOUT_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if not First_Run then
         GSC.TELOUT.Run_Transaction;
      end if;
   end TELOUT_Step;

   procedure CORE_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         GSC.CORE.Initialise;
      else
         GSC.CORE.Run_Transaction;
      end if;
   end CORE_Step;

   procedure LOG_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if not First_Run then
         GSC.LOG.Run_Transaction;
      end if;
   end LOG_Step;

   package Partition is new GSC.Real_Time
     (Start_Condition => Start_Condition,
      Cold            => Cold_Start,
      Begin_Again     => Begin_Again,
      Restart         => Processor_Restart,
      AD_Step         => AD_Step,
      TELIN_Step      => TELIN_Step,
      GDCIN_Step      => GDCIN_Step,
      GDCOUT_Step     => GDCOUT_Step,
      TELOUT_Step     => TELOUT_Step,
      CORE_Step       => CORE_Step,
      LOG_Step        => LOG_Step,
      Observe_Tick    => Observe_Tick);

   procedure Switch_On is
   begin
      Partition.Switch_On;
   end Switch_On;

end Real_Time_GSC;
