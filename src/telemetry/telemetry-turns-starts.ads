--  SPDX-License-Identifier: Apache-2.0

--  The state of a board's control after a start of the board or of its
--  controller (INI-4). Telemetry.Boards assigns the results of these
--  functions.

package Telemetry.Turns.Starts with Pure, SPARK_Mode is

   --  The transmit buffers are cleared. If this breaks off a message, the
   --  ground idles before it sends again, as after a reset.
   function Cleared (This : Control) return Control is
     (if not Has_Block_Out (This) then This
      else (This with delta State => After_Break (This), Silence => 0))
   with Global => null;

   --  The board has neither sent nor received since the start. The start may
   --  have interrupted a message, so the ground idles first.
   function Started (This : Control; Blocks : Buffer_Pair) return Control is
     ((Role            => This.Role,
       Transmit_Length => This.Transmit_Length,
       Receive_Length  => This.Receive_Length,
       Round_Trip      => This.Round_Trip,
       Sender          => This.Sender,
       State           => After_Break (This),
       Tally           => (This.Tally with delta
         Scrapped => Counted
           (This.Tally.Scrapped,
            Is_Scrapped
              (Blocks, This.Sender.Source, Delivery_In_Reset (This)))),
       others          => <>))
   with Global => null;

end Telemetry.Turns.Starts;
