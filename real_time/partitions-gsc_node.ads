--  SPDX-License-Identifier: Apache-2.0

--  The ground station core in its partition.

with GSC;
with Partitions.Boards;
with Partitions.Console;
with Partitions.Ground_Station;
with Partitions.Nodes;
with Partitions.Row_Contents;

package Partitions.GSC_Node is

   package Boards is new Partitions.Boards
     (AD_Board            => GSC.AD_Board,
      Telemetry_Board     => GSC.Telemetry_Board,
      Errors              => GSC.Errors,
      Sealing             => GSC.Sealing,
      Schedule            => GSC.Schedule,
      Processor_Board     => GSC.Processor_Board,
      Handle_AD_Interrupt => GSC.ADINT.Handle_Interrupt);

   package Contents is new Partitions.Row_Contents
     (Append_Values => Partitions.Console.Append_Values,
      Append_Last   => Partitions.Console.Append_Laws,
      Publish       => Partitions.Ground_Station.Publish,
      Column_Names  => Partitions.Console.Column_Names,
      Last_Names    => Partitions.Console.Law_Names,
      Has_Truth     => Partitions.Ground_Station.Has_Truth);

   package Node is new Partitions.Nodes
     (Software    => GSC.Software,
      Boards      => Boards,
      Contents    => Contents,
      AD_Task     => GSC.AD_Task,
      TELOUT_Task => GSC.TELOUT_Task,
      CORE_Task   => GSC.CORE_Task,
      Sample      => Partitions.Console.Sample);

end Partitions.GSC_Node;
