--  SPDX-License-Identifier: Apache-2.0

--  One who has the line but no key tries blocks on both nodes while they fly
--  (SEC-1, SEC-3, SEC-4). Before each try the nodes may go on with their
--  session; the try is then given to one of them.

with URV.Handshakes;  use URV.Handshakes;

package Seal_Tries is

   type Attack is
     (Forged,           --  random bytes after the right mark
      Forged_Hello,
      Altered,          --  of the newest block some bits
      Replayed,         --  the newest block again
      Reordered,        --  one before the newest, not taken yet
      Other_Direction,  --  the node's own
      Other_Session,    --  of the same nodes, keys and numbers
      Old_Hello,        --  the hellos of other sessions
      Other_Format);    --  of format 1

   type Total is range 0 .. 2 ** 63 - 1;

   type Results is array (Attack, Outcome) of Total;

   --  A number of tries, drawn from the seed. A block that opens is Taken; so
   --  counts, as Opened, whatever the node's session or words show of it.
   procedure Try (Number : Total; Seed : Total; Found : out Results);

end Seal_Tries;
