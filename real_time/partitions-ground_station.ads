--  SPDX-License-Identifier: Apache-2.0

--  The environment of the ground's node: the source of the sticks, and the
--  receivers of CORE's contents (GND-2, GND-3).

with Host.Options;
with Host.Text_Output;
with Partitions.Reports;
with Partitions.Rows;

package Partitions.Ground_Station is

   --  Raises Host.Bad_Input.
   procedure Prepare (Chosen : Host.Options.Choices);

   --  A frame's row of the record is complete: CORE's contents go to the
   --  station, a new block of the flight recorder to its fetcher.
   procedure Publish (Item : Partitions.Rows.Row);

   function Has_Truth return Boolean is (False);

   function Failure return String is ("");

   --  For the summary.
   procedure Put_Counts
     (Result : in out Partitions.Reports.Report;
      To     : in out Host.Text_Output.Writer);

end Partitions.Ground_Station;
