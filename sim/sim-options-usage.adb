--  SPDX-License-Identifier: Apache-2.0

with Host.Pilot;
with Host.Schedules;
with Host.Text_Numbers;
with Sim.Conditions;
with Sim.Faults;
with Sim.Ground_Orders;

package body Sim.Options.Usage is

   procedure Print
     (To    : in out Text_Output.Writer;
      Topic : Help_Topic)
   is
      procedure Put (Line : String);

      procedure Put_Commands;
      procedure Put_Fly;
      procedure Put_Items;
      procedure Put_Numbers;

      procedure Put (Line : String) is
      begin
         Text_Output.Put_Line (To, Line);
      end Put;

      procedure Put_Commands is
      begin
         Put ("urv_sim: both nodes, the link between them and the aircraft,");
         Put ("in virtual time");
         Put ("");
         Put ("  urv_sim fly [options]   a flight, from files and to files");
         Put ("  urv_sim items           the table of items, as CSV");
         Put ("  urv_sim numbers         times and lengths, as JSON");
         Put ("  urv_sim help [COMMAND]  this text, or its part about fly,");
         Put ("                          items or numbers");
         Put ("  urv_sim --version       the program's version");
         Put ("");
      end Put_Commands;

      procedure Put_Fly is
      begin
         Put ("options of fly (--option VALUE or --option=VALUE)");
         Put ("  --seconds S       length of the flight");
         Put ("                    (60, or that of the sticks or the pilot)");
         Put ("  --plant PLANT     bench or jsbsim (bench)");
         Put ("  --sticks FILE     the pilot's sticks, CSV (neutral)");
         Put ("  --pilot NAME      the simulated pilot flies: "
              & Pilot.Names);
         Put ("                    (nobody); needs --plant jsbsim");
         Put ("  --sensors FILE    the bench's sensors, CSV (neutral)");
         Put ("  --faults FILE     what goes wrong (nothing)");
         Put ("  --conditions FILE wind, ballast, errors of sensors (none);");
         Put ("                    needs --plant jsbsim");
         Put ("  --orders FILE     what the ground orders besides the sticks"
              & " (nothing)");
         Put ("  --seed N          of all that happens by chance (1)");
         Put ("  --phase TICKS     the aircraft's frame lags, 0 to"
              & Phase_Ticks'Last'Image & " ("
              & Text_Numbers.Image (Long_Long_Integer (Usual_Phase)) & ")");
         Put ("  --drift PPM       the aircraft's ticks are longer by so");
         Put ("                    many millionths, -200 to 200 (0)");
         Put ("  --lock            the aircraft's frames come in step with");
         Put ("                    the ground's");
         Put ("  --schedule NAME   of both nodes' tasks: " & Schedules.Names
              & " (report)");
         Put ("  --processors N    of each node, 1 or 2 (1)");
         Put ("  --laws LAWS       the aircraft's control laws, on or off");
         Put ("                    (on with jsbsim, off with the bench)");
         Put ("  --format N        of the messages, 1 or 2, which is sealed"
              & " (1)");
         Put ("  --key FILE        both nodes' keys, for format 2");
         Put ("  --record FILE     flight record, CSV");
         Put ("  --summary FILE    result, JSON");
         Put ("  --wire FILE       every byte on the serial link, CSV");
         Put ("  --events FILE     both error logs, JSON lines: node, kind,");
         Put ("                    count, first_frame, last_frame, first_ms,");
         Put ("                    last_ms, last_detail");
         Put ("  --pace PACE       max or realtime (max)");
         Put ("  --quiet           no progress, no summary");
         Put ("An output named - is standard output; the summary for people");
         Put ("then goes to standard error.");
         Put ("");
         Put ("faults, one a line; # starts a comment");
         for Kind in Faults.Fault_Kind loop
            Put ("  " & Faults.Form_Of (Kind));
         end loop;
         Put ("");
         Put ("conditions, one a line; # starts a comment");
         for Kind in Conditions.Condition_Kind loop
            Put ("  " & Conditions.Form_Of (Kind));
         end loop;
         Put ("");
         Put ("orders, one a line; # starts a comment");
         for Kind in Ground_Orders.Order_Kind loop
            Put ("  " & Ground_Orders.Form_Of (Kind));
         end loop;
         Put ("");
         Put ("exit status: 0 flown, 1 an output cannot be written or an");
         Put ("internal fault, 2 bad command line or bad input file");
         Put ("(FILE:LINE: what is wrong), 130 interrupted");
      end Put_Fly;

      procedure Put_Items is
      begin
         Put ("items prints a line for each word of the uplink, the downlink");
         Put ("and the PWM board: name, buffer, position, unit, what words 0");
         Put ("and 4095 stand for, the limits of warnings and cautions, what");
         Put ("a word is worth, and the word that stands for zero");
      end Put_Items;

      procedure Put_Numbers is
      begin
         Put ("numbers prints how long a tick, a frame, a conversion and a");
         Put ("character on the link are in us, how many words the buffers");
         Put ("have, and how many characters the messages: what a script");
         Put ("about a flight would else have to repeat");
      end Put_Numbers;

   begin
      case Topic is
         when All_Commands =>
            Put_Commands;
            Put_Fly;
            Put ("");
            Put_Items;
            Put ("");
            Put_Numbers;
            Put ("");
            Put ("docs/urv_sim.md has it all, with examples");
         when Of_Fly =>
            Put_Fly;
         when Of_Items =>
            Put_Items;
         when Of_Numbers =>
            Put_Numbers;
      end case;
   end Print;

end Sim.Options.Usage;
