--  SPDX-License-Identifier: Apache-2.0

--  The ground station core in real time.

with Host;
with Partitions.Console;
with Partitions.Ground_Station;
with Partitions.GSC_Node;
with Partitions.Publisher;
with Partitions.Run;
with Partitions.Surroundings;

procedure Urv_GSC is

   package Surroundings is new Partitions.Surroundings
     (Prepare      => Partitions.Ground_Station.Prepare,
      Next_Message => Partitions.Console.Next_Message,
      Put_Counts   => Partitions.Ground_Station.Put_Counts,
      Put_Events   => Partitions.Console.Put_Events,
      Failure      => Partitions.Ground_Station.Failure,
      Stop         => Partitions.Publisher.Finish);

   procedure Run is new Partitions.Run
     (This         => Host.Ground,
      This_Node    => Partitions.GSC_Node.Node,
      Contents     => Partitions.GSC_Node.Contents,
      Surroundings => Surroundings);

begin
   Run;
end Urv_GSC;
