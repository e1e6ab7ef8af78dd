with Ada.Text_IO;

package body Sim.Options.Usage is

   procedure Print is
      procedure Put (Line : String) renames Ada.Text_IO.Put_Line;
   begin
      Put ("urv_sim: both nodes, the link between them and the aircraft,");
      Put ("in virtual time");
      Put ("");
      Put ("  urv_sim fly [options]");
      Put ("  urv_sim items  the table of items and their scaling, as CSV");
      Put ("  urv_sim help   this text");
      Put ("");
      Put ("options of fly (--option VALUE or --option=VALUE)");
      Put ("  --seconds S       length of the flight");
      Put ("                    (60, or that of the sticks or the pilot)");
      Put ("  --plant PLANT     bench or jsbsim (bench)");
      Put ("  --sticks FILE     the pilot's sticks, CSV (neutral)");
      Put ("  --pilot NAME      the simulated pilot flies, e.g. standard");
      Put ("  --sensors FILE    words of the bench's sensors, CSV (neutral)");
      Put ("  --faults FILE     what goes wrong (nothing)");
      Put ("  --seed N          for random faults (1)");
      Put ("  --phase TICKS     the aircraft's frame lags, 0 to 9 (3)");
      Put ("  --processors N    of the aircraft's node, 1 or 2 (1)");
      Put ("  --record FILE     flight record, CSV");
      Put ("  --summary FILE    result, JSON");
      Put ("  --wire FILE       every byte on the serial link, CSV");
      Put ("  --events FILE     the error logs of both nodes, JSON lines:");
      Put ("                    node, kind, count, first_frame, last_frame,");
      Put ("                    first_ms, last_ms, last_detail");
      Put ("  --pace PACE       max or realtime (max)");
      Put ("  --quiet           no progress, no summary");
      Put ("");
      Put ("exit status: 0 flown, 1 internal fault, 2 bad command line or");
      Put ("bad input file (FILE:LINE: what is wrong)");
   end Print;

end Sim.Options.Usage;
