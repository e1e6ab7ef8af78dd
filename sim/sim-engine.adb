with Devices.AD_Board;
with Sim.Faulty_Line;  use Sim.Faulty_Line;
with Sim.Nodes;        use Sim.Nodes;
with Sim.Wire_Log;
with Telemetry;        use Telemetry;
with Telemetry.Boards;
with URV.Routing;
with URVOS.Frames;     use URVOS.Frames;

package body Sim.Engine is

   Never : constant Microseconds := Microseconds'Last;

   Conversion_Time : constant Microseconds :=
     Devices.AD_Board.Microseconds_Per_Conversion;

   --  What can happen. Of events at the same instant the first named
   --  happens first.
   type Event is
     (Character_Up, Character_Down,       --  a character has been sent
      GSC_Converted, MCS_Converted,       --  an A/D conversion is done
      GSC_Time_Out, MCS_Time_Out,         --  a telemetry board's patience
      GSC_Clock, MCS_Clock);              --  a minor frame begins

   --  When each happens next.
   Agenda : array (Event) of Microseconds := (others => Never);

   Converted : constant array (Node) of Event :=
     (GSC => GSC_Converted, MCS => MCS_Converted);
   Time_Out  : constant array (Node) of Event :=
     (GSC => GSC_Time_Out, MCS => MCS_Time_Out);
   Clock     : constant array (Node) of Event :=
     (GSC => GSC_Clock, MCS => MCS_Clock);
   Sent      : constant array (Node) of Event :=
     (GSC => Character_Up, MCS => Character_Down);

   --  What a node's hardware knows.
   type Hardware is record
      Switched_On : Microseconds := 0;
      Now         : Clock_Tick   := 0;

      --  The value held by the A/D board while it converts.
      Held        : Word := 0;

      --  Up to where the telemetry board's timer has been told.
      Timer       : Microseconds := 0;

      --  What will have come to the other board when the character on the
      --  line has been sent.
      Arrivals    : Arrival_Count := 0;
      Arriving    : Arrival_List;
   end record;

   Nodes_Hardware : array (Node) of Hardware;

   Link_Line : Line;

   --  What each converter's channels see.
   Inputs : array (Node) of Channel_Words :=
     (others => (others => Neutral_Value));

   --  The character times since the board's timer was last asked.
   procedure Ask_Timer
     (Which   : Node;
      Time    : Microseconds;
      Elapsed : out Character_Times);

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

   procedure Serve_Telemetry
     (Which : Node;
      Time  : Microseconds;
      Wire  : in out Text_Output.Writer)
   is
      Board     : Hardware renames Nodes_Hardware (Which);
      Elapsed   : Character_Times;
      Time_Left : Character_Times;
      Send      : Boolean;
      Data      : Byte;
   begin
      if Agenda (Sent (Which)) /= Never then
         return;
      end if;

      Ask_Timer (Which, Time, Elapsed);
      Next_Character (Which, Elapsed, Send, Data, Time_Left);

      if Send then
         Agenda (Sent (Which)) := Time + Character_Time;
         Transmit
           (Link_Line, Way_From (Which), Time, Data,
            Board.Arrivals, Board.Arriving);
         if Text_Output.Is_Open (Wire) then
            Wire_Log.Write_Byte (Wire, Time, Way_From (Which), Data);
         end if;
      end if;

      Agenda (Time_Out (Which)) :=
        (if Time_Left = Character_Times'Last then Never
         else Board.Timer + Microseconds (Time_Left) * Character_Time);
   end Serve_Telemetry;

   procedure End_Character
     (Sender : Node;
      Time   : Microseconds;
      Wire   : in out Text_Output.Writer)
   is
      Board   : Hardware renames Nodes_Hardware (Sender);
      Elapsed : Character_Times;
   begin
      Agenda (Sent (Sender)) := Never;

      for I in 1 .. Board.Arrivals loop
         Ask_Timer (Other (Sender), Time, Elapsed);
         Accept_Character
           (Other (Sender),
            Elapsed,
            Board.Arriving (I).Data,
            Board.Arriving (I).Parity_Error);
      end loop;

      if Board.Arrivals > 0 then
         Serve_Telemetry (Other (Sender), Time, Wire);
      end if;
      Serve_Telemetry (Sender, Time, Wire);
   end End_Character;

   procedure Serve_Converter (Which : Node; Time : Microseconds) is
      Wanted  : Boolean;
      Channel : Devices.AD_Board.Channel_Number;
   begin
      Take_Start (Which, Wanted, Channel);
      if Wanted then
         Nodes_Hardware (Which).Held :=
           Inputs (Which) (URV.Buffers.Channel (Channel));
         Agenda (Converted (Which)) := Time + Conversion_Time;
      end if;
   end Serve_Converter;

   procedure End_Conversion (Which : Node; Time : Microseconds) is
   begin
      Agenda (Converted (Which)) := Never;
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
      Agenda (Clock (Which)) := Time + Tick_Time;

      Serve_Converter (Which, Time);
      Serve_Telemetry (Which, Time, Wire);
   end Tick;

   procedure Start (Lag : Microseconds; Script : Faults.Script) is
   begin
      Nodes_Hardware :=
        (GSC => (others => <>),
         MCS => (Switched_On => Lag, Timer => Lag, others => <>));
      Agenda :=
        (GSC_Clock => 0, MCS_Clock => Lag, others => Never);
      Prepare (Link_Line, Script);
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
         Next := Event'First;
         for Candidate in Event loop
            if Agenda (Candidate) < Agenda (Next) then
               Next := Candidate;
            end if;
         end loop;

         Time := Agenda (Next);
         exit when Time >= Stop;

         case Next is
            when Character_Up   => End_Character (GSC, Time, Wire);
            when Character_Down => End_Character (MCS, Time, Wire);
            when GSC_Converted  => End_Conversion (GSC, Time);
            when MCS_Converted  => End_Conversion (MCS, Time);
            when GSC_Time_Out   => Serve_Telemetry (GSC, Time, Wire);
            when MCS_Time_Out   => Serve_Telemetry (MCS, Time, Wire);
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
