--  SPDX-License-Identifier: Apache-2.0

with Ada.Exceptions; use Ada.Exceptions;

with Host.Bench;
with Host.Complaints;
with Host.Event_Log;
with Host.Ground_Orders;
with Host.Key_Files;
with Host.Loss_Times;
with Host.Names;
with Host.Outputs;        use Host.Outputs;
with Host.Pilot;
with Host.Plant_Messages; use Host.Plant_Messages;
with Host.Recordings;
with Host.Sensor_Scripts;
with Host.Stick_Scripts;
with Host.Surface_Faults;
with Host.Text_Numbers;
with Host.Text_Output;
with Sim.Circuit_Quality;
with Sim.Conditions;
with Sim.Controllers;
with Sim.Engine;
with Sim.Eyes;
with Sim.Faults;
with Sim.Flight_Quality;
with Sim.Flight_Record;
with Sim.JSBSim;
with Sim.Latency;
with Sim.Nodes;
with Sim.Noise;
with Sim.Progress;
with Sim.Signals;
with Sim.Summary;
with Sim.Wall_Clock;
with Sim.Wire_Log;
with URV.Card_Status;
with URV.Buffers;         use URV.Buffers;
with URV.CORE_Layout;
with URV.CORE_Memory;     use URV.CORE_Memory;
with URV.Errors;          use URV.Errors;
with URV.Law_Status;
with URV.PWM_Transform;
with URV.Seal_Blocks;
with URV.Sessions;
with URV.Surfaces;
with URVOS;               use URVOS;
with URVOS.Frames;        use URVOS.Frames;

