--  SPDX-License-Identifier: Apache-2.0

--  The deterministic twin: both nodes, both telemetry boards, the serial
--  link, boards and aircraft in one process in virtual time.
--
--  Exit status: 0 flown, 1 an output was lost or an internal fault,
--  2 a bad command line or input file, 130 interrupted.

with Ada.Command_Line; use Ada.Command_Line;
with Ada.Exceptions;   use Ada.Exceptions;

with Host;             use Host;
with Host.Complaints;
with Host.Options;
with Host.Plant_Messages;
with Host.Scaling;
with Host.Text_Numbers;
with Host.Text_Output;
with Sim;              use Sim;
with Sim.Commands;
with Sim.Flight;
with Sim.JSBSim;
with Sim.Nodes;
with Sim.Numbers;
with Sim.One_Thread;
pragma Unreferenced (Sim.One_Thread);
with Sim.Signals;
with Sim.Tables;

procedure Urv_Sim is

   Failure     : constant := 1;
   Interrupted : constant := 130;

   procedure Complain (Message : String);

   --  Seconds with two decimals, the resolution of frames.
   function Seconds (Time : Microseconds) return String;

   procedure Fly (Chosen : Host.Options.Choices);

   procedure Complain (Message : String) is
   begin
      Complaints.Report (Message);
   end Complain;

   function Seconds (Time : Microseconds) return String is
      function Image (Value : Microseconds) return String is
        (Text_Numbers.Image (Long_Long_Integer (Value)));

      Hundredths : constant Microseconds := Time / 10_000;
   begin
      return
        Image (Hundredths / 100) & '.' & Image (Hundredths / 10 mod 10)
        & Image (Hundredths mod 10);
   end Seconds;

   procedure Fly (Chosen : Host.Options.Choices) is
      Flown : Microseconds;
   begin
      Flight.Fly (Chosen, Flown);
      if Nodes.Has_Failed then
         Set_Exit_Status (Failure);
      elsif Signals.Interrupted then
         Complain ("interrupted at " & Seconds (Flown) & " s");
         Set_Exit_Status (Interrupted);
      end if;
   end Fly;

begin
   declare
      Asked  : constant Commands.Call := Commands.Parsed;
      Screen : Text_Output.Writer;
   begin
      case Asked.Order is
         when Commands.Fly     =>
            Fly (Asked.Chosen);
         when Commands.Help    =>
            Text_Output.Attach_Screen (Screen);
            Commands.Print_Usage (Screen, Asked.About);
         when Commands.Items   =>
            Text_Output.Attach_Screen (Screen);
            Scaling.Print (Screen);
         when Commands.Numbers =>
            Text_Output.Attach_Screen (Screen);
            Numbers.Print (Screen);
         when Commands.Tables =>
            Text_Output.Attach_Screen (Screen);
            Tables.Print (Screen);
         when Commands.Version =>
            Text_Output.Attach_Screen (Screen);
            Text_Output.Put_Line (Screen, "urv_sim " & Host.Version);
      end case;
      Text_Output.Close (Screen);
   end;
   if Text_Output.Any_Lost then
      Set_Exit_Status (Failure);
   end if;

exception
   when Error : Bad_Input =>
      Complaints.Print (Error);
      Set_Exit_Status (Complaints.Exit_Status);

   when Error : JSBSim.Plant_Failure | JSBSim.Plant_Silence
              | Plant_Messages.Not_Finite =>
      Complain ("--plant jsbsim: " & Exception_Message (Error));
      Set_Exit_Status (Failure);

   when Error : others =>
      Complain ("internal fault: " & Exception_Information (Error));
      Set_Exit_Status (Failure);
end Urv_Sim;
