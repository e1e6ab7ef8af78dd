--  SPDX-License-Identifier: Apache-2.0

--  Both nodes, their boards' hardware and the serial link, in virtual time
--  (SIM-1, SIM-2).
--
--  The engine jumps from event to event: clock ticks of 2 ms, conversions
--  of 16 us, characters of 96 us, the telemetry boards' time-outs. Between
--  two calls of Run the caller may change what the converters see.
--
--  Events at the same instant happen in a fixed order, so that the same
--  flight is the same every time. There is one engine.

with Host.Text_Output;
with Sim.Faults;
with Sim.Nodes; use Sim.Nodes;
with Telemetry;

package Sim.Engine is

   --  Switches both nodes on: the ground at time 0, the aircraft Lag later,
   --  with ticks that are longer by Drift millionths.
   --  Random faults are drawn from Seed. Processors is the number of
   --  processors of the aircraft's node. Line is the delay of the serial link.
   procedure Start
     (Lag        : Microseconds;
      Script     : Faults.Script;
      Seed       : Seed_Number;
      Processors : Processor_Count := 1;
      Drift      : Drift_Number := 0;
      Line       : Telemetry.Line_Delay := 0);

   --  Runs all events before Stop. Bytes on the link are written to Wire if
   --  that is open.
   procedure Run
     (Stop : Microseconds;
      Wire : in out Text_Output.Writer);

   --  Set the words on the converters' channels from now on.

   procedure Set_Console (Words : Console_Words);

   procedure Set_Sensors (Words : Sensor_Words);

   --  The link's counts so far.
   function Link return Link_Counts;

   --  The number of characters that a fault waits for.
   function Awaited_Characters return Natural;

end Sim.Engine;
