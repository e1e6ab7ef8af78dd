--  SPDX-License-Identifier: Apache-2.0

--  Sends what GSC CORE has, each major frame, to who wants it (--publish;
--  GND-2). The node makes the packet; a task of its own sends it and waits
--  for nobody.

with Host.Frame_Layout; use Host.Frame_Layout;
with Host.Options;
with Partitions.Rows;   use Partitions.Rows;
with URVOS;             use URVOS;

package Partitions.Publisher is

   Most_Places : constant := Host.Options.Most_Places;

   --  The version of the packets, 1 unless said. Before the first one.
   procedure Choose (Version : Version_Number);

   --  Sends to udp:HOST:PORT, too; to so many at most. Raises Host.Bad_Input.
   procedure Open (Place : String);

   --  The frame's row of the record has been taken.
   procedure Publish (Item : Row);

   --  Waits until all is sent, for a second at most.
   procedure Finish;

   --  Packets that the machine did not take, each place counted.
   function Not_Sent return Count;

end Partitions.Publisher;
