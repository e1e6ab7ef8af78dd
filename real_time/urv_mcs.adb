--  SPDX-License-Identifier: Apache-2.0

--  The aircraft's control system in real time.

with Host;
with Partitions.Aircraft;
with Partitions.MCS_Node;
with Partitions.Plant;
with Partitions.Run;

procedure Urv_MCS is

   procedure Run is new Partitions.Run
     (This         => Host.Aircraft,
      This_Node    => Partitions.MCS_Node,
      Prepare      => Partitions.Aircraft.Prepare,
      Column_Names => Partitions.Aircraft.Column_Names,
      Last_Names   => Partitions.Aircraft.Last_Names,
      Has_Truth    => Partitions.Plant.Is_Present,
      Next_News    => Partitions.Aircraft.Next_News,
      Put_Counts   => Partitions.Aircraft.Put_Counts,
      Put_Events   => Partitions.Plant.Put_Events,
      Failure      => Partitions.Plant.Failure,
      Stop         => Partitions.Plant.Stop);

begin
   Run;
end Urv_MCS;
