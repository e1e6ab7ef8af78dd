--  SPDX-License-Identifier: Apache-2.0

--  What can happen in the simulation, and when each happens next.

package Sim.Agenda is

   --  Of events at the same instant the first named happens first.
   type Event is
     (Arrival_Up, Arrival_Down,           --  one sent comes, by a slow line
      Extra_Up, Extra_Down,               --  one more comes than was sent
      Character_Up, Character_Down,       --  a character has been sent
      Hardware_Fault,                     --  a node's hardware suffers
      GSC_Converted, MCS_Converted,       --  an A/D conversion is done
      GSC_Time_Out, MCS_Time_Out,         --  a telemetry board's patience
      GSC_Clock, MCS_Clock,               --  a minor frame begins
      GSC_Started, MCS_Started);          --  a controller starts again

   --  Nothing happens.
   procedure Clear;

   --  Enters when an event happens next.
   procedure Schedule (What : Event; Time : Microseconds) with Inline;

   procedure Cancel (What : Event) with Inline;

   function Is_Due (What : Event) return Boolean with Inline;

   --  The first event; What has no meaning when Time is the last.
   procedure Find_First (What : out Event; Time : out Microseconds)
   with Inline;

   --  When the first of the others happens.
   function First_Besides (What : Event) return Microseconds with Inline;

end Sim.Agenda;
