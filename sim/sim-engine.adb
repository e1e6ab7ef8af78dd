--  SPDX-License-Identifier: Apache-2.0

with Host.Memory_Hardware; use Host.Memory_Hardware;
with Sim.Agenda;           use Sim.Agenda;
with Sim.Controllers;
with Sim.Faulty_Line;      use Sim.Faulty_Line;
with Sim.Hardware_Faults;  use Sim.Hardware_Faults;
with Sim.Slow_Lines;
with Sim.Windows;          use Sim.Windows;
with Sim.Wire_Log;
with Telemetry;            use Telemetry;
with Telemetry.Boards;
with URV.Buffers;          use URV.Buffers;
with URV.Routing;
with URVOS;                use URVOS;
with URVOS.Starts;         use URVOS.Starts;

package body Sim.Engine is

   Time_Out  : constant array (Node) of Event :=
     (Ground => GSC_Time_Out, Aircraft => MCS_Time_Out);
   Sent      : constant array (Node) of Event :=
     (Ground => Character_Up, Aircraft => Character_Down);
   Arrived   : constant array (Node) of Event :=
     (Ground => Arrival_Up, Aircraft => Arrival_Down);
   Extra     : constant array (Node) of Event :=
     (Ground => Extra_Up, Aircraft => Extra_Down);
   Converted : constant array (Node) of Event :=
     (Ground => GSC_Converted, Aircraft => MCS_Converted);

   --  The state of a telemetry board's hardware.
   type Hardware is record
      --  The time up to which its timer has counted.
      Timer   : Microseconds := 0;

      --  The stalls of its processor.
      Stalls  : Windows.List;

      --  Its DUART has lost unread characters, and will report that with the
      --  next one.
      Overrun : Boolean := False;

      --  The other board receives this when the character on the line has been
      --  sent.
      On_Line : Delivery;

      --  Additional arrivals at the time of Extra.
      Added   : Arrival_List;
   end record;

   Boards : array (Node) of Hardware;

   Link_Line : Line;

   --  The delay of the line from a character's last bit to the other board:
   --  zero on a wire (LNK-11).
   Line_Time : Microseconds := 0;

   --  Restarts a telemetry board.
   procedure Restart
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer);

   --  The next fault of a node's hardware happens.
   procedure Apply_Hardware_Fault
     (Time : Microseconds;
      Wire : in out Text_Output.Writer);

   --  True if Update_Stall has seen the end of every stall so far.
   function Runs (Which : Node; Time : Microseconds) return Boolean;

   --  Stalled is True if the board's processor is stalled. A completed stall
   --  moves its timer forward.
   procedure Update_Stall
     (Which   : Node;
      Time    : Microseconds;
      Stalled : out Boolean)
   with No_Inline;

   --  The character times since the last query of the board's timer.
   procedure Ask_Timer
     (Which   : Node;
      Time    : Microseconds;
      Elapsed : out Character_Times)
   with Inline_Always;

   --  The frequent operations on characters have one instance for each node,
   --  which needs no look-up of the node's constants.

   --  A character reaches the board.
   procedure Hear
     (Listener  : Node;
      Time      : Microseconds;
      Heard     : Arrival;
      May_Speak : out Boolean)
   with Inline_Always;

   --  Lets the telemetry board transmit, if its transmitter is empty.
   procedure Serve
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer)
   with Inline_Always;

   --  The same, for the rare calls.
   procedure Serve_Telemetry
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer)
   with No_Inline;

   --  The node's character has been sent: the other board receives it, then
   --  either may transmit.
   procedure End_Character
     (Sender : Node;
      Time   : Microseconds;
      Wire   : in out Text_Output.Writer)
   with Inline_Always;

   --  The other board receives the characters inserted before this one.
   procedure Insert (Sender : Node; Time : Microseconds) with No_Inline;

   --  On a slow line a character reaches the other board later.
   procedure Delay_Arrival
     (Sender : Node;
      Time   : Microseconds;
      Heard  : Arrival)
   with No_Inline;

   procedure Delay_Character (Sender : Node; Time : Microseconds)
   with No_Inline;

   --  The delayed character arrives.
   procedure Hear_Late
     (Sender : Node;
      Time   : Microseconds;
      Wire   : in out Text_Output.Writer);

   --  The other board receives the characters that the line has added to the
   --  node's.
   procedure Hear_Extra
     (Sender : Node;
      Time   : Microseconds;
      Wire   : in out Text_Output.Writer);

   --  The controller has run: the telemetry board may send its new data. A
   --  board that waits for the other one does not transmit.
   procedure Serve_After_Tasks
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer);

   procedure Tick
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer);

   procedure End_Conversion
     (Which : Node;
      Time  : Microseconds;
      Stop  : Microseconds;
      Wire  : in out Text_Output.Writer);

   procedure End_Start
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer);

   procedure Restart
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer) is
   begin
      Restart_Telemetry (Which);
      Boards (Which).Overrun := False;
      Serve_Telemetry (Which, Time, Wire);
   end Restart;

   procedure Apply_Hardware_Fault
     (Time : Microseconds;
      Wire : in out Text_Output.Writer)
   is
      Item : Faults.Fault;
   begin
      Take_Next (Item);
      if Next_Time = Host.Never then
         Cancel (Hardware_Fault);
      else
         Schedule (Hardware_Fault, Next_Time);
      end if;

      case Faults.Hardware_Fault'(Item.Kind) is
         when Faults.Reset =>
            --  A node that was never switched on cannot restart.
            if Controllers.Is_On (Item.Where) then
               case Item.How is
                  when Faults.Cold =>
                     Restart (Item.Where, Time, Wire);
                     Controllers.Begin_Start (Item.Where, Time, Cold_Start);
                  when Faults.Warm =>
                     Restart (Item.Where, Time, Wire);
                     Controllers.Begin_Start (Item.Where, Time, Warm_Reset);
                  when Faults.Processor =>
                     Controllers.Begin_Start
                       (Item.Where, Time, Processor_Restart);
                  when Faults.Telemetry_Board =>
                     Restart (Item.Where, Time, Wire);
               end case;
            end if;

         when Faults.ROM_Harm =>
            Spoil_ROM (Memory_Of (Item.Where), Item.Byte_At, Item.Flips);

         when Faults.RAM_Harm =>
            Stick_RAM (Memory_Of (Item.Where), Item.Word_At, Item.Zeros);

         when Faults.Halt =>
            Controllers.Halt (Item.Where);

         when Faults.Bus_Error =>
            Fail_Next_Read (Memory_Of (Item.Where));
      end case;
   end Apply_Hardware_Fault;

   function Runs (Which : Node; Time : Microseconds) return Boolean is
     (Next (Boards (Which).Stalls).First > Time);

   procedure Update_Stall
     (Which   : Node;
      Time    : Microseconds;
      Stalled : out Boolean)
   is
      Board : Hardware renames Boards (Which);
   begin
      while Next (Board.Stalls).Stop <= Time loop
         Board.Timer := Board.Timer + Next (Board.Stalls).Stop
           - Microseconds'Max (Board.Timer, Next (Board.Stalls).First);
         Skip (Board.Stalls);
      end loop;
      Stalled := Next (Board.Stalls).First <= Time;
   end Update_Stall;

   procedure Ask_Timer
     (Which   : Node;
      Time    : Microseconds;
      Elapsed : out Character_Times)
   is
      Board : Hardware renames Boards (Which);
      Since : constant Microseconds'Base := Time - Board.Timer;
      Whole : Microseconds;
   begin
      --  Mostly none or one.
      if Since < Character_Time then
         Elapsed := 0;
      elsif Since < 2 * Character_Time then
         Board.Timer := Board.Timer + Character_Time;
         Elapsed := 1;
      else
         Whole := Since / Character_Time;
         Board.Timer := Board.Timer + Whole * Character_Time;
         Elapsed := Character_Times
           (Microseconds'Min (Whole, Microseconds (Character_Times'Last)));
      end if;
   end Ask_Timer;

   procedure Hear
     (Listener  : Node;
      Time      : Microseconds;
      Heard     : Arrival;
      May_Speak : out Boolean)
   is
      Board   : Hardware renames Boards (Listener);
      Stalled : Boolean := False;
      Elapsed : Character_Times;
   begin
      if not Runs (Listener, Time) then
         Update_Stall (Listener, Time, Stalled);
      end if;
      if Stalled then
         Board.Overrun := True;
         May_Speak := False;
      else
         Ask_Timer (Listener, Time, Elapsed);
         Accept_Character
           (Listener,
            Elapsed,
            Heard.Data,
            Heard.Parity_Error or else Board.Overrun,
            May_Speak);
         Board.Overrun := False;
      end if;
   end Hear;

   procedure Serve
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer)
   is
      Board     : Hardware renames Boards (Which);
      Stalled   : Boolean;
      Elapsed   : Character_Times;
      Time_Left : Character_Times;
      Send      : Boolean;
      Data      : Byte;
   begin
      if Is_Due (Sent (Which)) then
         return;
      end if;

      if not Runs (Which, Time) then
         Update_Stall (Which, Time, Stalled);
         if Stalled then
            Schedule (Time_Out (Which), Next (Board.Stalls).Stop);
            return;
         end if;
      end if;

      Ask_Timer (Which, Time, Elapsed);
      Next_Character (Which, Elapsed, Send, Data, Time_Left);

      if Send then
         Schedule (Sent (Which), Time + Character_Time);
         Transmit
           (Link_Line, Path_From (Which), Time, Data, Board.On_Line);

         --  An inserted character arrives at once, or after a doubled one that
         --  must still arrive before the character now sent.
         if Board.On_Line.Before.Length > 0 then
            Insert (Which, Time);
         end if;

         if Text_Output.Is_Open (Wire) then
            Wire_Log.Write_Byte (Wire, Time, Path_From (Which), Data);
         end if;
      end if;

      if Time_Left = Character_Times'Last then
         Cancel (Time_Out (Which));
      else
         Schedule
           (Time_Out (Which),
            Board.Timer + Microseconds (Time_Left) * Character_Time);
      end if;
   end Serve;

   procedure Serve_Telemetry
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer) is
   begin
      case Which is
         when Ground   => Serve (Ground, Time, Wire);
         when Aircraft => Serve (Aircraft, Time, Wire);
      end case;
   end Serve_Telemetry;

   procedure End_Character
     (Sender : Node;
      Time   : Microseconds;
      Wire   : in out Text_Output.Writer)
   is
      Board     : Hardware renames Boards (Sender);
      May_Speak : Boolean := False;
   begin
      Cancel (Sent (Sender));
      if Line_Time > 0 then
         Delay_Character (Sender, Time);
      else
         if not Board.On_Line.Is_Lost then
            Hear (Other (Sender), Time, Board.On_Line.Itself, May_Speak);
         end if;
         if Board.On_Line.After.Length > 0 then
            Append (Board.Added, Board.On_Line.After);
            Schedule (Extra (Sender), Time + Character_Time);
         end if;

         --  A time-out entered before the character arrived is now too early.
         --  When it is due the board will report the new one.
         if May_Speak or else not Is_Due (Time_Out (Other (Sender))) then
            Serve_Telemetry (Other (Sender), Time, Wire);
         end if;
      end if;
      Serve (Sender, Time, Wire);
   end End_Character;

   procedure Insert (Sender : Node; Time : Microseconds) is
      Board : Hardware renames Boards (Sender);
   begin
      if Line_Time > 0 then
         for Index in 1 .. Board.On_Line.Before.Length loop
            Delay_Arrival (Sender, Time, Board.On_Line.Before.Items (Index));
         end loop;
      else
         Append (Board.Added, Board.On_Line.Before);
         if not Is_Due (Extra (Sender)) then
            Schedule (Extra (Sender), Time);
         end if;
      end if;
   end Insert;

   procedure Delay_Arrival
     (Sender : Node;
      Time   : Microseconds;
      Heard  : Arrival) is
   begin
      Slow_Lines.Put (Path_From (Sender), Time + Line_Time, Heard);
      Schedule
        (Arrived (Sender), Slow_Lines.Next_Time (Path_From (Sender)));
   end Delay_Arrival;

   procedure Delay_Character (Sender : Node; Time : Microseconds) is
      Board : Hardware renames Boards (Sender);
   begin
      if not Board.On_Line.Is_Lost then
         Delay_Arrival (Sender, Time, Board.On_Line.Itself);
      end if;
      for Index in 1 .. Board.On_Line.After.Length loop
         Delay_Arrival
           (Sender, Time + Character_Time, Board.On_Line.After.Items (Index));
      end loop;
   end Delay_Character;

   procedure Hear_Late
     (Sender : Node;
      Time   : Microseconds;
      Wire   : in out Text_Output.Writer)
   is
      Path      : constant Direction := Path_From (Sender);
      Heard     : Arrival;
      May_Speak : Boolean;
   begin
      Slow_Lines.Take (Path, Heard);
      if Slow_Lines.Next_Time (Path) = Host.Never then
         Cancel (Arrived (Sender));
      else
         Schedule (Arrived (Sender), Slow_Lines.Next_Time (Path));
      end if;
      Hear (Other (Sender), Time, Heard, May_Speak);
      if May_Speak or else not Is_Due (Time_Out (Other (Sender))) then
         Serve_Telemetry (Other (Sender), Time, Wire);
      end if;
   end Hear_Late;

   procedure Hear_Extra
     (Sender : Node;
      Time   : Microseconds;
      Wire   : in out Text_Output.Writer)
   is
      Board            : Hardware renames Boards (Sender);
      Unused_May_Speak : Boolean;
   begin
      Cancel (Extra (Sender));
      for Index in 1 .. Board.Added.Length loop
         Hear
           (Other (Sender), Time, Board.Added.Items (Index),
            Unused_May_Speak);
      end loop;
      Board.Added.Length := 0;
      Serve_Telemetry (Other (Sender), Time, Wire);
   end Hear_Extra;

   procedure Serve_After_Tasks
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer) is
   begin
      if not Is_Due (Time_Out (Which)) then
         Serve_Telemetry (Which, Time, Wire);
      end if;
   end Serve_After_Tasks;

   procedure Tick
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer) is
   begin
      Controllers.Tick (Which, Time);
      Serve_After_Tasks (Which, Time, Wire);
   end Tick;

   procedure End_Conversion
     (Which : Node;
      Time  : Microseconds;
      Stop  : Microseconds;
      Wire  : in out Text_Output.Writer)
   is
      Last     : Microseconds := Time;
      Have_Run : Boolean;
   begin
      Controllers.End_Conversion
        (Which, Last,
         Until_Time =>
           Microseconds'Min (Stop, First_Besides (Converted (Which))),
         Have_Run   => Have_Run);
      if Have_Run then
         Serve_After_Tasks (Which, Last, Wire);
      end if;
   end End_Conversion;

   procedure End_Start
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer) is
   begin
      Controllers.End_Start (Which, Time);
      Serve_Telemetry (Which, Time, Wire);
   end End_Start;

   procedure Start
     (Lag        : Microseconds;
      Script     : Faults.Script;
      Seed       : Seed_Number;
      Processors : Processor_Count := 1;
      Drift      : Drift_Number := 0;
      Line       : Telemetry.Line_Delay := 0) is
   begin
      Line_Time := Microseconds (Line);
      Slow_Lines.Clear;
      Boards :=
        (Ground   => (others => <>),
         Aircraft => (Timer => Lag, others => <>));
      for Which in Node loop
         Repair (Memory_Of (Which));
         Boards (Which).Stalls :=
           Faults.Stalls (Script, Which, Faults.Telemetry);
      end loop;

      Agenda.Clear;
      Controllers.Prepare (Lag, Drift, Script, Processors);
      Prepare (Link_Line, Script, Seed);
      Hardware_Faults.Prepare (Script);
      if Next_Time < Host.Never then
         Schedule (Hardware_Fault, Next_Time);
      end if;

      Set_Console (Neutral_Console);
      Set_Sensors (Neutral_Sensors);
   end Start;

   procedure Run
     (Stop : Microseconds;
      Wire : in out Text_Output.Writer)
   is
      Next : Event;
      Time : Microseconds;
   begin
      loop
         Find_First (Next, Time);
         exit when Time >= Stop;

         case Next is
            when Arrival_Up     => Hear_Late (Ground, Time, Wire);
            when Arrival_Down   => Hear_Late (Aircraft, Time, Wire);
            when Extra_Up       => Hear_Extra (Ground, Time, Wire);
            when Extra_Down     => Hear_Extra (Aircraft, Time, Wire);
            when Character_Up   => End_Character (Ground, Time, Wire);
            when Character_Down => End_Character (Aircraft, Time, Wire);
            when Hardware_Fault => Apply_Hardware_Fault (Time, Wire);
            when GSC_Converted  => End_Conversion (Ground, Time, Stop, Wire);
            when MCS_Converted  => End_Conversion (Aircraft, Time, Stop, Wire);
            when GSC_Time_Out   => Serve_Telemetry (Ground, Time, Wire);
            when MCS_Time_Out   => Serve_Telemetry (Aircraft, Time, Wire);
            when GSC_Clock      => Tick (Ground, Time, Wire);
            when MCS_Clock      => Tick (Aircraft, Time, Wire);
            when GSC_Started    => End_Start (Ground, Time, Wire);
            when MCS_Started    => End_Start (Aircraft, Time, Wire);
         end case;
      end loop;
   end Run;

   procedure Set_Console (Words : Console_Words) is
   begin
      for Item in Command_Item loop
         Controllers.Set_Input
           (Ground, URV.Routing.Channel_Of (Item), Words (Item));
      end loop;
   end Set_Console;

   procedure Set_Sensors (Words : Sensor_Words) is
   begin
      for Item in Sensor_Item loop
         Controllers.Set_Input
           (Aircraft, URV.Routing.Channel_Of (Item), Words (Item));
      end loop;
   end Set_Sensors;

   function Awaited_Characters return Natural is (Awaited (Link_Line));

   function Link return Link_Counts is
      GSC : constant Telemetry.Boards.Statistics := Tally (Ground);
      MCS : constant Telemetry.Boards.Statistics := Tally (Aircraft);
   begin
      return
        (Uplink_Sent       => GSC.Sent,
         Uplink_Received   => MCS.Received,
         Uplink_Bad        => MCS.Bad,
         Uplink_Scrapped   => GSC.Scrapped,
         Downlink_Sent     => MCS.Sent,
         Downlink_Received => GSC.Received,
         Downlink_Bad      => GSC.Bad,
         Downlink_Scrapped => MCS.Scrapped,
         GSC_Resets        => GSC.Resets,
         MCS_Resets        => MCS.Resets);
   end Link;

end Sim.Engine;
