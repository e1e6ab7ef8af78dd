with Devices.AD_Board;
with Sim.Faulty_Line;  use Sim.Faulty_Line;
with Sim.Nodes;        use Sim.Nodes;
with Sim.Windows;      use Sim.Windows;
with Sim.Wire_Log;
with Telemetry;        use Telemetry;
with Telemetry.Boards;
with URV.Routing;
with URVOS.Frames;     use URVOS.Frames;

package body Sim.Engine is

   Conversion_Time : constant Microseconds :=
     Devices.AD_Board.Microseconds_Per_Conversion;

   --  What can happen. Of events at the same instant the first named
   --  happens first.
   type Event is
     (Extra_Up, Extra_Down,               --  one more comes than was sent
      Character_Up, Character_Down,       --  a character has been sent
      GSC_Restart, MCS_Restart,           --  a telemetry board starts anew
      GSC_Converted, MCS_Converted,       --  an A/D conversion is done
      GSC_Time_Out, MCS_Time_Out,         --  a telemetry board's patience
      GSC_Clock, MCS_Clock);              --  a minor frame begins

   --  When each happens next: the time and, so that one comparison finds
   --  the first of several at the same instant, the place of the event in
   --  the order above.
   type Entry_Time is range 0 .. 2 ** 63 - 1;
   Agenda : array (Event) of Entry_Time := (others => Entry_Time'Last);

   function Is_Due (What : Event) return Boolean is
     (Agenda (What) /= Entry_Time'Last);

   Restart   : constant array (Node) of Event :=
     (GSC => GSC_Restart, MCS => MCS_Restart);
   Converted : constant array (Node) of Event :=
     (GSC => GSC_Converted, MCS => MCS_Converted);
   Time_Out  : constant array (Node) of Event :=
     (GSC => GSC_Time_Out, MCS => MCS_Time_Out);
   Clock     : constant array (Node) of Event :=
     (GSC => GSC_Clock, MCS => MCS_Clock);
   Sent      : constant array (Node) of Event :=
     (GSC => Character_Up, MCS => Character_Down);
   Extra     : constant array (Node) of Event :=
     (GSC => Extra_Up, MCS => Extra_Down);

   --  What a node's hardware knows.
   type Hardware is record
      Switched_On : Microseconds := 0;
      Now         : Clock_Tick   := 0;

      --  The value held by the A/D board while it converts.
      Held        : Word := 0;

      --  Up to where the telemetry board's timer has been told.
      Timer       : Microseconds := 0;

      --  When the telemetry board's processor stands still.
      Stalls      : Windows.List;

      --  When it starts anew: at the first instant of each.
      Restarts    : Windows.List;

      --  Its DUART has lost characters that nobody read, and will say so
      --  with the next one.
      Overrun     : Boolean := False;

      --  What the other board will have heard when the character on the
      --  line has been sent.
      On_Line     : Delivery;

      --  What it hears besides, when Extra is due.
      Added       : Arrival_List;
   end record;

   Nodes_Hardware : array (Node) of Hardware;

   Link_Line : Line;

   --  What each converter's channels see.
   Inputs : array (Node) of Channel_Words :=
     (others => (others => Neutral_Value));

   procedure Prepare_Boards (Script : Faults.Script);

   --  A telemetry board starts anew.
   procedure Start_Anew
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer);

   --  Enters when an event happens next.
   procedure Schedule (What : Event; Time : Microseconds) with Inline;

   procedure Cancel (What : Event) with Inline;

   --  The board's processor stands still. Its timer is set on by every
   --  stall that is over.
   procedure Ask_Stalled
     (Which   : Node;
      Time    : Microseconds;
      Stalled : out Boolean);

   --  The character times since the board's timer was last asked.
   procedure Ask_Timer
     (Which   : Node;
      Time    : Microseconds;
      Elapsed : out Character_Times);

   --  What has come from the sender reaches the other board.
   procedure Hear
     (Sender    : Node;
      Time      : Microseconds;
      Heard     : Arrival_List;
      May_Speak : out Boolean);

   --  Gives the telemetry board its turn, if its transmitter is empty.
   procedure Serve_Telemetry
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer);

   --  The node's character has been sent: the other board hears it, then
   --  either may speak.
   procedure End_Character
     (Sender : Node;
      Time   : Microseconds;
      Wire   : in out Text_Output.Writer);

   --  The other board hears what the line has added to the node's
   --  characters.
   procedure Hear_Extra
     (Sender : Node;
      Time   : Microseconds;
      Wire   : in out Text_Output.Writer);

   --  Begins the conversion that the controller has asked for, if any. The
   --  board holds the channel's value from now on.
   procedure Serve_Converter (Which : Node; Time : Microseconds);

   --  The conversion is done.
   procedure End_Conversion (Which : Node; Time : Microseconds);

   --  A minor frame begins, the node's first one with power up.
   procedure Tick
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer);

   procedure Prepare_Boards (Script : Faults.Script) is
      use type Faults.Fault_Kind;
      use type Faults.Node;
   begin
      for Index in 1 .. Faults.Length (Script) loop
         declare
            Fault : constant Faults.Fault := Faults.Element (Script, Index);
         begin
            if Fault.Kind = Faults.Stall then
               Add
                 (Nodes_Hardware
                    (if Fault.Where = Faults.GSC then GSC else MCS).Stalls,
                  (Fault.Time, Fault.Time + Fault.Duration));
            elsif Fault.Kind = Faults.Reset then
               Add
                 (Nodes_Hardware
                    (if Fault.Where = Faults.GSC then GSC else MCS).Restarts,
                  (Fault.Time, Fault.Time + 1));
            end if;
         end;
      end loop;

      for Which in Node loop
         if Next (Nodes_Hardware (Which).Restarts) /= Never then
            Schedule
              (Restart (Which), Next (Nodes_Hardware (Which).Restarts).First);
         end if;
      end loop;
   end Prepare_Boards;

   procedure Start_Anew
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer)
   is
      Board : Hardware renames Nodes_Hardware (Which);
   begin
      Skip (Board.Restarts);
      if Next (Board.Restarts) = Never then
         Cancel (Restart (Which));
      else
         Schedule (Restart (Which), Next (Board.Restarts).First);
      end if;

      --  Before it is switched on there is nothing to start anew.
      if Time > Board.Switched_On then
         Restart_Telemetry (Which);
         Board.Overrun := False;
         Serve_Telemetry (Which, Time, Wire);
      end if;
   end Start_Anew;

   procedure Schedule (What : Event; Time : Microseconds) is
   begin
      Agenda (What) :=
        Entry_Time (Time) * Event'Range_Length
        + Event'Pos (What);
   end Schedule;

   procedure Cancel (What : Event) is
   begin
      Agenda (What) := Entry_Time'Last;
   end Cancel;

   procedure Ask_Stalled
     (Which   : Node;
      Time    : Microseconds;
      Stalled : out Boolean)
   is
      Board : Hardware renames Nodes_Hardware (Which);
   begin
      while Next (Board.Stalls).Stop <= Time loop
         Board.Timer := Board.Timer + Next (Board.Stalls).Stop
           - Microseconds'Max (Board.Timer, Next (Board.Stalls).First);
         Skip (Board.Stalls);
      end loop;
      Stalled := Next (Board.Stalls).First <= Time;
   end Ask_Stalled;

   procedure Ask_Timer
     (Which   : Node;
      Time    : Microseconds;
      Elapsed : out Character_Times)
   is
      Board : Hardware renames Nodes_Hardware (Which);
      Whole : constant Microseconds :=
        (Time - Board.Timer) / Character_Time;
   begin
      Board.Timer := Board.Timer + Whole * Character_Time;
      Elapsed := Character_Times
        (Microseconds'Min (Whole, Microseconds (Character_Times'Last)));
   end Ask_Timer;

   procedure Hear
     (Sender    : Node;
      Time      : Microseconds;
      Heard     : Arrival_List;
      May_Speak : out Boolean)
   is
      Listener : constant Node := Other (Sender);
      Board    : Hardware renames Nodes_Hardware (Listener);
      Stalled  : Boolean;
      Elapsed  : Character_Times;
   begin
      May_Speak := False;
      Ask_Stalled (Listener, Time, Stalled);
      if Stalled then
         Board.Overrun := Board.Overrun or else Heard.Length > 0;
         return;
      end if;

      for Index in 1 .. Heard.Length loop
         Ask_Timer (Listener, Time, Elapsed);
         Accept_Character
           (Listener,
            Elapsed,
            Heard.Items (Index).Data,
            Heard.Items (Index).Parity_Error or else Board.Overrun,
            May_Speak);
         Board.Overrun := False;
      end loop;
   end Hear;

   procedure Serve_Telemetry
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer)
   is
      Board     : Hardware renames Nodes_Hardware (Which);
      Stalled   : Boolean;
      Elapsed   : Character_Times;
      Time_Left : Character_Times;
      Send      : Boolean;
      Data      : Byte;
   begin
      if Is_Due (Sent (Which)) then
         return;
      end if;

      Ask_Stalled (Which, Time, Stalled);
      if Stalled then
         Schedule (Time_Out (Which), Next (Board.Stalls).Stop);
         return;
      end if;

      Ask_Timer (Which, Time, Elapsed);
      Next_Character (Which, Elapsed, Send, Data, Time_Left);

      if Send then
         Schedule (Sent (Which), Time + Character_Time);
         Transmit
           (Link_Line, Way_From (Which), Time, Data, Board.On_Line);

         --  An inserted character comes at once, or behind the doubled one
         --  that is still to come before the character now sent.
         if Board.On_Line.Before.Length > 0 then
            Append (Board.Added, Board.On_Line.Before);
            if not Is_Due (Extra (Which)) then
               Schedule (Extra (Which), Time);
            end if;
         end if;

         if Text_Output.Is_Open (Wire) then
            Wire_Log.Write_Byte (Wire, Time, Way_From (Which), Data);
         end if;
      end if;

      if Time_Left = Character_Times'Last then
         Cancel (Time_Out (Which));
      else
         Schedule
           (Time_Out (Which),
            Board.Timer + Microseconds (Time_Left) * Character_Time);
      end if;
   end Serve_Telemetry;

   procedure End_Character
     (Sender : Node;
      Time   : Microseconds;
      Wire   : in out Text_Output.Writer)
   is
      Board     : Hardware renames Nodes_Hardware (Sender);
      Itself    : Arrival_List;
      May_Speak : Boolean := False;
   begin
      Cancel (Sent (Sender));

      if not Board.On_Line.Is_Lost then
         Append (Itself, Board.On_Line.Itself);
         Hear (Sender, Time, Itself, May_Speak);
      end if;
      if Board.On_Line.After.Length > 0 then
         Append (Board.Added, Board.On_Line.After);
         Schedule (Extra (Sender), Time + Character_Time);
      end if;

      --  A time-out entered before the character came is too early by now.
      --  When it is due the board will say so.
      if May_Speak or else not Is_Due (Time_Out (Other (Sender))) then
         Serve_Telemetry (Other (Sender), Time, Wire);
      end if;
      Serve_Telemetry (Sender, Time, Wire);
   end End_Character;

   procedure Hear_Extra
     (Sender : Node;
      Time   : Microseconds;
      Wire   : in out Text_Output.Writer)
   is
      Board     : Hardware renames Nodes_Hardware (Sender);
      May_Speak : Boolean;
   begin
      Cancel (Extra (Sender));
      Hear (Sender, Time, Board.Added, May_Speak);
      Board.Added.Length := 0;
      Serve_Telemetry (Other (Sender), Time, Wire);
   end Hear_Extra;

   procedure Serve_Converter (Which : Node; Time : Microseconds) is
      Wanted  : Boolean;
      Channel : Devices.AD_Board.Channel_Number;
   begin
      Take_Start (Which, Wanted, Channel);
      if Wanted then
         Nodes_Hardware (Which).Held :=
           Inputs (Which) (URV.Buffers.Channel (Channel));
         Schedule (Converted (Which), Time + Conversion_Time);
      end if;
   end Serve_Converter;

   procedure End_Conversion (Which : Node; Time : Microseconds) is
   begin
      Cancel (Converted (Which));
      Finish_Conversion (Which, Nodes_Hardware (Which).Held);
      Serve_Converter (Which, Time);
   end End_Conversion;

   procedure Tick
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer)
   is
      Board : Hardware renames Nodes_Hardware (Which);
   begin
      if Time = Board.Switched_On then
         Switch_On (Which);
      else
         Board.Now := Advanced (Board.Now);
         Clock_Interrupt (Which, Board.Now);
      end if;
      Schedule (Clock (Which), Time + Tick_Time);

      Serve_Converter (Which, Time);
      Serve_Telemetry (Which, Time, Wire);
   end Tick;

   procedure Start
     (Lag    : Microseconds;
      Script : Faults.Script;
      Seed   : Noise.Seed_Number) is
   begin
      Nodes_Hardware :=
        (GSC => (others => <>),
         MCS => (Switched_On => Lag, Timer => Lag, others => <>));
      Agenda := (others => Entry_Time'Last);
      Schedule (GSC_Clock, 0);
      Schedule (MCS_Clock, Lag);
      Prepare (Link_Line, Script, Seed);
      Prepare_Boards (Script);
      Set_Console (Neutral_Console);
      Set_Sensors (Neutral_Sensors);
   end Start;

   procedure Run
     (Stop : Microseconds;
      Wire : in out Text_Output.Writer)
   is
      Next : Entry_Time;
      Time : Microseconds;
   begin
      loop
         Next := Agenda (Event'First);
         for Candidate in Event range Event'Succ (Event'First) .. Event'Last
         loop
            Next := Entry_Time'Min (Next, Agenda (Candidate));
         end loop;

         Time := Microseconds (Next / Event'Range_Length);
         exit when Time >= Stop;

         case Event'Val (Next mod Event'Range_Length) is
            when Extra_Up       => Hear_Extra (GSC, Time, Wire);
            when Extra_Down     => Hear_Extra (MCS, Time, Wire);
            when Character_Up   => End_Character (GSC, Time, Wire);
            when Character_Down => End_Character (MCS, Time, Wire);
            when GSC_Converted  => End_Conversion (GSC, Time);
            when MCS_Converted  => End_Conversion (MCS, Time);
            when GSC_Time_Out   => Serve_Telemetry (GSC, Time, Wire);
            when MCS_Time_Out   => Serve_Telemetry (MCS, Time, Wire);
            when GSC_Restart    => Start_Anew (GSC, Time, Wire);
            when MCS_Restart    => Start_Anew (MCS, Time, Wire);
            when GSC_Clock      => Tick (GSC, Time, Wire);
            when MCS_Clock      => Tick (MCS, Time, Wire);
         end case;
      end loop;
   end Run;

   procedure Set_Console (Words : Console_Words) is
   begin
      for Item in Command_Item loop
         Inputs (GSC) (URV.Routing.Channel_Of (Item)) := Words (Item);
      end loop;
   end Set_Console;

   procedure Set_Sensors (Words : Sensor_Words) is
   begin
      for Item in Sensor_Item loop
         Inputs (MCS) (URV.Routing.Channel_Of (Item)) := Words (Item);
      end loop;
   end Set_Sensors;

   function Link return Link_Counts is
      Ground   : constant Telemetry.Boards.Statistics := Tally (GSC);
      Aircraft : constant Telemetry.Boards.Statistics := Tally (MCS);
   begin
      return
        (Uplink_Sent       => Ground.Sent,
         Uplink_Received   => Aircraft.Received,
         Uplink_Bad        => Aircraft.Bad,
         Uplink_Scrapped   => Ground.Scrapped,
         Downlink_Sent     => Aircraft.Sent,
         Downlink_Received => Ground.Received,
         Downlink_Bad      => Ground.Bad,
         Downlink_Scrapped => Aircraft.Scrapped,
         GSC_Resets        => Ground.Resets,
         MCS_Resets        => Aircraft.Resets);
   end Link;

end Sim.Engine;
