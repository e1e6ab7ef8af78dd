--  SPDX-License-Identifier: Apache-2.0

--  The aircraft's control system in real time.

with Host;
with Partitions.Aircraft;
with Partitions.MCS_Node;
with Partitions.Run;

procedure Urv_MCS is

   procedure Run is new Partitions.Run
     (This         => Host.Aircraft,
      This_Node    => Partitions.MCS_Node,
      Load_Script  => Partitions.Aircraft.Load,
      Column_Names => Partitions.Aircraft.Column_Names);

begin
   Run;
end Urv_MCS;
