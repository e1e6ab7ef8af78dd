--  SPDX-License-Identifier: Apache-2.0

--  The pilot's console: sticks and switches at rest, or as a file says
--  (--sticks).

with Partitions.Rows; use Partitions.Rows;
with URV.Buffers;     use URV.Buffers;

package Partitions.Console is

   procedure Load (File : String);

   --  What the A/D board's channels see.
   procedure Sample (Words : out Channel_Words);

   --  The names and the values of the record's columns that this node has.
   function Column_Names return String;
   procedure Append_Values (To : in out Row);

end Partitions.Console;
