--  SPDX-License-Identifier: Apache-2.0

--  The events of the simulation, each with its next time.

package Sim.Agenda is

   --  Among events at the same instant the first named happens first.
   type Event is
     (Arrival_Up, Arrival_Down,           --  a delayed character arrives
      Extra_Up, Extra_Down,               --  an additional character arrives
      Character_Up, Character_Down,       --  a character has been sent
      Hardware_Fault,                     --  a fault hits a node's hardware
      GSC_Converted, MCS_Converted,       --  an A/D conversion is done
      GSC_Time_Out, MCS_Time_Out,         --  a telemetry board's time-out ends
      GSC_Clock, MCS_Clock,               --  a minor frame begins
      GSC_Started, MCS_Started);          --  a controller's start is over

   --  Removes all events.
   procedure Clear;

   --  Sets the next time of an event.
   procedure Schedule (Item : Event; Time : Microseconds) with Inline;

   procedure Cancel (Item : Event) with Inline;

   function Is_Due (Item : Event) return Boolean with Inline;

   --  The first event; Item has no meaning when Time is the last.
   procedure Find_First (Item : out Event; Time : out Microseconds)
   with Inline;

   --  The time of the first other event.
   function First_Besides (Item : Event) return Microseconds with Inline;

end Sim.Agenda;
