--  SPDX-License-Identifier: Apache-2.0

--  Events of a partition that are no events of its node, for the lines of
--  --events: count, first and last time (GND-4).

with Host;  use Host;
with Host.Text_Output;
with URVOS; use URVOS;

package Partitions.Occurrences is

   type History is record
      Number      : Count        := 0;
      First, Last : Microseconds := 0;   --  since the node was switched on
   end record;

   protected type Occurrence is

      procedure Add (At_Time : Microseconds);

      function Contents return History;

   private
      Counted : History;
   end Occurrence;

   --  Ends the counting, though the node flies on: the summary and the events,
   --  written one after the other, then describe the same moment (GND-6).
   procedure Finish;

   --  Writes a line like those of the node's error log, if there was any
   --  event.
   procedure Write
     (To    : in out Host.Text_Output.Writer;
      Where : Node;
      Kind  : String;
      This  : History);

end Partitions.Occurrences;
