--  SPDX-License-Identifier: Apache-2.0

with Ada.Containers.Vectors;

with Devices.AD_Board;
with Sim.Agenda;    use Sim.Agenda;
with Sim.Console_Faults;
with Sim.Windows;   use Sim.Windows;
with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;

package body Sim.Controllers is

   Conversion_Time : constant Microseconds :=
     Devices.AD_Board.Microseconds_Per_Conversion;

   Converted : constant array (Node) of Event :=
     (Ground => GSC_Converted, Aircraft => MCS_Converted);
   Clock     : constant array (Node) of Event :=
     (Ground => GSC_Clock, Aircraft => MCS_Clock);
   Started   : constant array (Node) of Event :=
     (Ground => GSC_Started, Aircraft => MCS_Started);

   --  The difference between the ticks of a node's oscillator and those of its
   --  clock, valid from one tick of the clock on. Frames of 9 or 11 ticks
   --  change it.
   type Correction is record
      From  : Clock_Tick;
      Ahead : Microseconds'Base;
   end record;
   package Correction_Vectors is new Ada.Containers.Vectors
     (Positive, Correction);

   type Controller is record
      Is_On       : Boolean         := False;

      --  The number of the clock's next tick, and the minor frame it shows.
      Ticks       : Microseconds    := 0;
      Clock       : Frame_Clock;
      Corrections : Correction_Vectors.Vector;

      --  It is down until the time of its start is over.
      Is_Starting : Boolean         := False;

      --  It is halted until its next start.
      Is_Halted   : Boolean         := False;
      Condition   : Start_Condition := Cold_Start;

      --  The value held by the A/D board while it converts.
      Held        : Word := 0;

      --  The stalls of the A/D board.
      Stalls      : Windows.List;
   end record;

   Controllers : array (Node) of Controller;

   --  The aircraft's processors.
   Number_Of_Processors : Processor_Count := 1;

   --  The first tick of each clock, and the additional length of its ticks in
   --  millionths.
   First_Tick : array (Node) of Microseconds := (others => 0);
   Longer     : array (Node) of Drift_Number := (others => 0);

   --  The time of the clock's tick with this number, from 0 on.
   function Time_Of_Tick
     (Which : Node; Ticks : Microseconds) return Microseconds
   is
     (First_Tick (Which) + Ticks * Tick_Time
      + Ticks * (Tick_Time / 1_000) * Microseconds'Base (Longer (Which))
        / 1_000);

   --  The words on each converter's channels.
   Inputs : array (Node) of Channel_Words :=
     (others => (others => Neutral_Value));

   --  Keeps a new difference between the oscillator and the node's clock.
   procedure Note_Correction (Item : in out Controller);

   --  Phases one to three of a start, at its end.
   procedure Start (Which : Node; Time : Microseconds);

   --  True if it takes interrupts.
   function Is_Up (Item : Controller) return Boolean;

   --  An exception that the node's program has not handled (KRN-6).
   procedure Answer_Exception
     (Which  : Node;
      Time   : Microseconds;
      Raised : Boolean);

   --  Begins the conversion that the controller has requested, if any. From
   --  now on the board holds the channel's value.
   procedure Serve_Converter (Which : Node; Time : Microseconds)
   with Inline_Always;

   --  End_Conversion, one instance for each node.
   procedure Convert
     (Which      : Node;
      Time       : in out Microseconds;
      Until_Time : Microseconds;
      Have_Run   : out Boolean)
   with Inline_Always;

   procedure Prepare
     (Lag        : Microseconds;
      Drift      : Drift_Number;
      Script     : Faults.Script;
      Processors : Processor_Count) is
   begin
      Controllers := (others => (others => <>));
      Number_Of_Processors := Processors;
      First_Tick := (Ground => 0, Aircraft => Lag);
      Longer := (Ground => 0, Aircraft => Drift);
      Schedule (GSC_Clock, 0);
      Schedule (MCS_Clock, Lag);

      Console_Faults.Prepare (Script);
      for Which in Node loop
         Controllers (Which).Stalls :=
           Faults.Stalls (Script, Which, Faults.ADC);
      end loop;
   end Prepare;

   function Next_Time_Of
     (Which : Node;
      Minor : Minor_Frame) return Microseconds
   is
      Item    : Controller renames Controllers (Which);
      Shown   : constant Minor_Frame := Minor_Frame_Of (Item.Clock.Now);
      Request : Frame_Request;

      --  Ticks until the next frame begins.
      Left  : Microseconds;
   begin
      if not Item.Is_On then
         return Time_Of_Tick
           (Which, Ticks_Per_Major_Frame + Microseconds (Minor));
      elsif Shown < Minor and then Minor < Minor_Frame'Last then
         return Time_Of_Tick
           (Which, Item.Ticks - 1 + Microseconds (Minor - Shown));
      end if;
      Look_At_Frame (Which, 0, Request);
      Left := Ticks_Per_Major_Frame - Microseconds (Shown);
      if not Item.Clock.Held then
         Left := Left
           + Microseconds'Base (Length_Of (Item.Clock.Now, Request))
           - Microseconds'Base (Usual_Length);
      end if;
      return Time_Of_Tick
        (Which,
         Item.Ticks - 1 + Microseconds'Max (Left, 1) + Microseconds (Minor));
   end Next_Time_Of;

   function Time_Of (Which : Node; Now : Clock_Tick) return Microseconds is
      Ahead : Microseconds'Base := 0;
   begin
      for Each of reverse Controllers (Which).Corrections loop
         Ahead := Each.Ahead;
         exit when Each.From <= Now;
         Ahead := 0;
      end loop;
      return Time_Of_Tick (Which, Microseconds (Now) + Ahead);
   end Time_Of;

   function Is_On (Which : Node) return Boolean is
     (Controllers (Which).Is_On);

   procedure Set_Input
     (Which : Node;
      Where : URV.Buffers.Channel;
      Value : Word) is
   begin
      Inputs (Which) (Where) := Value;
   end Set_Input;

   --  True if it takes interrupts.
   function Is_Up (Item : Controller) return Boolean is
     (not Item.Is_Starting and then not Item.Is_Halted);

   procedure Halt (Which : Node) is
      Item : Controller renames Controllers (Which);
   begin
      Item.Is_Halted := Item.Is_On;
      if Item.Is_Halted and then Item.Is_Starting then
         Item.Is_Starting := False;
         Cancel (Started (Which));
      end if;
   end Halt;

   procedure Answer_Exception
     (Which  : Node;
      Time   : Microseconds;
      Raised : Boolean) is
   begin
      if Raised then
         Begin_Start (Which, Time, Processor_Restart);
      end if;
   end Answer_Exception;

   procedure Serve_Converter (Which : Node; Time : Microseconds) is
      use type Devices.AD_Board.Channel_Number;

      Wanted  : Boolean;
      Channel : Devices.AD_Board.Channel_Number;
   begin
      Take_Start (Which, Wanted, Channel);
      if Which = Ground and then Wanted and then Console_Faults.Are_There then
         if Channel = 0 then
            Console_Faults.Begin_Scan (Time, Inputs (Ground));
         end if;
         if not Console_Faults.Brings_Scan then
            return;
         elsif not Console_Faults.Is_Live then
            Controllers (Ground).Held :=
              Console_Faults.Words (URV.Buffers.Channel (Channel));
            Schedule (Converted (Ground), Time + Conversion_Time);
            return;
         end if;
      end if;
      if Wanted then
         Controllers (Which).Held :=
           Inputs (Which) (URV.Buffers.Channel (Channel));
         if Which = Ground then
            Console_Faults.Keep
              (URV.Buffers.Channel (Channel), Controllers (Ground).Held);
         end if;
         Schedule (Converted (Which), Time + Conversion_Time);
      end if;
   end Serve_Converter;

   procedure Convert
     (Which      : Node;
      Time       : in out Microseconds;
      Until_Time : Microseconds;
      Have_Run   : out Boolean)
   is
      Item   : Controller renames Controllers (Which);
      Raised : Boolean;
   begin
      Have_Run := False;
      loop
         while Next (Item.Stalls).Stop <= Time loop
            Skip (Item.Stalls);
         end loop;

         --  A stalled board converts again when the stall ends.
         if Next (Item.Stalls).First <= Time then
            Schedule
              (Converted (Which), Next (Item.Stalls).Stop + Conversion_Time);
            return;
         end if;

         Cancel (Converted (Which));
         Finish_Conversion
           (Which, Item.Held, Is_Up (Item), Raised);
         Serve_Converter (Which, Time);
         Answer_Exception (Which, Time, Raised);

         --  After a scan, or outside of one.
         if not Is_Due (Converted (Which)) and then Is_Up (Item) then
            Look_Again (Which, Raised);
            Serve_Converter (Which, Time);
            Answer_Exception (Which, Time, Raised);
            Have_Run := True;
            return;
         end if;

         exit when Raised or else Time + Conversion_Time >= Until_Time;
         Time := Time + Conversion_Time;
      end loop;
   end Convert;

   procedure End_Conversion
     (Which      : Node;
      Time       : in out Microseconds;
      Until_Time : Microseconds;
      Have_Run   : out Boolean) is
   begin
      case Which is
         when Ground   => Convert (Ground, Time, Until_Time, Have_Run);
         when Aircraft => Convert (Aircraft, Time, Until_Time, Have_Run);
      end case;
   end End_Conversion;

   procedure Note_Correction (Item : in out Controller) is
      Ahead : constant Microseconds'Base :=
        Item.Ticks - 1 - Microseconds (Item.Clock.Now);
   begin
      if Ahead /=
        (if Item.Corrections.Is_Empty then 0
         else Item.Corrections.Last_Element.Ahead)
      then
         --  No task runs in the second tick of the last minor frame.
         Item.Corrections.Append
           (Correction'
              (From  => Item.Clock.Now + (if Item.Clock.Held then 1 else 0),
               Ahead => Ahead));
      end if;
   end Note_Correction;

   procedure Tick (Which : Node; Time : Microseconds) is
      Item    : Controller renames Controllers (Which);
      Request : Frame_Request;
      Raised  : Boolean := False;
   begin
      Item.Ticks := Item.Ticks + 1;
      Schedule (Clock (Which), Time_Of_Tick (Which, Item.Ticks));
      if not Item.Is_On then
         Item.Is_On := True;
         Item.Is_Starting := True;
         Start (Which, Time);
      else
         Look_At_Frame (Which, 1, Request);
         Item.Clock := Ticked (Item.Clock, Request);
         Note_Correction (Item);
         if Which = Aircraft then
            Tick_Servos;
         end if;
         if Is_Up (Item) and then not Item.Clock.Held then
            Clock_Interrupt (Which, Item.Clock.Now, Raised);
            Serve_Converter (Which, Time);
            Answer_Exception (Which, Time, Raised);
         end if;
      end if;
   end Tick;

   procedure Begin_Start
     (Which     : Node;
      Time      : Microseconds;
      Condition : Start_Condition)
   is
      Item : Controller renames Controllers (Which);
   begin
      --  Without phase two of the cold start there is nothing to keep.
      if not (Item.Is_Starting and then Item.Condition = Cold_Start) then
         Item.Condition := Condition;
      end if;
      Item.Is_Starting := True;
      Item.Is_Halted := False;
      Schedule (Started (Which), Time + Start_Time);
      if Condition /= Processor_Restart then
         Cancel (Converted (Which));
      end if;
   end Begin_Start;

   procedure Start (Which : Node; Time : Microseconds) is
      Item   : Controller renames Controllers (Which);
      Raised : Boolean;
   begin
      Nodes.Start
        (Which, Item.Condition, Item.Clock.Now, Number_Of_Processors, Raised);

      --  The start has reset the A/D board: the only conversion under way is
      --  one that it may have requested.
      Cancel (Converted (Which));
      Serve_Converter (Which, Time);
      if not Raised then
         Item.Is_Starting := False;
      end if;
      Answer_Exception (Which, Time, Raised);
   end Start;

   procedure End_Start (Which : Node; Time : Microseconds) is
   begin
      Cancel (Started (Which));
      Start (Which, Time);
   end End_Start;

end Sim.Controllers;
