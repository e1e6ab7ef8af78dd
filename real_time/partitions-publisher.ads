--  SPDX-License-Identifier: Apache-2.0

--  Sends the contents of GSC CORE, each major frame, to the chosen receivers
--  (--publish; GND-2). The node makes the packet; a task of its own sends it
--  and waits for no receiver.

with Host.Frame_Layout; use Host.Frame_Layout;
with Host.Options;
with Partitions.Rows;   use Partitions.Rows;
with URVOS;             use URVOS;

package Partitions.Publisher is

   Most_Places : constant := Host.Options.Most_Places;

   --  The version of the packets, by default 1. Before the first packet.
   procedure Choose (Version : Version_Number);

   --  Adds udp:HOST:PORT, up to Most_Places. Raises Host.Bad_Input.
   procedure Open (Place : String);

   --  The frame's row of the record has been taken.
   procedure Publish (Item : Row);

   --  Waits until all is sent, for a second at most.
   procedure Finish;

   --  Packets that the machine did not accept, each place counted.
   function Not_Sent return Count;

end Partitions.Publisher;
