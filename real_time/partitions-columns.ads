--  SPDX-License-Identifier: Apache-2.0

--  The groups of columns of the flight record.

with Host;            use Host;
with Partitions.Rows; use Partitions.Rows;
with URV.Buffers;     use URV.Buffers;
with URVOS;

package Partitions.Columns is

   --  Each name after a comma and its group.
   function Console_Names (Group : String) return String;
   function Uplink_Names (Group : String) return String;
   function PWM_Names (Group : String) return String;
   function Downlink_Names (Group : String) return String;
   function Frame_Names (Group : String) return String;

   procedure Append_Console (To : in out Row; Words : Console_Words);
   procedure Append_Uplink (To : in out Row; Words : Uplink_Buffer);
   procedure Append_PWM (To : in out Row; Words : PWM_Buffer);
   procedure Append_Downlink (To : in out Row; Words : Downlink_Buffer);
   procedure Append_Frame (To : in out Row; Words : Frame_Words);

   type Link_Counts is array (1 .. 5) of URVOS.Count;

   procedure Append_Counts (To : in out Row; Counts : Link_Counts);

end Partitions.Columns;
