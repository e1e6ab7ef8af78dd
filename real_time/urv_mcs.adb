--  SPDX-License-Identifier: Apache-2.0

--  The aircraft's control system in real time.

with Host;
with Partitions.Aircraft;
with Partitions.MCS_Node;
with Partitions.Plant;
with Partitions.Run;
with Partitions.Surroundings;

procedure Urv_MCS is

   package Surroundings is new Partitions.Surroundings
     (Prepare      => Partitions.Aircraft.Prepare,
      Next_Message => Partitions.Aircraft.Next_Message,
      Put_Counts   => Partitions.Aircraft.Put_Counts,
      Put_Events   => Partitions.Plant.Put_Events,
      Put_Recording => Partitions.Aircraft.Put_Recording,
      Failure      => Partitions.Plant.Failure,
      Stop         => Partitions.Plant.Stop);

   procedure Run is new Partitions.Run
     (This         => Host.Aircraft,
      This_Node    => Partitions.MCS_Node.Node,
      Contents     => Partitions.MCS_Node.Contents,
      Surroundings => Surroundings);

begin
   Run;
end Urv_MCS;
