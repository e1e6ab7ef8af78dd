with Ada.Real_Time; use Ada.Real_Time;

with GSC.Real_Time;
with GSC.Turns;
with Host.Memory_Hardware;
with Partitions.Clocks; use Partitions.Clocks;
with Partitions.Console;
with Partitions.Converter;
with Partitions.Guarded_Call;
with Partitions.Guarded_Start;
with Partitions.Guarded_Step;
with Partitions.Rows;   use Partitions.Rows;
with Partitions.Signals;
with Partitions.Telemetry_Processor;
with Partitions.Uninterrupted_Call;
with URVOS.Frames;      use URVOS.Frames;
with URVOS.Starts;      use URVOS.Starts;

package body Partitions.GSC_Node is

   --  Boards

   package Telemetry_Hardware is new Partitions.Telemetry_Processor
     (Start               => GSC.Telemetry_Board.Start,
      Clear_Transmit_Half => GSC.Telemetry_Board.Clear_Transmit_Half,
      Accept_Character    => GSC.Telemetry_Board.Accept_Character,
      Next_Character      => GSC.Telemetry_Board.Next_Character);

   procedure Raise_Processor_Exception;

   procedure AD_Interrupt is new Guarded_Call
     (Call                      => GSC.AD_Interrupt,
      Raise_Processor_Exception => Raise_Processor_Exception);

   package Converter_Hardware is new Partitions.Converter
     (Sample               => Console.Sample,
      Take_Start           => GSC.AD_Board.Take_Start,
      Finish               => GSC.AD_Board.Finish,
      Interrupt_Controller => AD_Interrupt);

   procedure AD_Initialise is new Uninterrupted_Call
     (Call               => GSC.AD.Initialise,
      Hold_Interrupts    => Converter_Hardware.Hold_Interrupts,
      Release_Interrupts => Converter_Hardware.Release_Interrupts);

   procedure AD_Transaction is new Uninterrupted_Call
     (Call               => GSC.AD.Run_Transaction,
      Hold_Interrupts    => Converter_Hardware.Hold_Interrupts,
      Release_Interrupts => Converter_Hardware.Release_Interrupts);

   --  Steps of the tasks

   Stood_Still : Count := 0 with Atomic;

   procedure No_Initialisation is null;

   procedure Observe_Nothing is null;

   --  The frame's words are in CORE: a row of the record.
   procedure Observe_Frame;

   procedure AD_Step is new Guarded_Step
     (Cost            => Costs (GSC.AD_Task),
      Response        => Responses (GSC.AD_Task),
      Has_Stood_Still => Has_Stood_Still,
      Initialise      => AD_Initialise,
      Run_Transaction => AD_Transaction,
      Observe         => Observe_Nothing);

   procedure TELIN_Step is new Guarded_Step
     (Cost            => Costs (GSC.TELIN_Task),
      Response        => Responses (GSC.TELIN_Task),
      Has_Stood_Still => Has_Stood_Still,
      Initialise      => GSC.TELIN.Initialise,
      Run_Transaction => GSC.TELIN.Run_Transaction,
      Observe         => Observe_Nothing);

   procedure GDCIN_Step is new Guarded_Step
     (Cost            => Costs (GSC.GDCIN_Task),
      Response        => Responses (GSC.GDCIN_Task),
      Has_Stood_Still => Has_Stood_Still,
      Initialise      => No_Initialisation,
      Run_Transaction => GSC.GDCIN.Run_Transaction,
      Observe         => Observe_Nothing);

   procedure GDCOUT_Step is new Guarded_Step
     (Cost            => Costs (GSC.GDCOUT_Task),
      Response        => Responses (GSC.GDCOUT_Task),
      Has_Stood_Still => Has_Stood_Still,
      Initialise      => No_Initialisation,
      Run_Transaction => GSC.GDCOUT.Run_Transaction,
      Observe         => Observe_Nothing);

   procedure TELOUT_Step is new Guarded_Step
     (Cost            => Costs (GSC.TELOUT_Task),
      Response        => Responses (GSC.TELOUT_Task),
      Has_Stood_Still => Has_Stood_Still,
      Initialise      => No_Initialisation,
      Run_Transaction => GSC.TELOUT.Run_Transaction,
      Observe         => Telemetry_Hardware.Look);

   procedure CORE_Step is new Guarded_Step
     (Cost            => Costs (GSC.CORE_Task),
      Response        => Responses (GSC.CORE_Task),
      Has_Stood_Still => Has_Stood_Still,
      Initialise      => GSC.CORE.Initialise,
      Run_Transaction => GSC.CORE.Run_Transaction,
      Observe         => Observe_Frame);

   procedure LOG_Step is new Guarded_Step
     (Cost            => Costs (GSC.LOG_Task),
      Response        => Responses (GSC.LOG_Task),
      Has_Stood_Still => Has_Stood_Still,
      Initialise      => GSC.LOG.Initialise,
      Run_Transaction => GSC.LOG.Run_Transaction,
      Observe         => Observe_Nothing);

   procedure SELF_TEST_Step is new Guarded_Step
     (Cost            => Costs (GSC.SELF_TEST_Task),
      Response        => Responses (GSC.SELF_TEST_Task),
      Has_Stood_Still => Has_Stood_Still,
      Initialise      => GSC.SELF_TEST.Initialise,
      Run_Transaction => GSC.SELF_TEST.Run_Transaction,
      Observe         => Observe_Nothing);

   --  Starts

   procedure Observe_Tick (Late : Time_Span);

   --  Uninterrupted, whatever becomes of it.
   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);

   procedure Begin_Start is new Guarded_Start
     (Begin_Again   => Begin_Again,
      Request_Start => GSC.Turns.Scheduler.Request_Start);

   package Tasks is new GSC.Real_Time
     (AD_Step        => AD_Step,
      TELIN_Step     => TELIN_Step,
      GDCIN_Step     => GDCIN_Step,
      GDCOUT_Step    => GDCOUT_Step,
      TELOUT_Step    => TELOUT_Step,
      CORE_Step      => CORE_Step,
      LOG_Step       => LOG_Step,
      SELF_TEST_Step => SELF_TEST_Step,
      Observe_Tick   => Observe_Tick,
      Begin_Start    => Begin_Start);

   procedure Press_Reset_Switch;

   package Signals is new Partitions.Signals
     (Switch_Off                => Queue.Finish,
      Raise_Processor_Exception => Raise_Processor_Exception,
      Press_Reset_Switch        => Press_Reset_Switch);

   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean) is
   begin
      Converter_Hardware.Hold_Interrupts;
      GSC.Begin_Again (Condition, Now, Passed);
      Converter_Hardware.Release_Interrupts;
   exception
      when others =>
         Converter_Hardware.Release_Interrupts;
         raise;
   end Begin_Again;

   procedure Observe_Frame is
      use type Number;

      Now   : Clock_Tick;
      Late  : Count;
      Frame : Number;
      Item  : Row;
   begin
      GSC.Turns.Scheduler.Inspect_Clock (Now);
      GSC.Turns.Scheduler.Inspect_Overruns (Late);
      Frame := Number (Now / Ticks_Per_Major_Frame);
      Append (Item, Frame);
      Append (Item, (Frame + 1) * 20);
      Console.Append_Values (Item);
      Append (Item, Number (Late));
      Append (Item, Number (Machine_Time (Clock)));
      Queue.Put (Item);
   end Observe_Frame;

   procedure Observe_Tick (Late : Time_Span) is
   begin
      Lateness.Add (Tenths_Of_Microseconds (Late));
      Set_Tick (Clock - Late);
      if Has_Stood_Still then
         Stood_Still := Incremented (Stood_Still);
         GSC.Turns.Scheduler.Request_Start (Processor_Restart);
      end if;
      See_Tick;
   end Observe_Tick;

   procedure Raise_Processor_Exception is
   begin
      --  A start at power up stays a cold start.
      if Is_Running then
         GSC.Turns.Scheduler.Request_Start (Processor_Restart);
      end if;
   end Raise_Processor_Exception;

   procedure Press_Reset_Switch is
   begin
      if Is_Running then
         Telemetry_Hardware.Reset;
         GSC.Turns.Scheduler.Request_Start (Warm_Reset);
      end if;
   end Press_Reset_Switch;

   function Link_Tally return Telemetry.Boards.Statistics is
      Tally : Telemetry.Boards.Statistics;
   begin
      GSC.Telemetry_Board.Inspect (Tally);
      return Tally;
   end Link_Tally;

   function Pauses return Count is (Stood_Still);

   function Board_Starts return Count is
     (Telemetry_Hardware.Starts_Unasked);

   procedure Switch_On is
   begin
      Signals.Listen;
      Host.Memory_Hardware.Repair (1);
      Telemetry_Hardware.Switch_On;
      Tasks.Switch_On;
      Converter_Hardware.Switch_On;
   end Switch_On;

   function Overruns return Count is
      Number : Count;
   begin
      GSC.Turns.Scheduler.Inspect_Overruns (Number);
      return Number;
   end Overruns;

   function Log return URV.Errors.Error_Log is
      Snapshot : URV.Errors.Error_Log;
   begin
      GSC.Errors.Inspect (Snapshot);
      return Snapshot;
   end Log;

end Partitions.GSC_Node;
