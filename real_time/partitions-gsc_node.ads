--  SPDX-License-Identifier: Apache-2.0

--  The ground station core in its partition.

with GSC;
with Partitions.Console;
with Partitions.Nodes;
with Partitions.Publisher;

package Partitions.GSC_Node is new Partitions.Nodes
  (Tasks               => GSC.Tasks,
   Run_Step            => GSC.Run_Step,
   Begin_Again         => GSC.Starts.Begin_Again,
   Tell_Time           => GSC.Tell_Time,
   Report_Overrun      => GSC.Report_Overrun,
   AD_Board            => GSC.AD_Board,
   Telemetry_Board     => GSC.Telemetry_Board,
   Errors              => GSC.Errors,
   Sealing             => GSC.Sealing,
   Schedule            => GSC.Schedule,
   Processor_Board     => GSC.Processor_Board,
   Handle_AD_Interrupt => GSC.ADINT.Handle_Interrupt,
   AD_Task             => GSC.AD_Task,
   TELOUT_Task         => GSC.TELOUT_Task,
   CORE_Task           => GSC.CORE_Task,
   Sample              => Partitions.Console.Sample,
   Append_Values       => Partitions.Console.Append_Values,
   Append_Last         => Partitions.Console.Append_Laws,
   Publish             => Partitions.Publisher.Publish);
