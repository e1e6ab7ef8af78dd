--  SPDX-License-Identifier: Apache-2.0

--  The aircraft's control system in its partition.

with MCS;
with Partitions.Aircraft;
with Partitions.Boards;
with Partitions.Nodes;
with Partitions.Plant;
with Partitions.Row_Contents;

package Partitions.MCS_Node is

   package Boards is new Partitions.Boards
     (AD_Board            => MCS.AD_Board,
      Telemetry_Board     => MCS.Telemetry_Board,
      Errors              => MCS.Errors,
      Sealing             => MCS.Sealing,
      Schedule            => MCS.Schedule,
      Processor_Board     => MCS.Processor_Board,
      Handle_AD_Interrupt => MCS.ADINT.Handle_Interrupt);

   package Contents is new Partitions.Row_Contents
     (Append_Values => Partitions.Aircraft.Append_Values,
      Append_Last   => Partitions.Aircraft.Append_Laws,
      Column_Names  => Partitions.Aircraft.Column_Names,
      Last_Names    => Partitions.Aircraft.Last_Names,
      Has_Truth     => Partitions.Plant.Is_Present);

   package Node is new Partitions.Nodes
     (Software    => MCS.Software,
      Boards      => Boards,
      Contents    => Contents,
      AD_Task     => MCS.AD_Task,
      TELOUT_Task => MCS.TELOUT_Task,
      CORE_Task   => MCS.CORE_Task,
      Sample      => Partitions.Aircraft.Sample,
      Observe     => Partitions.Aircraft.Observe);

end Partitions.MCS_Node;
