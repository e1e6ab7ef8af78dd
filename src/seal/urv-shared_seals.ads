--  SPDX-License-Identifier: Apache-2.0

--  A node's seal between TELIN, TELOUT and whoever starts the node (SEC-1).

with Telemetry;       use Telemetry;
with URV.Seal_Blocks; use URV.Seal_Blocks;
with URV.Seals;       use URV.Seals;
with URV.Sessions;    use URV.Sessions;

package URV.Shared_Seals with SPARK_Mode is

   protected type Shared_Seal (Role : Station) is

      --  Before the node is switched on. Without it, it has format 1.
      procedure Configure
        (Format : Format_Number;
         Keys   : Key_List;
         Start  : Nonce);

      --  At a cold start.
      procedure Begin_Anew;

      procedure Open
        (Block : in out Block_Data;
         Came  : Boolean;
         What  : out Outcome);

      procedure Close (Data : in out Block_Data);

   private
      Item : Seal := New_Seal
        (Role, 1, [others => (others => <>)], 0);
   end Shared_Seal;

end URV.Shared_Seals;
