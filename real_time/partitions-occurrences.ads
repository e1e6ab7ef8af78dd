--  SPDX-License-Identifier: Apache-2.0

--  What befalls a partition and not its node, as the lines of --events tell
--  it: how often, when first and when last (GND-4).

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
      Told : History;
   end Occurrence;

   --  Nothing more is added, though the node flies on: the summary and the
   --  events, written one after the other, tell of one moment (GND-6).
   procedure Finish;

   --  A line like those of the node's error log, if there was any.
   procedure Write
     (To   : in out Host.Text_Output.Writer;
      Who  : Node;
      Kind : String;
      This : History);

end Partitions.Occurrences;
