--  SPDX-License-Identifier: Apache-2.0

--  The ground station core in real time.

with Host;
with Partitions.Console;
with Partitions.GSC_Node;
with Partitions.Run;

procedure Urv_GSC is

   procedure Run is new Partitions.Run
     (This         => Host.Ground,
      This_Node    => Partitions.GSC_Node,
      Load_Script  => Partitions.Console.Load,
      Column_Names => Partitions.Console.Column_Names);

begin
   Run;
end Urv_GSC;
