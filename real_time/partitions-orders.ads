--  SPDX-License-Identifier: Apache-2.0

--  The ground's orders besides the sticks, on the way to the node (EXT-2,
--  GND-35): from a file (--orders), or from packets at the console's port.
--
--  An order replaces a frame's commands, so at most one is sent in 100 ms.

with URV.Buffers; use URV.Buffers;
with URVOS;       use URVOS;

package Partitions.Orders is

   --  Raises Host.Bad_Input.
   procedure Load (File : String);

   --  Gives the order of a packet. It is not taken while another one waits.
   procedure Give (Block : Uplink_Buffer; Is_Taken : out Boolean);

   --  Sends a due order to the node. Each frame, for the converter only.
   procedure Send_Due;

   --  The number of orders sent to the node.
   function Sent return Count;

end Partitions.Orders;
