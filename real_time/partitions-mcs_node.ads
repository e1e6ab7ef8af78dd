--  SPDX-License-Identifier: Apache-2.0

--  The aircraft's control system in its partition.

with MCS;
with Partitions.Aircraft;
with Partitions.Nodes;

package Partitions.MCS_Node is new Partitions.Nodes
  (Tasks               => MCS.Tasks,
   Run_Step            => MCS.Run_Step,
   Begin_Again         => MCS.Starts.Begin_Again,
   Tell_Time           => MCS.Tell_Time,
   Report_Overrun      => MCS.Report_Overrun,
   Look_At_Frame       => MCS.Look_At_Frame,
   AD_Board            => MCS.AD_Board,
   Telemetry_Board     => MCS.Telemetry_Board,
   Errors              => MCS.Errors,
   Sealing             => MCS.Sealing,
   Schedule            => MCS.Schedule,
   Processor_Board     => MCS.Processor_Board,
   Handle_AD_Interrupt => MCS.ADINT.Handle_Interrupt,
   AD_Task             => MCS.AD_Task,
   TELOUT_Task         => MCS.TELOUT_Task,
   CORE_Task           => MCS.CORE_Task,
   Sample              => Partitions.Aircraft.Sample,
   Append_Values       => Partitions.Aircraft.Append_Values,
   Append_Last         => Partitions.Aircraft.Append_Laws,
   Observe             => Partitions.Aircraft.Observe);
