--  The deterministic twin: both nodes, both telemetry boards, the serial
--  link, boards and aircraft in one process in virtual time.
--
--  Exit status: 0 flown, 1 an internal fault of the simulation, 2 a bad
--  command line or input file.

with Ada.Command_Line;
with Ada.Exceptions;
with Ada.Text_IO;

with Sim;
with Sim.Complaints;
with Sim.Flight;
with Sim.Nodes;
with Sim.Options;
with Sim.Pilot;
with Sim.Scaling;

procedure Urv_Sim is

   function Knows_Pilot (Flight : String) return Boolean is
     (Sim.Pilot.Exists (Flight));

begin
   declare
      Chosen : constant Sim.Options.Choices :=
        Sim.Options.Parsed (Knows_Pilot'Access);
   begin
      case Chosen.Order is
         when Sim.Options.Help  => Sim.Options.Print_Usage;
         when Sim.Options.Items => Sim.Scaling.Print;
         when Sim.Options.Fly   => Sim.Flight.Fly (Chosen);
            if Sim.Nodes.Has_Failed then
               Ada.Command_Line.Set_Exit_Status (1);
            end if;
      end case;
   end;

exception
   when Error : Sim.Bad_Input =>
      Sim.Complaints.Print (Error);
      Ada.Command_Line.Set_Exit_Status (2);

   when Error : others =>
      Ada.Text_IO.Put_Line
        (Ada.Text_IO.Standard_Error,
         "urv_sim: internal fault: "
         & Ada.Exceptions.Exception_Information (Error));
      Ada.Command_Line.Set_Exit_Status (1);
end Urv_Sim;