package body Sim.Flight is

   Standard_Length : constant Microseconds := 60 * Microseconds_Per_Second;

   use type Sim.Conditions.Start_Place;

   --  All files and state of a flight. There is one flight.

   Sticks     : Stick_Scripts.Script;
   Sensors    : Sensor_Scripts.Script;
   Faults     : Sim.Faults.Script;
   Conditions : Sim.Conditions.Script;
   Orders     : Ground_Orders.Script;
   Files      : File_Set;
   Keys       : Key_Files.Key_Ring;

   Console    : Console_Words := Neutral_Console;
   Measured   : Sensor_Words  := Neutral_Sensors;
   Chance     : Noise.Source;
   View_Noise : Noise.Source;
   Truth      : Flight_State;
   Shown      : Shown_State := (others => 0.0);
   Delays     : Latency.Collector;

   --  The end of the ground's frame whose quality is observed when the
   --  aircraft's true state is known; Never if none waits.
   Unobserved : Microseconds := Host.Never;

   package Rows_Aboard is new Recordings.Followers
     (Nodes.Recorder, Nodes.Recorded);

   procedure Load_Inputs (Chosen : Choices);

   procedure Start_Aircraft (Chosen : Choices);

   --  The pilot, the laws and the servos' faults are for URV's own aircraft.
   procedure Refuse_Beside_Airframe (Chosen : Choices);

   --  The console's words change, at Time.
   procedure Move_Console (Words : Console_Words; Time : Microseconds);

   --  The servos have new commands: starts the plant's next frame. Its result
   --  is not needed before Due.
   procedure Step_Plant
     (Chosen    : Choices;
      Time      : Microseconds;
      Frame_End : Microseconds;
      Due       : out Microseconds);

   --  JSBSim has completed a frame.
   procedure Take_Answer;

   --  Observes the quality of the flight up to the end of the ground's frame.
   procedure Observe;

   --  Writes what the recorder aboard has made, and what came down of it.
   procedure Follow_Recorder;

   --  A major frame of the ground has ended. Waits: JSBSim has not answered.
   procedure End_Frame
     (Chosen : Choices; Time : Microseconds; Waits : Boolean);

   --  Flies for that time, or until the user interrupts.
   procedure Fly_Through
     (Chosen : Choices;
      Length : Microseconds;
      Flown  : out Microseconds);

   --  Reports the failed surfaces known to the ground.
   procedure Report_Failed_Surfaces (Further : in out Summary.Result);

   --  Writes events and summary; after the flight, also closes the outputs and
   --  prints the summary. During the flight it skips outputs that cannot be
   --  rewritten.
   procedure Write_Results
     (Chosen  : Choices;
      Flown   : Microseconds;
      Elapsed : Duration;
      Is_Over : Boolean);

   --  The real time of the flight's beginning and of the last write of its
   --  results.
   Began_At : Duration := Wall_Clock.Now;
   Kept_At  : Duration := Began_At;

   --  Writes the buffered record and, each second of real time, events and
   --  summary: they remain if the program is killed.
   procedure Keep_Results (Chosen : Choices; Flown : Microseconds);

   --  True if the pilot is beside the runway.
   function Is_By_Eye (Chosen : Choices) return Boolean is
     (Is_Given (Chosen, Pilot_Option)
      and then Pilot.Is_By_Eye (Value (Chosen, Pilot_Option)));

   --  In whole frames: --seconds; else the length of the pilot's flight or the
   --  sticks; else 60 s.
   function Flight_Length (Chosen : Choices) return Microseconds;

   --  Warns of faults in the file that begin only after the flight's end.
   function Image (Value : Natural) return String is
     (Text_Numbers.Image (Long_Long_Integer (Value)));

   procedure Warn_Of_Faults (Chosen : Choices; Text : String);

   --  Faults that begin after the flight, and those of characters that were
   --  not sent.
   procedure Warn_Of_Late_Faults (Chosen : Choices; Length : Microseconds);
   procedure Warn_Of_Awaited_Characters (Chosen : Choices);

   function Flight_Length (Chosen : Choices) return Microseconds is
      Needed : constant Microseconds :=
        (if Chosen.Length > 0 then Chosen.Length
         elsif Is_Given (Chosen, Pilot_Option)
         then Pilot.Length (Value (Chosen, Pilot_Option))
         else Stick_Scripts.Length (Sticks));
   begin
      return Whole_Frames (if Needed > 0 then Needed else Standard_Length);
   end Flight_Length;

   --  True if the error happens at every start, before the first message.
   function Is_Usual
     (Kind : Error_Kind; History : Logs.History) return Boolean;

   --  True if an output shows the aircraft's true state at the end of each of
   --  the ground's frames.
   function Shows_Truth (Chosen : Choices) return Boolean is
     (Text_Output.Is_Open (Files (Record_Option)) or else Is_By_Eye (Chosen));

   --  The time in the aircraft's frame at which the servos get new commands.
   function PWM_Offset (Chosen : Choices) return Microseconds is
     (Microseconds (Servo_Tick (Chosen.Schedule)) * Tick_Time);

   --  The delay of the aircraft's power up after the ground's.
   function Lag_Of (Chosen : Choices) return Microseconds is
     (Microseconds (Chosen.Phase) * Tick_Time);

   function Is_Usual
     (Kind : Error_Kind; History : Logs.History) return Boolean
   is
      First_Frames : constant := 3;
   begin
      return
        Kind = No_Input
        and then History.Last < First_Frames * Ticks_Per_Major_Frame;
   end Is_Usual;

   --  From new commands for the servos to the next end of the ground's frame,
   --  when a row is written.
   function Steps_To_Row (Chosen : Choices) return Step_Count is
     (Step_Count
        ((Major_Frame
          - (Lag_Of (Chosen) + PWM_Offset (Chosen)) mod Major_Frame)
         / Tick_Time));

   --  Servos are commanded from the aircraft's first frame of tasks on.
   function First_Commands (Chosen : Choices) return Microseconds is
     (Lag_Of (Chosen) + Major_Frame + PWM_Offset (Chosen));

   --  The shortest time from new commands to the next scan: a frame may be a
   --  tick shorter.
   function Time_To_Scan (Chosen : Choices) return Microseconds is
     ((Microseconds (Ticks_To_Scan (Chosen.Schedule))
       - (if Chosen.Lock or else Chosen.Drift < 0 then 1 else 0))
      * Tick_Time);

   function Servo_Faults (Chosen : Choices) return Surface_Faults.List is
     (Sim.Faults.For_Plant (Faults, First_Commands (Chosen)));

   procedure Refuse_Beside_Airframe (Chosen : Choices) is

      procedure Refuse_Option (Option : String; Remedy : String := "");

      procedure Refuse_Option (Option : String; Remedy : String := "") is
      begin
         Complaints.Refuse
           (Option & " and another airframe than lambda do not go together"
            & Remedy);
      end Refuse_Option;
   begin
      if Is_Given (Chosen, Pilot_Option) then
         Refuse_Option ("--pilot");
      elsif Chosen.Laws then
         Refuse_Option ("--laws on", Remedy => ": add --laws off");
      elsif Fault_Lines (Servo_Faults (Chosen)) /= "" then
         Refuse_Option ("--faults with faults of servos");
      end if;
   end Refuse_Beside_Airframe;

   procedure Start_Aircraft (Chosen : Choices) is
      Begins : constant Sim.Conditions.Start_Place :=
        Sim.Conditions.Place
          (Conditions,
           Otherwise =>
             (if Is_By_Eye (Chosen) then Sim.Conditions.On_The_Runway
              else Sim.Conditions.In_The_Air));
      Errors : Sensor_Values;
   begin
      if Is_By_Eye (Chosen) and then Begins = Sim.Conditions.In_The_Air
      then
         Complaints.Refuse
           ("--pilot " & Value (Chosen, Pilot_Option) & " and the condition"
            & " ""start air"" do not go together");
      end if;
      if Sim.Conditions.Has_Other_Airframe (Conditions) then
         Refuse_Beside_Airframe (Chosen);
      end if;
      View_Noise := Noise.Seeded (Chosen.Seed, Noise.The_Eyes);
      Chance     := Noise.Seeded (Chosen.Seed, Noise.The_Sensors);
      Sim.Conditions.Draw_Errors (Conditions, Chance, Errors);
      JSBSim.Start
        (Steps_To_Row (Chosen),
         Sim.Conditions.Introduction (Conditions, Chosen.Seed, Begins)
         & Fault_Lines (Servo_Faults (Chosen)),
         Chosen.Schedule, Errors, Measured, Truth, Shown);
   end Start_Aircraft;

   procedure Warn_Of_Faults (Chosen : Choices; Text : String) is
      Screen : Text_Output.Writer;
   begin
      if not Chosen.Quiet then
         Text_Output.Attach_Screen (Screen, Is_Error => True);
         Text_Output.Put_Line
           (Screen, "urv_sim: warning: --faults: " & Text);
         Text_Output.Close (Screen);
      end if;
   end Warn_Of_Faults;

   procedure Warn_Of_Late_Faults (Chosen : Choices; Length : Microseconds) is
      Late  : constant Natural := Sim.Faults.Number_From (Faults, Length);
      Whole : constant Natural := Sim.Faults.Number_From (Faults, 0);
   begin
      if Late > 0 then
         Warn_Of_Faults
           (Chosen,
            Image (Late) & " of " & Image (Whole)
            & " do not begin before the flight ends, at "
            & Text_Numbers.Image (Long_Long_Integer (Length / 1000))
            & " ms");
      end if;
   end Warn_Of_Late_Faults;

   procedure Warn_Of_Awaited_Characters (Chosen : Choices) is
      Awaited : constant Natural := Engine.Awaited_Characters;
   begin
      if Awaited > 0 then
         Warn_Of_Faults
           (Chosen,
            "the flight ended before " & Image (Awaited)
            & " of the characters to disturb were sent");
      end if;
   end Warn_Of_Awaited_Characters;

   procedure Load_Inputs (Chosen : Choices) is
   begin
      if Is_Given (Chosen, Key_Option) then
         Key_Files.Load (Keys, Value (Chosen, Key_Option));
      end if;
      if Is_Given (Chosen, Sticks_Option) then
         Stick_Scripts.Load (Sticks, Value (Chosen, Sticks_Option));
      end if;
      if Is_Given (Chosen, Sensors_Option) then
         Sensor_Scripts.Load
           (Sensors, Value (Chosen, Sensors_Option));
      end if;
      if Is_Given (Chosen, Faults_Option) then
         Sim.Faults.Load (Faults, Value (Chosen, Faults_Option));
      end if;
      if Is_Given (Chosen, Conditions_Option) then
         Sim.Conditions.Load
           (Conditions, Value (Chosen, Conditions_Option),
            Has_Aircraft => Chosen.Plant = JSBSim_Plant);
      end if;
      if Is_Given (Chosen, Orders_Option) then
         Ground_Orders.Load
           (Orders, Value (Chosen, Orders_Option));
      end if;
   end Load_Inputs;

   procedure Move_Console (Words : Console_Words; Time : Microseconds) is
      Commands : Uplink_Buffer := (others => URV.Buffers.No_Error);
   begin
      if Words /= Console then
         Console := Words;
         Engine.Set_Console (Words);

         for Item in Command_Item loop
            Commands (Item) := Words (Item);
         end loop;
         Latency.Console_Changed
           (Delays, Time, URV.PWM_Transform.Transform (Commands));
      end if;
   end Move_Console;

   procedure Step_Plant
     (Chosen    : Choices;
      Time      : Microseconds;
      Frame_End : Microseconds;
      Due       : out Microseconds)
   is
      Servos : constant PWM_Buffer := Nodes.Servos;
      Moved  : Sensor_Words := Measured;
   begin
      Latency.PWM_Written (Delays, Time, Servos);

      case Chosen.Plant is
         when Bench_Plant =>
            Host.Bench.Step (Servos, Moved);
            for Item in Sensor_Item loop
               if not Sensor_Scripts.Is_Given (Sensors, Item) then
                  Measured (Item) := Moved (Item);
               end if;
            end loop;
            Engine.Set_Sensors (Measured);
            Due := Host.Never;

         when JSBSim_Plant =>
            Sim.JSBSim.Begin_Step (Servos);
            Due := Time + Time_To_Scan (Chosen);
            if Shows_Truth (Chosen) then
               Due := Microseconds'Min (Due, Frame_End);
            end if;
      end case;
   end Step_Plant;

   procedure Take_Answer is
      Errors : Sensor_Values;
   begin
      Sim.Conditions.Draw_Errors (Conditions, Chance, Errors);
      Sim.JSBSim.End_Step (Errors, Measured, Truth, Shown);
      Engine.Set_Sensors (Measured);
      Observe;
   end Take_Answer;

   procedure Observe is
   begin
      if Unobserved < Host.Never then
         Flight_Quality.Observe (Unobserved, Truth, Pilot.Present_Targets);
         Unobserved := Host.Never;
      end if;
   end Observe;

   procedure Follow_Recorder is
      Block : Downlink_Buffer;
      Found : Boolean;
   begin
      if Text_Output.Is_Open (Files (Recording_Option)) then
         Rows_Aboard.Put_New_Rows (Files (Recording_Option));
      end if;
      Nodes.Take_Recorder_Block (Block, Found);
      if Found and then Text_Output.Is_Open (Files (Fetched_Option)) then
         Recordings.Put_Block (Files (Fetched_Option), Block);
      end if;
   end Follow_Recorder;

   procedure End_Frame
     (Chosen : Choices; Time : Microseconds; Waits : Boolean)
   is
      Frame  : constant URVOS.Count := URVOS.Count (Time / Major_Frame - 1);
      Writer : Text_Output.Writer renames Files (Record_Option);
      Words  : Console_Words;
      Seen   : Pilot.View;
   begin
      if Text_Output.Is_Open (Writer) then
         Flight_Record.Write_Row
           (Writer,
            (Frame        => Frame,
             Time         => Time,
             Console      => Console,
             GSC_Uplink   => Nodes.CORE (Ground).Uplink,
             MCS_Uplink   => Nodes.CORE (Aircraft).Uplink,
             PWM          => Nodes.Servos,
             MCS_Downlink => Nodes.CORE (Aircraft).Downlink,
             GSC_Downlink => Nodes.CORE (Ground).Downlink,
             Link         => Engine.Link,
             MCS_Frame    => Nodes.CORE (Aircraft).Frame,
             GSC_Frame    => Nodes.CORE (Ground).Frame,
             Has_Truth    => Chosen.Plant = JSBSim_Plant,
             Truth        => Shown,
             Has_Laws     => Chosen.Laws,
             Laws         => URV.Law_Status.Report_Of
                               (Nodes.Laws, Nodes.Failed_Surfaces,
                                Nodes.Configured),
             Reported_Laws    => URV.Law_Status.From_Row
                               (Nodes.CORE (Ground).Aircraft_Log
                                  (URV.Law_Status.Row_Number)),
             Has_Orders   => Is_Given (Chosen, Orders_Option),
             Has_Cards    => Ground_Orders.Has_Cards (Orders),
             Cards        => Nodes.Cards,
             Cards_Told   => URV.Card_Status.From_Row
                               (Nodes.CORE (Ground).Aircraft_Log
                                  (URV.Card_Status.Row_Number))));
      end if;

      if Is_Given (Chosen, Pilot_Option) then
         if Is_By_Eye (Chosen) and then Frame mod Eyes.Frames_Between = 0 then
            Eyes.Look (Shown, View_Noise, Seen);
            Pilot.See (Seen);
         end if;
         Pilot.Move
           (Time,
            Nodes.CORE (Ground).Downlink,
            Words);
         Move_Console (Words, Time);
         if Is_By_Eye (Chosen) then
            Circuit_Quality.Observe (Time, Truth);
         elsif Chosen.Plant = JSBSim_Plant then
            Unobserved := Time;
            if not Waits then
               Observe;
            end if;
         end if;
      end if;

      Follow_Recorder;
      Progress.Show (Time);
   end End_Frame;

   procedure Fly_Through
     (Chosen : Choices;
      Length : Microseconds;
      Flown  : out Microseconds)
   is
      Began     : constant Duration := Wall_Clock.Now;
      Frame_End : Microseconds := Major_Frame;

      --  The minor frame in which the servos get new commands.
      Servos_At : constant Minor_Frame :=
        Minor_Frame (Servo_Tick (Chosen.Schedule));
      Next_PWM  : Microseconds :=
        Controllers.Next_Time_Of (Aircraft, Servos_At);
      Due       : Microseconds := Host.Never;
      Next      : Microseconds;
      Row       : Console_Words;
      Scripted  : Sensor_Words;
      Order     : Uplink_Buffer;
   begin
      loop
         Next := Microseconds'Min
           (Microseconds'Min
              (Due, Microseconds'Min (Frame_End, Next_PWM + 1)),
            Microseconds'Min
              (Microseconds'Min (Stick_Scripts.Next_Time (Sticks),
                                 Sensor_Scripts.Next_Time (Sensors)),
               Ground_Orders.Next_Time (Orders)));
         Engine.Run (Next, Files (Wire_Option));

         if Next = Due then
            Take_Answer;
            Due := Host.Never;
         end if;

         if Next = Next_PWM + 1 then
            Step_Plant (Chosen, Next_PWM, Frame_End, Due);
            Next_PWM := Controllers.Next_Time_Of (Aircraft, Servos_At);
         end if;

         if Next = Frame_End then
            End_Frame (Chosen, Frame_End, Waits => Due < Host.Never);
            if Frame_End mod Text_Output.Flush_Interval = 0
              or else Frame_End = Major_Frame
            then
               Keep_Results (Chosen, Frame_End);
            end if;
            exit when Frame_End = Length or else Signals.Interrupted
              or else Outputs.Is_Unread (Files, Chosen);
            if Chosen.Pace = Realtime then
               Wall_Clock.Wait
                 (Until_Time => Began + In_Seconds (Frame_End));
            end if;
            Frame_End := Frame_End + Major_Frame;
         end if;

         --  A row that begins where a frame ends is not part of it.
         if Next = Stick_Scripts.Next_Time (Sticks) then
            Stick_Scripts.Advance (Sticks, Row);
            Move_Console (Row, Next);
         end if;

         if Next = Ground_Orders.Next_Time (Orders) then
            Ground_Orders.Advance (Orders, Order);
            Nodes.Order (Order);
         end if;

         if Next = Sensor_Scripts.Next_Time (Sensors) then
            Sensor_Scripts.Advance (Sensors, Scripted);
            for Item in Sensor_Item loop
               if Sensor_Scripts.Is_Given (Sensors, Item) then
                  Measured (Item) := Scripted (Item);
               end if;
            end loop;
            Engine.Set_Sensors (Measured);
         end if;
      end loop;
      if Due < Host.Never then
         Take_Answer;
      end if;
      Flown := Frame_End;

   exception
      when Error : Not_Finite =>
         raise Not_Finite with
           Exception_Message (Error) & " at "
           & Text_Numbers.Image (Long_Long_Integer (Frame_End / 1000))
           & " ms";
   end Fly_Through;

   procedure Report_Failed_Surfaces (Further : in out Summary.Result) is
      Bits : Word :=
        URV.Law_Status.From_Row
          (Nodes.CORE (Ground).Aircraft_Log (URV.Law_Status.Row_Number))
          (URV.Law_Status.Failed);
   begin
      for Item in URV.Surfaces.Surface loop
         if Bits mod 2 = 1 then
            Summary.Add_Failed_Surface
              (Further, Names.Name (URV.Surfaces.Sensor_Of (Item)));
         end if;
         Bits := Bits / 2;
      end loop;
      if Bits mod 2 = 1 then
         Summary.Add_Failed_Surface
           (Further, Names.Name (PWM_Item'(Throttle)));
      end if;
   end Report_Failed_Surfaces;

   function Time_On_Ground (Now : Clock_Tick) return Microseconds is
     (Controllers.Time_Of (Ground, Now));

   function Time_Aboard (Now : Clock_Tick) return Microseconds is
     (Controllers.Time_Of (Aircraft, Now));

   procedure Write_Ground_Log is new Event_Log.Write (Time_On_Ground);
   procedure Write_Aircraft_Log is new Event_Log.Write (Time_Aboard);

   procedure Write_Results
     (Chosen  : Choices;
      Flown   : Microseconds;
      Elapsed : Duration;
      Is_Over : Boolean)
   is
      Figures : constant Summary.Figures :=
        (Flown    => Flown,
         Frames   => URVOS.Count (Flown / Major_Frame),
         Elapsed  => Elapsed,
         Link     => Engine.Link,
         Overruns => Nodes.Overruns (Ground) + Nodes.Overruns (Aircraft),
         Latency  => Latency.Result (Delays),
         Has_Lock => Chosen.Lock,
         Lock     => Nodes.Lock,
         In_Step_Since =>
           Controllers.Time_Of (Aircraft, Nodes.Lock.Since),
         Is_Unfinished => not Is_Over);
      Further : Summary.Result;
      Screen  : Text_Output.Writer;

      Is_Unread : Boolean;
   begin
      if Text_Output.Is_Open (Files (Events_Option))
        and then Text_Output.Can_Restart (Files (Events_Option))
      then
         Text_Output.Restart (Files (Events_Option));
      end if;
      for Node in Host.Node loop
         declare
            Log  : constant Error_Log    := Nodes.Errors (Node);
            CORE : constant Status_Words := Nodes.CORE (Node).Status;
            Name : constant String       := Names.Name (Node);
         begin
            for Kind in Error_Kind loop
               if Logs.History_Of (Log, Kind).Occurrences > 0 then
                  Summary.Add_Event
                    (Further,
                     Name & "." & Names.Name (Kind),
                     Logs.History_Of (Log, Kind).Occurrences,
                     Is_Usual (Kind, Logs.History_Of (Log, Kind)));
               end if;
            end loop;

            for Item in Status_Item loop
               Summary.Add_Status
                 (Further, Node, Names.Name (Item), CORE (Item));
            end loop;

            --  The ground's knowledge of both (SAF-7).
            for Kind in Error_Kind loop
               declare
                  CORE : constant Memory := Nodes.CORE (Ground);
                  Which  : constant Log_Row_Number :=
                    URV.CORE_Layout.Row_Of (Kind);
                  Row    : constant Log_Row :=
                    (case Node is
                        when Ground   => CORE.Log (Which),
                        when Aircraft => CORE.Aircraft_Log (Which));
               begin
                  if Row /= No_Errors then
                     Summary.Add_Known_Error
                       (Further, Node, Names.Name (Kind),
                        URVOS.Count (Row (Occurrences_High)) * 2 ** 16
                        + URVOS.Count (Row (Occurrences_Low)));
                  end if;
               end;
            end loop;

            if Text_Output.Is_Open (Files (Events_Option))
              and then
                (Is_Over or else Text_Output.Can_Restart
                                   (Files (Events_Option)))
            then
               case Node is
                  when Ground   =>
                     Write_Ground_Log (Files (Events_Option), Name, Log);
                  when Aircraft =>
                     Write_Aircraft_Log (Files (Events_Option), Name, Log);
               end case;
            end if;
         end;
      end loop;

      if Chosen.Laws then
         Report_Failed_Surfaces (Further);
      end if;

      if Is_By_Eye (Chosen) then
         Circuit_Quality.Report (Further);
      elsif Chosen.Plant = JSBSim_Plant
        and then Is_Given (Chosen, Pilot_Option)
      then
         Flight_Quality.Report (Further);
      end if;

      --  A loss is known only after the write.
      if Is_Over then
         Outputs.Flush (Files, Except => Summary_Option);
      end if;
      for Output in Output_Option loop
         if Text_Output.Is_Lost (Files (Output)) then
            Summary.Add_Lost_Output (Further, Options.Name (Output));
         end if;
      end loop;

      if Text_Output.Is_Open (Files (Summary_Option))
        and then
          (Is_Over or else Text_Output.Can_Restart (Files (Summary_Option)))
      then
         if Text_Output.Can_Restart (Files (Summary_Option)) then
            Text_Output.Restart (Files (Summary_Option));
         end if;
         Summary.Write (Files (Summary_Option), Figures, Further);
      end if;

      if not Is_Over then
         for Output in Output_Option loop
            if Text_Output.Is_Open (Files (Output))
              and then Text_Output.Can_Restart (Files (Output))
            then
               if Output in Summary_Option | Events_Option then
                  Text_Output.End_Version (Files (Output));
               else
                  Text_Output.Flush (Files (Output));
               end if;
            end if;
         end loop;
         return;
      end if;
      Is_Unread := Outputs.Is_Unread (Files, Chosen);
      Outputs.Close (Files);

      if not Chosen.Quiet and then not Is_Unread then
         Text_Output.Attach_Screen
           (Screen,
            Is_Error => Use_Standard_Output (Chosen));
         Summary.Print (Screen, Figures, Further);
         Text_Output.Close (Screen);
      end if;
   end Write_Results;

   procedure Keep_Results (Chosen : Choices; Flown : Microseconds) is
      Now : constant Duration := Wall_Clock.Now;
   begin
      --  In a second a fast flight's record grows by more than a killed
      --  program may lose.
      if Text_Output.Is_Open (Files (Record_Option))
        and then Text_Output.Can_Restart (Files (Record_Option))
      then
         Text_Output.Flush (Files (Record_Option));
      end if;
      if Now - Kept_At > 1.0 then
         Kept_At := Now;
         Write_Results (Chosen, Flown, Now - Began_At, Is_Over => False);
      end if;
   end Keep_Results;

   procedure Fly (Chosen : Choices; Flown : out Microseconds) is
      Length  : Microseconds;

      Began   : Duration;
      Elapsed : Duration;

      procedure Seal_Nodes (Given : URV.Sessions.Key_List);

      procedure Seal_Nodes (Given : URV.Sessions.Key_List) is
      begin
         Nodes.Seal_Link
           (Chosen.Format, Given, URV.Seal_Blocks.Nonce (Chosen.Seed));
      end Seal_Nodes;

      procedure Seal_Link is new Key_Files.Hand_Over (Seal_Nodes);
   begin
      Load_Inputs (Chosen);
      Length := Flight_Length (Chosen);
      Warn_Of_Late_Faults (Chosen, Length);

      Nodes.Set_Schedule (Chosen.Schedule);
      Nodes.Set_Lock (Chosen.Lock);
      Nodes.Set_Line (Chosen.Line_Delay);
      Nodes.Set_Recorder (Recordings.Length_Of (Chosen.Recorder));
      Nodes.Set_Laws (Chosen.Laws, Loss_Times.Frames_Of (Chosen.Loss));
      Seal_Link (Keys);
      Engine.Start
        (Lag        => Lag_Of (Chosen),
         Script     => Faults,
         Seed       => Chosen.Seed,
         Processors => Chosen.Processors,
         Drift      => Chosen.Drift,
         Line       => Chosen.Line_Delay);
      if Chosen.Plant = JSBSim_Plant then
         Start_Aircraft (Chosen);
         Engine.Set_Sensors (Measured);
      else
         Bench.Start
           (Servo_Faults (Chosen), Chosen.Schedule,
            Sim.Conditions.Bench_Servos (Conditions));
      end if;
      if Is_Given (Chosen, Pilot_Option) then
         Pilot.Start (Value (Chosen, Pilot_Option));
         Flight_Quality.Start;
         Circuit_Quality.Start;
      end if;

      --  A pipe as an output waits for its reader: until then a signal ends
      --  the program at once.
      Outputs.Open (Files, Chosen);
      Signals.Watch;
      if Text_Output.Is_Open (Files (Record_Option)) then
         Flight_Record.Write_Header
           (Files (Record_Option),
            Has_Truth  => Chosen.Plant = JSBSim_Plant,
            Has_Laws   => Chosen.Laws,
            Has_Orders => Is_Given (Chosen, Orders_Option),
            Has_Cards  => Ground_Orders.Has_Cards (Orders));
      end if;
      if Text_Output.Is_Open (Files (Wire_Option)) then
         Wire_Log.Write_Header (Files (Wire_Option));
      end if;

      Progress.Start
        (Length,
         Wanted => not Chosen.Quiet,
         Beside => Use_Standard_Output (Chosen));
      Began := Wall_Clock.Now;
      Began_At := Began;
      Kept_At := Began - 2.0;
      Fly_Through (Chosen, Length, Flown);
      Elapsed := Wall_Clock.Now - Began;
      Progress.Stop;
      JSBSim.Stop;

      Write_Results (Chosen, Flown, Elapsed, Is_Over => True);
      Warn_Of_Awaited_Characters (Chosen);

   exception
      when others =>
         Progress.Stop;
         JSBSim.Stop;
         Outputs.Close (Files);
         raise;
   end Fly;

end Sim.Flight;
