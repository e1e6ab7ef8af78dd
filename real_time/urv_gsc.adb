--  SPDX-License-Identifier: Apache-2.0

--  The ground station core in real time.

with Host;
with Partitions.Console;
with Partitions.Ground_Station;
with Partitions.GSC_Node;
with Partitions.Publisher;
with Partitions.Run;

procedure Urv_GSC is

   procedure Run is new Partitions.Run
     (This         => Host.Ground,
      This_Node    => Partitions.GSC_Node,
      Prepare      => Partitions.Ground_Station.Prepare,
      Column_Names => Partitions.Console.Column_Names,
      Last_Names   => Partitions.Console.Law_Names,
      Has_Truth    => Partitions.Ground_Station.Has_Truth,
      Next_News    => Partitions.Console.Next_News,
      Put_Counts   => Partitions.Ground_Station.Put_Counts,
      Put_Events   => Partitions.Console.Put_Events,
      Failure      => Partitions.Ground_Station.Failure,
      Stop         => Partitions.Publisher.Finish);

begin
   Run;
end Urv_GSC;
