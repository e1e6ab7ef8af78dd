--  SPDX-License-Identifier: Apache-2.0

--  Writes an output file in large blocks. The flight record and the wire log
--  take most of the time of a fast simulation, so this package formats numbers
--  itself.
--
--  A writer is open only if its output was requested. Host.Outputs opens all
--  those of a flight.
--
--  An output that cannot be written never ends the program (SIM-8): the writer
--  reports it in a line on standard error, closes the file, and drops later
--  output. The writer stays open, and is lost.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;

with Host.Text_Numbers;

package Host.Text_Output is

   type Writer is limited private;

   --  The interval at which buffered output goes to the files. A killed
   --  program loses no more than this (SIM-1, GND-4).
   Flush_Interval : constant := Microseconds_Per_Second;

   Most_Decimals : constant := 6;

   function Is_Open (To : Writer) return Boolean with Inline;

   --  Takes over a file that is open for writing. Complaints name the output
   --  by its title. Is_Rewritten: it is a regular file that holds nothing
   --  else, so that Restart may be called.
   procedure Attach
     (To           : in out Writer;
      File         : GNAT.OS_Lib.File_Descriptor;
      Title        : String;
      Is_Rewritten : Boolean := False)
     with Pre => not Is_Open (To), Post => Is_Open (To);

   --  Keeps output, up to Block_Length characters, until Clear; for a task
   --  that must not wait for a disk.
   procedure Attach_Memory (To : in out Writer)
     with Pre => not Is_Open (To), Post => Is_Open (To);

   --  The text of a memory writer since Clear.
   function Text (To : Writer) return String
     with Pre => Is_Open (To);
   procedure Clear (To : in out Writer)
     with Pre => Is_Open (To);

   --  Another descriptor of the program's standard output or standard error:
   --  closing it leaves the program's own open.
   function Screen (Is_Error : Boolean := False)
                    return GNAT.OS_Lib.File_Descriptor;

   procedure Attach_Screen (To : in out Writer; Is_Error : Boolean := False)
     with Pre => not Is_Open (To), Post => Is_Open (To);

   --  The output has failed; the system's reason; the output was a pipe
   --  without a reader. A closed writer keeps this information.
   function Is_Lost (To : Writer) return Boolean with Inline;
   function Loss (To : Writer) return String
     with Pre => Is_Lost (To);
   function Is_Unread (To : Writer) return Boolean with Inline;

   --  True if any output of this program has been lost.
   function Any_Lost return Boolean;

   procedure Put (To : in out Writer; Char : Character)
     with Inline, Pre => Is_Open (To);
   procedure Put (To : in out Writer; Text : String)
     with Pre => Is_Open (To);
   procedure Put (To : in out Writer; Value : Text_Numbers.Number)
     with Pre => Is_Open (To);
   procedure New_Line (To : in out Writer)
     with Inline, Pre => Is_Open (To);

   --  Puts the text and the end of the line.
   procedure Put_Line (To : in out Writer; Text : String)
     with Pre => Is_Open (To);

   --  A rounded number with that number of decimals; "nan" for not-a-number.
   procedure Put
     (To       : in out Writer;
      Value    : Long_Float;
      Decimals : Positive)
     with Pre => Is_Open (To) and then Decimals <= Most_Decimals;

   --  Writes the buffered output; the file stays open. Ends early when the
   --  file cannot be written.
   procedure Flush (To : in out Writer)
     with Pre => Is_Open (To);

   --  Waits until the written text is on the disk (FTI-11). An output that is
   --  no file on a disk, such as a pipe, needs no wait.
   procedure Synchronise (To : in out Writer);

   --  True if the file can be rewritten from its beginning.
   function Can_Restart (To : Writer) return Boolean
     with Pre => Is_Open (To);

   --  The next output replaces all earlier output.
   procedure Restart (To : in out Writer)
     with Pre => Is_Open (To) and then Can_Restart (To);

   --  Writes the rest of a version. The file then holds that version only.
   procedure End_Version (To : in out Writer)
     with Pre => Is_Open (To);

   --  Writes the buffered output and closes the file.
   procedure Close (To : in out Writer)
     with Post => not Is_Open (To);

private

   Block_Length : constant := 65_536;

   type Writer_State is (Closed, Written, In_Memory, Lost);

   type Writer is limited record
      State : Writer_State := Closed;
      File  : GNAT.OS_Lib.File_Descriptor := GNAT.OS_Lib.Invalid_FD;
      Title : Unbounded_String;

      --  The system's error of a lost output.
      Error : Integer := 0;

      Block : String (1 .. Block_Length);
      Last  : Natural range 0 .. Block_Length := 0;

      --  The length of the file's present version, and the longest before.
      Is_Rewritten : Boolean           := False;
      Length       : Long_Long_Integer := 0;
      Longest      : Long_Long_Integer := 0;
   end record;

   function Is_Open (To : Writer) return Boolean is (To.State /= Closed);

   function Is_Lost (To : Writer) return Boolean is (To.Error /= 0);

   Broken_Pipe : constant := 32;

   function Is_Unread (To : Writer) return Boolean is
     (To.Error = Broken_Pipe);

   function Text (To : Writer) return String is (To.Block (1 .. To.Last));

   function Can_Restart (To : Writer) return Boolean is (To.Is_Rewritten);

end Host.Text_Output;
