--  SPDX-License-Identifier: Apache-2.0

--  The surroundings of a node's partition: its input files and links, its
--  plant or its station.

with Host.Options;
with Host.Text_Output;
with Partitions.Reports;

--  A signature: who instantiates with it references its formals.
pragma Warnings (Off, "*is not referenced");

generic
   --  Opens the files and links of the command line. Raises Host.Bad_Input.
   with procedure Prepare (Chosen : Host.Options.Choices);

   --  News for people, or empty. Now is the present time in seconds.
   with function Next_Message (Now : String) return String;

   --  For the summary and the events.
   with procedure Put_Counts
     (Result : in out Reports.Report;
      To     : in out Host.Text_Output.Writer);
   with procedure Put_Events (To : in out Host.Text_Output.Writer);

   --  The new rows of a flight recorder, of a node that has one (FTI-11).
   with procedure Put_Recording
     (To : in out Host.Text_Output.Writer) is null;

   --  The reason of a failed run; empty after a good one.
   with function Failure return String;

   --  The last call of a run.
   with procedure Stop;
package Partitions.Surroundings is

end Partitions.Surroundings;
