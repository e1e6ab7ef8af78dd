--  SPDX-License-Identifier: Apache-2.0

--  Reads an input file line by line and counts the lines, so that every
--  refusal names file and line. Lines may end in LF or CR LF; the last one
--  needs no end. A byte order mark at the beginning is skipped.

private with Ada.Finalization;
private with Ada.Strings.Unbounded;
private with GNAT.OS_Lib;

package Host.Text_Input is

   --  No sensible line comes near this length.
   Longest_Line : constant := 4_096;

   type Reader is limited private;

   --  Refuses at line 1 a file that is missing, unreadable, empty, a
   --  directory, a pipe or a device (SEC-14). Never blocks.
   procedure Open (From : in out Reader; File : String);

   --  Takes the next line. At the end of the file nothing is found, and the
   --  line number is that after the last line.
   procedure Next_Line (From : in out Reader; Found : out Boolean);

   function Line_Number (From : Reader) return Positive;

   --  The line without its end.
   function Line (From : Reader) return String with Inline;

   --  Refuses the file at the present line.
   procedure Refuse (From : Reader; Message : String) with No_Return;

   --  Refuses it at an earlier one.
   procedure Refuse (From : Reader; Line : Positive; Message : String)
     with No_Return;

   --  The file is closed at the latest when the reader is finalized.
   procedure Close (From : in out Reader);

   --  Without the blanks and tabulators at both ends.
   function Trimmed (Text : String) return String;

private

   use Ada.Strings.Unbounded;
   use GNAT.OS_Lib;

   Block_Length : constant := 65_536;

   type Reader is new Ada.Finalization.Limited_Controlled with record
      File        : File_Descriptor := Invalid_FD;
      Name        : Unbounded_String;
      Number      : Natural := 0;
      Block       : String (1 .. Block_Length);
      Next        : Positive := 1;
      Last        : Natural  := 0;
      Text        : String (1 .. Longest_Line + 1);
      Text_Length : Natural  := 0;
   end record;

   overriding procedure Finalize (From : in out Reader);

   function Line_Number (From : Reader) return Positive is
     (Positive'Max (From.Number, 1));

   function Line (From : Reader) return String is
     (From.Text (1 .. From.Text_Length));

end Host.Text_Input;
