--  SPDX-License-Identifier: Apache-2.0

--  The text files of the flight recorder (FTI-9 to FTI-11): rows as they were
--  recorded aboard (--recording), and blocks as they came down (--fetched).
--
--  A recording begins with a line that names it. A row is a line of its 72
--  words, each of four hexadecimal digits. A block is a line of its kind and
--  its 27 words, each of four.

with Host.Text_Output;   use Host.Text_Output;
with URV.Recorder_Rings; use URV.Recorder_Rings;
with URV.Recorder_Rows;  use URV.Recorder_Rows;

package Host.Recordings is

   Title : constant String := "urv recording 2";

   --  The length of a ring that holds that time, at most the largest.
   function Length_Of (Time : Microseconds) return Ring_Length;

   procedure Put_Row (To : in out Writer; Item : Row)
     with Pre => Is_Open (To);

   procedure Put_Block (To : in out Writer; Item : Downlink_Buffer)
     with Pre => Is_Open (To);

   --  Writes the rows that are new since the last call, up to Most of them.
   --  After a cold start aboard the file goes on with the title.

   Most : constant := 100;

   generic
      with function Contents return Ring;
      with function Row_At (Number : Row_Number) return Row;
   package Followers is
      procedure Put_New_Rows (To : in out Writer)
        with Pre => Is_Open (To);
   end Followers;

end Host.Recordings;
