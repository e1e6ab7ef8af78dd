--  SPDX-License-Identifier: Apache-2.0

--  run_thermostat virtual|real PROCESSORS: five seconds of the thermostat,
--  at once or in as many; then what it has reached and what went wrong.
--
--  Exit status: 0 run, 1 an exception that nobody expected, 2 a bad command
--  line.

with Ada.Command_Line; use Ada.Command_Line;
with Ada.Exceptions;   use Ada.Exceptions;
with Ada.Real_Time;    use Ada.Real_Time;
with Ada.Text_IO;      use Ada.Text_IO;
with GNAT.OS_Lib;
with Thermostat;       use Thermostat;
with Thermostat.Real_Time;
with Thermostat.Task_Ends;
with Thermostat.Virtual_Time;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Starts;     use URVOS.Starts;
with URVOS.Task_Trees; use URVOS.Task_Trees;

procedure Run_Thermostat is

   procedure Run (Clock_Name : String; Processors : Processor_Number);

   procedure Run (Clock_Name : String; Processors : Processor_Number) is
      Beginning : constant Time := Clock;
   begin
      if Clock_Name = "real" then
         Thermostat.Real_Time.Node.Switch_On (Processors, Beginning);
         delay until Beginning + Seconds (5);
      else
         Virtual_Time.Start (Cold_Start, 0, Processors);
         for Now in Clock_Tick range 1 .. 5 * 500 loop
            Virtual_Time.Clock_Interrupt (Now);
         end loop;
      end if;

      Put_Line ("temperature" & Control_State.Contents.Newest'Image);
      Put_Line ("misses" & Readings.Boxes.Misses (Reading.Snapshot)'Image);
      for Kind in Trouble loop
         Put_Line
           (Kind'Image
            & Logs.History_Of (Log.Contents, Kind).Occurrences'Image);
      end loop;
      Flush;
   end Run;

begin
   if Argument_Count = 2
     and then Argument (1) in "virtual" | "real"
     and then Argument (2) in "1" | "2"
   then
      Run (Argument (1), Processor_Number'Value (Argument (2)));
      GNAT.OS_Lib.OS_Exit (0);   --  Ravenscar tasks do not end
   end if;
   Task_Ends.Give_Up ("usage: run_thermostat virtual|real 1|2", 2);

exception
   when Error : others =>
      Task_Ends.Give_Up
        (Exception_Name (Error) & ": " & Exception_Message (Error), 1);
end Run_Thermostat;
