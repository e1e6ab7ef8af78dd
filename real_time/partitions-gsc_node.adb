with Ada.Real_Time;        use Ada.Real_Time;

with GSC.Real_Time;
with Partitions.Console;
with Partitions.Clocks;    use Partitions.Clocks;
with Partitions.Converter;
with Partitions.Guarded_Step;
with Partitions.Rows;      use Partitions.Rows;
with Partitions.Signals;
with Partitions.Telemetry_Processor;
with URVOS.Arrangements;   use URVOS.Arrangements;
with URVOS.Frames;         use URVOS.Frames;
with URVOS.Task_Trees;     use URVOS.Task_Trees;

package body Partitions.GSC_Node is

   --  Boards

   package Telemetry_Hardware is new Partitions.Telemetry_Processor
     (Start            => GSC.Telemetry_Board.Start,
      Accept_Character => GSC.Telemetry_Board.Accept_Character,
      Next_Character   => GSC.Telemetry_Board.Next_Character);

   package Converter_Hardware is new Partitions.Converter
     (Sample               => Console.Sample,
      Take_Start           => GSC.AD_Board.Take_Start,
      Finish               => GSC.AD_Board.Finish,
      Interrupt_Controller => GSC.AD_Interrupt);

   --  Steps of the tasks

   procedure No_Initialisation is null;

   procedure Observe_Nothing is null;

   --  The frame's words are in CORE: a row of the record.
   procedure Observe_Frame;

   procedure AD_Step is new Guarded_Step
     (Cost            => Costs (GSC.AD_Task),
      Response        => Responses (GSC.AD_Task),
      Initialise      => GSC.AD.Initialise,
      Run_Transaction => GSC.AD.Run_Transaction,
      Observe         => Observe_Nothing);

   procedure TELIN_Step is new Guarded_Step
     (Cost            => Costs (GSC.TELIN_Task),
      Response        => Responses (GSC.TELIN_Task),
      Initialise      => GSC.TELIN.Initialise,
      Run_Transaction => GSC.TELIN.Run_Transaction,
      Observe         => Observe_Nothing);

   procedure GDCIN_Step is new Guarded_Step
     (Cost            => Costs (GSC.GDCIN_Task),
      Response        => Responses (GSC.GDCIN_Task),
      Initialise      => No_Initialisation,
      Run_Transaction => GSC.GDCIN.Run_Transaction,
      Observe         => Observe_Nothing);

   procedure GDCOUT_Step is new Guarded_Step
     (Cost            => Costs (GSC.GDCOUT_Task),
      Response        => Responses (GSC.GDCOUT_Task),
      Initialise      => No_Initialisation,
      Run_Transaction => GSC.GDCOUT.Run_Transaction,
      Observe         => Observe_Nothing);

   procedure TELOUT_Step is new Guarded_Step
     (Cost            => Costs (GSC.TELOUT_Task),
      Response        => Responses (GSC.TELOUT_Task),
      Initialise      => No_Initialisation,
      Run_Transaction => GSC.TELOUT.Run_Transaction,
      Observe         => Telemetry_Hardware.Look);

   procedure CORE_Step is new Guarded_Step
     (Cost            => Costs (GSC.CORE_Task),
      Response        => Responses (GSC.CORE_Task),
      Initialise      => GSC.CORE.Initialise,
      Run_Transaction => GSC.CORE.Run_Transaction,
      Observe         => Observe_Frame);

   procedure LOG_Step is new Guarded_Step
     (Cost            => Costs (GSC.LOG_Task),
      Response        => Responses (GSC.LOG_Task),
      Initialise      => No_Initialisation,
      Run_Transaction => GSC.LOG.Run_Transaction,
      Observe         => Observe_Nothing);

   --  Starts

   type Start_Condition is (Cold_Start, Processor_Restart);

   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Tree      : out Task_Tree);

   procedure Observe_Tick (Late : Time_Span);

   package Tasks is new GSC.Real_Time
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

   procedure Raise_Processor_Exception;

   package Signals is new Partitions.Signals
     (Switch_Off                => Queue.Finish,
      Raise_Processor_Exception => Raise_Processor_Exception);

   procedure Observe_Frame is
      use type Number;

      Now   : Clock_Tick;
      Frame : Number;
      Item  : Row;
   begin
      Tasks.Inspect_Clock (Now);
      Frame := Number (Now / Ticks_Per_Major_Frame);
      Append (Item, Frame);
      Append (Item, (Frame + 1) * 20);
      Console.Append_Values (Item);
      Append (Item, Number (Machine_Time (Clock)));
      Queue.Put (Item);
   end Observe_Frame;

   procedure Observe_Tick (Late : Time_Span) is
   begin
      Lateness.Add (Tenths_Of_Microseconds (Late));
      Set_Tick (Clock - Late);
   end Observe_Tick;

   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Tree      : out Task_Tree)
   is
      Which : TCB_Number := 1;
   begin
      if Condition = Cold_Start then
         GSC.Cold_Start (Now);
      end if;
      Tree := Empty_Tree;
      for T in GSC.Task_Name loop
         Tree (Which) := (GSC.Task_Name'Pos (T) + 1,
            Next_Release (Now, GSC.Offsets (T)),
            31 - GSC.Task_Name'Pos (T));
         Which := Which + 1;
      end loop;
   end Begin_Again;

   procedure Raise_Processor_Exception is
   begin
      Tasks.Request_Start (Processor_Restart);
   end Raise_Processor_Exception;

   procedure Switch_On is
   begin
      Signals.Listen;
      Telemetry_Hardware.Switch_On;
      Tasks.Switch_On;
      Converter_Hardware.Switch_On;
   end Switch_On;

   function Overruns return Count is
      Number : Count;
   begin
      Tasks.Inspect_Overruns (Number);
      return Number;
   end Overruns;

   function Log return URV.Errors.Error_Log is
      Snapshot : URV.Errors.Error_Log;
   begin
      GSC.Errors.Inspect (Snapshot);
      return Snapshot;
   end Log;

end Partitions.GSC_Node;
