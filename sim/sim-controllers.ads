--  SPDX-License-Identifier: Apache-2.0

--  The controllers of both nodes in virtual time: their clocks, their A/D
--  boards' hardware, and how they start again (INI-1, KRN-6, SIM-1).
--
--  A controller that starts again is down for the time of its self-test. Its
--  clock runs on meanwhile, but it misses the ticks and whatever the A/D
--  board has to tell it. docs/starts.md says more.

with Sim.Faults;
with Sim.Nodes;    use Sim.Nodes;
with URV.Buffers;  use URV.Buffers;
with URVOS;        use URVOS;
with URVOS.Frames; use URVOS.Frames;
with URVOS.Starts; use URVOS.Starts;

package Sim.Controllers is

   --  How long a start takes after a reset or an exception. An assumption of
   --  the simulation: five ticks, which a fast processor needs for the
   --  self-test.
   Start_Time : constant Microseconds := 5 * Tick_Time;

   --  Both will be switched on: the ground at time 0, the aircraft Lag later.
   --  The aircraft's ticks are longer by so many millionths.
   procedure Prepare
     (Lag        : Microseconds;
      Drift      : Drift_Number;
      Script     : Faults.Script;
      Processors : Processor_Count);

   --  When the node's clock comes to this minor frame the next time; before
   --  it is switched on, in the first frame of its tasks.
   function Next_Time_Of
     (Which : Node;
      Minor : Minor_Frame) return Microseconds;

   --  Whether the node has been switched on.
   function Is_On (Which : Node) return Boolean;

   --  What an A/D channel sees from now on.
   procedure Set_Input
     (Which : Node;
      Where : Channel;
      Value : Word);

   --  The node's processor stands still until a reset or a restart; its
   --  clock and its boards go on. Before it is switched on nothing happens.
   procedure Halt (Which : Node);

   --  A minor frame begins, the node's first one with power up.
   procedure Tick (Which : Node; Time : Microseconds);

   --  A conversion is done, and so are those after it until something else
   --  happens. Behind a scan's last one, at that time, tasks that wait for it
   --  have run.
   procedure End_Conversion
     (Which      : Node;
      Time       : in out Microseconds;
      Until_Time : Microseconds;
      Have_Run   : out Boolean);

   --  The reset switch, or an exception. One during a start begins it anew,
   --  as the last one says; but power up stays a cold start until one is
   --  through.
   procedure Begin_Start
     (Which     : Node;
      Time      : Microseconds;
      Condition : Start_Condition)
   with Pre => Is_On (Which);

   --  The time of the start has passed.
   procedure End_Start (Which : Node; Time : Microseconds);

end Sim.Controllers;
