--  SPDX-License-Identifier: Apache-2.0

with Host.Loss_Times;
with Host.Option_Values; use Host.Option_Values;
with Host.Pilot;
with Host.Text_Numbers;

package body Host.Option_Help is

   First_Column : constant := 20;
   Last_Column  : constant := 77;

   function Image (Value : Integer) return String is
     (Text_Numbers.Image (Long_Long_Integer (Value)));

   function Meaning (Which : Option; Caller : Program) return String is
     (case Which is
         when Link_Option =>
            "to the other node: udp:HOST:PORT:PEER_HOST:PEER_PORT or"
            & " serial:DEVICE",
         when Seconds_Option =>
           (if Caller = URV_Sim
            then "length of the flight (60, or that of the sticks or the"
                 & " pilot)"
            else "ends the run; 0.5 is half a second"),
         when Plant_Option =>
            "bench, or jsbsim: an aircraft in flight (bench)",
         when Sticks_Option =>
            "the pilot's sticks, CSV (neutral)",
         when Pilot_Option =>
           (if Caller = URV_Sim
            then "the simulated pilot flies: " & Pilot.Names
                 & " (none); needs --plant jsbsim"
            else "the simulated pilot flies while no console does: "
                 & Pilot.Names (By_Eye => False) & " (none)"),
         when Sensors_Option =>
            "the bench's sensors, CSV (surfaces follow the servos, the rest"
            & " is neutral)",
         when Faults_Option =>
            "the script of faults (none)",
         when Conditions_Option =>
            "wind, ballast, servos, errors of sensors (none); the bench has"
            & " servos only",
         when Orders_Option =>
            "the ground's orders besides the sticks (none)",
         when Seed_Option =>
            "random seed (1)",
         when Phase_Option =>
           (if Caller = URV_Sim
            then "lag of the aircraft's frame, 0 to" & Phase_Ticks'Last'Image
                 & " (" & Image (Usual_Phase) & ")"
            else "switches the node on TICKS times "
                 & Image
                     (Microseconds_Per_Tick / Microseconds_Per_Millisecond)
                 & " ms after a whole " & Image (Frame_Milliseconds)
                 & " ms of the machine's clock (at once)"),
         when Drift_Option =>
            "the aircraft's ticks are longer by PPM millionths, -200 to 200"
            & " (0)",
         when Lock_Option =>
            "brings the aircraft's frames in step with the ground's",
         when Line_Delay_Option =>
            (if Caller = URV_Sim
             then "one-way delay of the line, which both boards allow for, "
             else "one-way delay of a line slower than a wire, the same for"
                  & " both nodes, ")
            & Line_Delay_Range & " (0)",
         when Schedule_Option =>
            "task schedule: report or fast (report)",
         when Processors_Option =>
            "of a node, " & Processor_Range & " (1)",
         when Laws_Option =>
            "the aircraft's control laws, on or off (on with jsbsim, off with"
            & " the bench)",
         when Orbit_After_Option =>
            "with the laws: seconds without uplink before the orbit, "
            & Loss_Times.Orbit_Range & " (5)",
         when Terminate_After_Option =>
            "with the laws: seconds without uplink before the flight is"
            & " terminated, " & Loss_Times.Finish_Range & " (120)",
         when Format_Option =>
            "message format, 1 or 2, which is sealed (1)",
         when Key_Option =>
            "the keys, for format 2",
         when Recorder_Option =>
            "seconds of flight that the recorder aboard holds, up to "
            & Image (Integer (Longest_Recording / Microseconds_Per_Second))
            & " (as many)",
         when Console_Option =>
            "the sticks from a console's packets; HOST is this machine's"
            & " loopback",
         when Packets_Option =>
            "version of the published packets, 1 to 3: 2 has the whole logs,"
            & " 3 also the downlink's frame (1)",
         when Publish_Option =>
            "sends CORE's contents there each frame; up to"
            & Integer'Image (Most_Places) & " times",
         when Record_Option =>
            "a row for each major frame, CSV",
         when Recording_Option =>
            "the rows of the recorder aboard, as they are made",
         when Fetched_Option =>
            "the blocks of the recorder that come down",
         when Summary_Option =>
            "result, JSON",
         when Wire_Option =>
            "every byte on the serial link, CSV",
         when Events_Option =>
            "error log, JSON lines: node, kind, count, first_frame,"
            & " last_frame, first_ms, last_ms, last_detail",
         when Pace_Option =>
            "max or realtime (max)",
         when Quiet_Option =>
           (if Caller = URV_Sim then "no progress, no summary"
            else "no summary, no lines about the other node"));

   --  Prints the words in lines that begin at First_Column after the title.
   procedure Put_Paragraph
     (To : in out Text_Output.Writer; Title : String; Words : String);

   procedure Put_Paragraph
     (To : in out Text_Output.Writer; Title : String; Words : String)
   is
      Column : Positive := Title'Length + 1;
      Start  : Positive := Words'First;
      Stop   : Positive;

      procedure New_Paragraph_Line;

      procedure New_Paragraph_Line is
      begin
         Text_Output.New_Line (To);
         Column := 1;
      end New_Paragraph_Line;

   begin
      Text_Output.Put (To, Title);
      if Column > First_Column then
         New_Paragraph_Line;
      end if;
      while Start <= Words'Last loop
         Stop := Start;
         while Stop < Words'Last and then Words (Stop + 1) /= ' ' loop
            Stop := Stop + 1;
         end loop;
         if Column + Stop - Start + 1 > Last_Column then
            New_Paragraph_Line;
         end if;
         while Column < First_Column loop
            Text_Output.Put (To, ' ');
            Column := Column + 1;
         end loop;
         Text_Output.Put (To, ' ' & Words (Start .. Stop));
         Column := Column + Stop - Start + 2;
         Start  := Stop + 2;
      end loop;
      Text_Output.New_Line (To);
   end Put_Paragraph;

   procedure Print (To : in out Text_Output.Writer; Caller : Program) is
   begin
      for Which in Option loop
         if Has (Caller, Which) then
            Put_Paragraph
              (To, "  " & Name (Which) & ' ' & Value_Name (Which),
               Meaning (Which, Caller));
         end if;
      end loop;
   end Print;

end Host.Option_Help;
