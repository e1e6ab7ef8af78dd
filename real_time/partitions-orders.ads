--  SPDX-License-Identifier: Apache-2.0

--  What the ground orders besides the sticks, on its way to the node (EXT-2,
--  GND-35): from a file (--orders), or from packets at the console's port.
--
--  An order takes the place of a frame's commands, so one goes in 100 ms.

with URV.Buffers; use URV.Buffers;
with URVOS;       use URVOS;

package Partitions.Orders is

   --  Raises Host.Bad_Input.
   procedure Load (File : String);

   --  Of a packet. It is not taken while another one waits.
   procedure Give (Block : Uplink_Buffer; Is_Taken : out Boolean);

   --  What is due goes to the node. Each frame, for the converter alone.
   procedure Send_Due;

   --  How many went to the node.
   function Sent return Count;

end Partitions.Orders;
