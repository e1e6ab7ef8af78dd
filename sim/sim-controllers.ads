--  SPDX-License-Identifier: Apache-2.0

--  The controllers of both nodes in virtual time: their clocks, their A/D
--  boards' hardware, and their starts (INI-1, KRN-6, SIM-1).
--
--  A starting controller is down for the time of its self-test. Its clock
--  continues, but the controller misses the ticks and the A/D board's
--  interrupts. See docs/starts.md.

with Sim.Faults;
with Sim.Nodes;    use Sim.Nodes;
with URV.Buffers;  use URV.Buffers;
with URVOS;        use URVOS;
with URVOS.Frames; use URVOS.Frames;
with URVOS.Starts; use URVOS.Starts;

package Sim.Controllers is

   --  The duration of a start after a reset or an exception. An assumption of
   --  the simulation: five ticks, enough for the self-test on a fast
   --  processor.
   Start_Time : constant Microseconds := 5 * Tick_Time;

   --  Both nodes will be switched on: the ground at time 0, the aircraft Lag
   --  later. The aircraft's ticks are longer by the given millionths.
   procedure Prepare
     (Lag        : Microseconds;
      Drift      : Drift_Number;
      Script     : Faults.Script;
      Processors : Processor_Count);

   --  The next time at which the node's clock reaches this minor frame; before
   --  power up, the time in the first frame of its tasks.
   function Next_Time_Of
     (Which : Node;
      Minor : Minor_Frame) return Microseconds;

   --  The time at which the node's clock came to that tick.
   function Time_Of (Which : Node; Now : Clock_Tick) return Microseconds;

   --  True if the node has been switched on.
   function Is_On (Which : Node) return Boolean;

   --  Sets the word on an A/D channel from now on.
   procedure Set_Input
     (Which : Node;
      Where : Channel;
      Value : Word);

   --  Halts the node's processor until a reset or a restart; its clock and its
   --  boards continue. Before power up this has no effect.
   procedure Halt (Which : Node);

   --  A minor frame begins, the node's first one with power up.
   procedure Tick (Which : Node; Time : Microseconds);

   --  A conversion is complete, and so are the following ones until another
   --  event happens. At the time of a scan's last conversion the waiting tasks
   --  have run.
   procedure End_Conversion
     (Which      : Node;
      Time       : in out Microseconds;
      Until_Time : Microseconds;
      Have_Run   : out Boolean);

   --  The reset switch, or an exception. Another one during a start restarts
   --  it, with the newest cause; but a power up remains a cold start until a
   --  start is complete.
   procedure Begin_Start
     (Which     : Node;
      Time      : Microseconds;
      Condition : Start_Condition)
   with Pre => Is_On (Which);

   --  The time of the start has passed.
   procedure End_Start (Which : Node; Time : Microseconds);

end Sim.Controllers;
