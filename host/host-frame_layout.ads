--  SPDX-License-Identifier: Apache-2.0

--  The lists and lengths of the frame packet (GND-2, GND-7): the contents of
--  GSC CORE at the end of a major frame, in one datagram. Its layout is in
--  docs/station-packets.md. `urv_sim tables` prints these lists for the
--  station (GND-11).

with URV.CORE_Memory; use URV.CORE_Memory;

package Host.Frame_Layout is

   --  Version 2 is version 1 followed by the other rows of the logs, version 3
   --  is version 2 followed by the frame of the downlink (FTI-12).
   type Version_Number is range 1 .. 3;

   --  The rows of each log that all versions have, and those of version 2.
   Rows_Of_First : constant := 32;
   subtype First_Row is Log_Row_Number range 1 .. Rows_Of_First;
   subtype Added_Row is
     Log_Row_Number range Rows_Of_First + 1 .. Log_Row_Number'Last;

   type Link_Count is
     (Uplink_Sent, Uplink_Scrapped, Downlink_Received, Downlink_Bad, Resets,
      Bytes_Discarded, Overruns, Publish_Not_Sent, Console_Packets,
      Console_Bad);

   --  The words of console, uplink and downlink, as in the record.
   Word_Count : constant :=
     (Command_Item'Pos (Command_Item'Last) + 1)
     + (Uplink_Item'Pos (Uplink_Item'Last) + 1)
     + (Downlink_Item'Pos (Downlink_Item'Last) + 1);

   --  Lengths in bytes. The head is magic, version, length, run, sequence,
   --  time, age of the downlink, states of console and link, and the console's
   --  sequence. The logs of both nodes follow, then status and pilot.
   Head_Length : constant := 4 + 2 + 2 + 4 + 4 + 8 + 4 + 2 + 2 + 4;
   Row_Length  : constant := 2 * (Log_Field'Pos (Log_Field'Last) + 1);

   First_Length : constant :=
     Head_Length
     + 4 * (Link_Count'Pos (Link_Count'Last) + 1)
     + 2 * Word_Count
     + 2 * Rows_Of_First * Row_Length
     + 2 * (Status_Item'Pos (Status_Item'Last) + 1)
     + 2;

   Second_Length : constant :=
     First_Length
     + 2 * (Log_Row_Number'Pos (Log_Row_Number'Last) - Rows_Of_First)
       * Row_Length;

   Longest : constant :=
     Second_Length + 2 * (Frame_Item'Pos (Frame_Item'Last) + 1);

   function Length (Version : Version_Number) return Positive is
     (case Version is
         when 1 => First_Length,
         when 2 => Second_Length,
         when 3 => Longest);

end Host.Frame_Layout;
