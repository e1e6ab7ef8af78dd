--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time; use Ada.Real_Time;

with Host.Memory_Hardware;
with Host.Text_Numbers;
with Partitions.Clocks; use Partitions.Clocks;
with Partitions.Converter;
with Partitions.Guards;
with Partitions.Signals;
with Partitions.Telemetry_Processor;
with Partitions.Rows;         use Partitions.Rows;
with URVOS.Frames;            use URVOS.Frames;
with URVOS.Kernel_Calls;      use URVOS.Kernel_Calls;
with URVOS.Real_Time_Nodes;
with URVOS.Starts;            use URVOS.Starts;

package body Partitions.Nodes is

   use type Software.Tasks.Task_Name;

   Stood_Still : Count := 0 with Atomic;

   --  For the processor: see URVOS.Real_Time_Nodes.
   procedure Request_Start (Condition : Start_Condition);
   procedure Observe_Tick (Late : Time_Span);

   procedure Raise_Processor_Exception;
   procedure Press_Reset_Switch;

   --  The converter does not interrupt the code that begins scans, whatever
   --  the outcome of that code.

   procedure Uninterrupted_Step
     (Who       : Software.Tasks.Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   procedure Uninterrupted_Start
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);

   --  A step has failed.
   procedure Fail;

   --  A transaction is over.
   procedure Observe_Step (Who : Software.Tasks.Task_Name);

   --  The frame's words are in CORE: a row of the record. A late transaction
   --  that ends in a later frame may find that frame's row missing or made:
   --  each frame has one.
   procedure Observe_Frame;

   First_Without_Row : Host.Text_Numbers.Number := 0;

   --  Used by the task that takes the rows: its view of the peer.
   Peer_Seen  : Watch;
   Peer_Found : Peer_State := Never_Heard with Atomic;

   function Refused_In (Log : URV.Errors.Error_Log) return Count is
     (URV.Errors.Logs.History_Of (Log, URV.Errors.Block_Refused).Occurrences);

   --  Checks whether the node takes arriving blocks.
   procedure Look_For_Peer (Frame : Host.Text_Numbers.Number);

   --  Boards

   package Telemetry_Hardware is
     new Partitions.Telemetry_Processor (Boards.Telemetry_Board);

   procedure AD_Interrupt is
     new Guards.Call (Boards.Handle_AD_Interrupt, Raise_Processor_Exception);

   package Converter_Hardware is
     new Partitions.Converter (Boards.AD_Board, Sample, AD_Interrupt);

   --  Processors

   procedure Step is new Guards.Step
     (Task_Name       => Software.Tasks.Task_Name,
      Distributions   => Distributions,
      Costs           => Costs,
      Responses       => Responses,
      Has_Stood_Still => Has_Stood_Still,
      Run_Step        => Uninterrupted_Step,
      Observe         => Observe_Step,
      Fail            => Fail);

   procedure Begin_Start is
     new Guards.Start (Uninterrupted_Start, Request_Start);

   package Guarded is new URVOS.Node_Software
     (Software.Tasks, Step, Begin_Start, Software.Set_Time,
      Software.Report_Overrun, Software.Look_At_Frame);

   package Node is new URVOS.Real_Time_Nodes (Guarded, Observe_Tick);

   package Signals is new Partitions.Signals
     (Switch_Off                => Queue.Finish,
      Raise_Processor_Exception => Raise_Processor_Exception,
      Press_Reset_Switch        => Press_Reset_Switch);

   procedure Uninterrupted_Step
     (Who       : Software.Tasks.Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call) is
   begin
      if Who = AD_Task then
         Converter_Hardware.Hold_Interrupts;
      end if;
      Software.Run_Step (Who, First_Run, Now, Call);
      if Who = AD_Task then
         Converter_Hardware.Release_Interrupts;
      end if;
   exception
      when others =>
         if Who = AD_Task then
            Converter_Hardware.Release_Interrupts;
         end if;
         raise;
   end Uninterrupted_Step;

   procedure Uninterrupted_Start
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean) is
   begin
      Converter_Hardware.Hold_Interrupts;
      Software.Begin_Again (Condition, Now, Passed);
      Converter_Hardware.Release_Interrupts;
   exception
      when others =>
         Converter_Hardware.Release_Interrupts;
         raise;
   end Uninterrupted_Start;

   procedure Request_Start (Condition : Start_Condition) is
   begin
      Node.Request_Start (Condition);
   end Request_Start;

   procedure Fail is
   begin
      Node.Request_Start (Processor_Restart);
   end Fail;

   procedure Observe_Step (Who : Software.Tasks.Task_Name) is
   begin
      if Who = TELOUT_Task then
         Telemetry_Hardware.Look;
      elsif Who = CORE_Task then
         Observe_Frame;
      else
         Observe (Who);
      end if;
   end Observe_Step;

   procedure Look_For_Peer (Frame : Host.Text_Numbers.Number) is
      Tally   : constant Telemetry.Boards.Statistics :=
        Boards.Telemetry_Board.Tally;
      Refused : constant Count := Refused_In (Boards.Errors.Contents);
   begin
      Look
        (Peer_Seen,
         Received => Tally.Received,
         Dropped  =>
           Refused + Count'Min (Tally.Not_Taken, Count'Last - Refused),
         Frame    => Frame);
      Peer_Found := Present (Peer_Seen);
   end Look_For_Peer;

   procedure Observe_Frame is
      use type Number;

      Now   : Clock_Tick;
      Late  : Count;
      Frame : Number;
      Item  : Row;
   begin
      Node.Inspect_Clock (Now);
      Node.Inspect_Overruns (Late);
      Frame := Number (Now / Ticks_Per_Major_Frame);
      if Frame < First_Without_Row then
         return;
      end if;
      First_Without_Row := Frame + 1;
      Append (Item, Frame);
      Append
        (Item,
         (Frame + 1) * Ticks_Per_Major_Frame * Microseconds_Per_Tick / 1_000);
      Contents.Append_Values (Item);
      Append (Item, Number (Late));
      Append (Item, Number (Machine_Time (Clock)));
      Contents.Append_Last (Item);
      Look_For_Peer (Frame);
      Item.Peer := Peer_Found;
      Queue.Put (Item);
      Contents.Publish (Item);
   end Observe_Frame;

   procedure Observe_Tick (Late : Time_Span) is
      Counted_From : Time;
   begin
      Node.Inspect_Beginning (Counted_From);
      Count_From (Counted_From);
      Lateness.Add (Tenths_Of_Microseconds (Late));
      if Has_Stood_Still then
         Stood_Still := Incremented (Stood_Still);
         Node.Request_Start (Processor_Restart);
      end if;
      See_Tick;
   end Observe_Tick;

   procedure Raise_Processor_Exception is
   begin
      --  A start at power up remains a cold start.
      if Is_Running then
         Node.Request_Start (Processor_Restart);
      end if;
   end Raise_Processor_Exception;

   procedure Press_Reset_Switch is
   begin
      if Is_Running then
         Telemetry_Hardware.Reset;
         Node.Request_Start (Warm_Reset);
      end if;
   end Press_Reset_Switch;

   function Peer return Peer_State is (Peer_Found);

   function Refused return Count is (Refused_In (Boards.Errors.Contents));

   function Pauses return Count is (Stood_Still);

   function Board_Starts return Count is
     (Telemetry_Hardware.Starts_Unasked);

   procedure Seal_Link
     (Format : URV.Handshakes.Format_Number;
      Keys   : URV.Sessions.Key_List;
      Start  : URV.Seal_Blocks.Nonce) is
   begin
      Boards.Sealing.Configure (Format, Keys, Start);
   end Seal_Link;

   procedure Switch_On
     (Processors : Processor_Number;
      Chosen     : Schedule_Name := Report;
      Line       : Telemetry.Line_Delay := 0) is
   begin
      Boards.Schedule.Write (Chosen);
      Signals.Listen;
      Host.Memory_Hardware.Repair (Boards.Processor_Board);
      Telemetry_Hardware.Switch_On (Line);
      Node.Switch_On (Processors, Switched_On_At, Chosen);
   end Switch_On;

   function Overruns return Count is
      Number : Count;
   begin
      Node.Inspect_Overruns (Number);
      return Number;
   end Overruns;

end Partitions.Nodes;
