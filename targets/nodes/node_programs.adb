--  SPDX-License-Identifier: Apache-2.0

with Devices.AD_Board; use Devices.AD_Board;
with Flight_RAM_Tests;
with Last_Chance;
pragma Unreferenced (Last_Chance);
with Line_Programs;
with Machine_Needs;
pragma Unreferenced (Machine_Needs);
with Machine_Texts;    use Machine_Texts;
with Power_Up_Tests;
pragma Unreferenced (Power_Up_Tests);
with Targets;
with Telemetry;        use Telemetry;
with Telemetry.Boards;
with URV.Buffers;
with URV.CORE_Memory;
with URV.Errors;
with URV.Sessions;         use URV.Sessions;
with URVOS.Memories;   use URVOS.Memories;
with URVOS.Self_Tests; use URVOS.Self_Tests;

package body Node_Programs is

   --  The clock has ticked since the node last looked for work. Looking costs
   --  more than most interrupts.
   Has_Ticked : Boolean := False with Volatile;

   --  The last interrupt of a scan has been handled.
   Scan_Ended : Boolean := False with Volatile;

   --  The telemetry board has been started since power up. A processor that
   --  restarts before that starts it.
   Board_Is_Started : Boolean := False;

   --  One of these has happened.
   Awake : aliased Targets.Flag := Targets.Down;

   --  The keys of an emulated flight on a sealed link. They are no secret: a
   --  real board gets its own.
   Emulated_Keys : constant Key_List :=
     [First  => (Is_Present => True,
                 Number     => 1,
                 Value      => (K0 => 16#0706_0504_0302_0100#,
                                K1 => 16#0F0E_0D0C_0B0A_0908#)),
      Second => <>];

   --  Starts the conversion that the controller has requested, if any.
   procedure Serve_Converter;

   --  Runs the steps that are due, and serves the devices after each.
   procedure Run_Steps;

   --  The outputs, the converter and the line have what the tasks have given
   --  them.
   procedure Serve_Devices;

   --  Reports a cell of the RAM that is not sound (TST-5).
   procedure Report_RAM (Where : Word_Address);

   --  Tests cells of the RAM until there is work, or no cell is due.
   procedure Test_RAM;

   procedure Run (Condition : Start_Condition) with No_Return;

   --  The linker drops its handlers where another processor serves the line.
   package Line is new Line_Programs
     (Telemetry_Board.Accept_Character, Telemetry_Board.Next_Character);

   procedure Serve_Converter is
      Wanted  : Boolean;
      Channel : Channel_Number;
   begin
      AD_Board.Take_Start (Wanted, Channel);
      if Wanted then
         Targets.Convert (Channel);
      end if;
   end Serve_Converter;

   procedure On_Tick is
   begin
      Tick_Boards;
      Node.Clock_Interrupt;
      Has_Ticked := True;
      Awake := Targets.Up;
   end On_Tick;

   procedure On_Converted (Value : Unsigned_32) is
      Next : Successor;
   begin
      AD_Board.Pass_Value (Word (Value and 16#FFF#), Next);
      if Next in Next_Channel then
         Targets.Convert (Channel_Number (Next));
      else
         Handle_End (Next, Word (Value and 16#FFF#));
         Scan_Ended := True;
         Awake := Targets.Up;
      end if;
   end On_Converted;

   procedure Serve_Devices is
   begin
      Write_Outputs;
      Serve_Converter;
      Line.Hurry;
   end Serve_Devices;

   procedure Run_Steps is
      Runs_On : Boolean;
   begin
      while not Node.Is_Idle loop
         Node.Run_Step (Runs_On);
         Serve_Devices;
         exit when Runs_On;
      end loop;
   end Run_Steps;

   procedure Report_RAM (Where : Word_Address) is
      Result : constant Word := To_Word (Failure (RAM, Where));
   begin
      CORE_Memory.Write_Status
        ((URV.CORE_Memory.Self_Test_Result => Result));
      Node_Status.Add (URV.Buffers.Self_Test_Failed);
      Errors.Report (URV.Errors.Self_Test_Failed, Result);
   end Report_RAM;

   procedure Test_RAM is
      Is_Sound : Boolean;
      Where    : Word_Address;
   begin
      while not Has_Ticked and then not Scan_Ended
        and then Flight_RAM_Tests.Has_Cell
      loop
         Flight_RAM_Tests.Test_Cell (Is_Sound, Where);
         if not Is_Sound then
            Report_RAM (Where);
         end if;
      end loop;
   end Test_RAM;

   procedure Run (Condition : Start_Condition) is
   begin
      Targets.Open;
      Scan_Ended := False;
      Has_Ticked := False;
      if Condition /= Processor_Restart or else not Board_Is_Started then
         Telemetry_Board.Start;
         Board_Is_Started := True;
      end if;
      Put (Name);
      case Condition is
         when Cold_Start        => Put_Line (" cold start");
         when Warm_Reset        => Put_Line (" warm reset");
         when Processor_Restart => Put_Line (" processor restart");
      end case;

      --  The clock begins after the self-test at power up, and runs on through
      --  all later starts.
      Begin_Start (Condition);
      if Condition = Cold_Start then
         Node.Serve;
      end if;
      Targets.Start_Clock;
      if Condition /= Cold_Start then
         Node.Serve;
      end if;
      Run_Steps;
      Serve_Devices;
      Put (Name);
      if Node.Is_Refused then
         Put_Line (" refused");
      else
         Put_Line (" started");
      end if;
      loop
         Test_RAM;
         Targets.Sleep (Awake'Access);
         Awake := Targets.Down;
         while Has_Ticked or else Scan_Ended loop
            if Has_Ticked then
               Has_Ticked := False;
               Node.Serve;
               Run_Steps;
               Write_Outputs;   --  SAF-11: also without a task
               Targets.Feed_Watchdog;   --  BRD-7
               Flight_RAM_Tests.Begin_Tick;
            else
               Scan_Ended := False;
               Run_Steps;
            end if;
         end loop;
      end loop;
   end Run;

   procedure Run (Condition : Integer_32) is
   begin
      Run (if Condition = 2 then Processor_Restart else Warm_Reset);
   end Run;

   procedure Start is
   begin
      Targets.Keep_Memory;
      Run (Cold_Start);
   end Start;

   procedure Configure (Flags : Unsigned_32; Line_Delay : Unsigned_32) is
   begin
      Set_Laws ((Flags and 1) /= 0);
      if (Flags and 2) /= 0 then
         Sealing.Configure (Format => 2, Keys => Emulated_Keys, Start => 1);
      end if;
      Telemetry_Board.Set_Round_Trip (Round_Trip_Of (Integer (Line_Delay)));
   end Configure;

   procedure Put_Row is
      CORE : constant URV.CORE_Memory.Memory := CORE_Memory.Contents;
   begin
      for Each of CORE.Uplink loop
         Put_Word (Unsigned_16 (Each));
      end loop;
      for Each of CORE.Downlink loop
         Put_Word (Unsigned_16 (Each));
      end loop;
      for Each of CORE.Status loop
         Put_Word (Unsigned_16 (Each));
      end loop;
      Put_Outputs;
      Put_Line;
   end Put_Row;

   procedure Put_Counts is
      Tally : constant Telemetry.Boards.Statistics := Telemetry_Board.Tally;
   begin
      Put (Name);
      Put_Labelled ("overruns", Unsigned_32 (Node.Overruns));
      Put_Labelled ("sent", Unsigned_32 (Tally.Sent));
      Put_Labelled ("received", Unsigned_32 (Tally.Received));
      Put_Labelled ("bad", Unsigned_32 (Tally.Bad));
      Put_Labelled ("scrapped", Unsigned_32 (Tally.Scrapped));
      Put_Labelled ("resets", Unsigned_32 (Tally.Resets));
      Put_Labelled ("stack", Targets.Stack_Used);
      Put_Line;
   end Put_Counts;

end Node_Programs;
