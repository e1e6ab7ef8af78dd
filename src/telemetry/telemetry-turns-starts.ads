--  SPDX-License-Identifier: Apache-2.0

--  What a board knows after a start, of its own or of its controller's half
--  (INI-4). These functions are the code: Telemetry.Boards assigns their
--  results.

package Telemetry.Turns.Starts with Pure, SPARK_Mode is

   --  The transmit buffers are cleared. A ground whose message is broken off
   --  idles before it sends again, as after a reset.
   function Cleared (Item : Control) return Control is
     (if not Has_Block_Out (Item) then Item
      else (Item with delta State => After_Break (Item), Silence => 0))
   with Global => null;

   --  The board has neither sent nor received. It may have been in the
   --  middle of a message: the ground idles first.
   function Started (Item : Control; Blocks : Buffer_Pair) return Control is
     ((Role            => Item.Role,
       Transmit_Length => Item.Transmit_Length,
       Receive_Length  => Item.Receive_Length,
       Sender          => Item.Sender,
       State           => After_Break (Item),
       Tally           => (Item.Tally with delta
         Scrapped => Counted
           (Item.Tally.Scrapped,
            Is_Scrapped (Blocks, Item.Sender.Source, Fate_In_Reset (Item)))),
       others          => <>))
   with Global => null;

end Telemetry.Turns.Starts;
