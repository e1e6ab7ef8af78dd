--  SPDX-License-Identifier: Apache-2.0

--  Writes an output file in large blocks. The flight record and the wire
--  log of a fast simulation are most of what it has to do, so numbers are
--  formatted by hand.
--
--  A writer is open only if its output was asked for. Host.Outputs opens
--  all of a flight.
--
--  An output that cannot be written never ends the program (SIM-8): the
--  writer reports it in a line on standard error, closes the file, and drops
--  what comes after. The writer stays open, and is lost.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;

with Host.Text_Numbers;

package Host.Text_Output is

   type Writer is limited private;

   --  How often what has been written so far goes to the files, so that a
   --  program that is killed loses no more of it (SIM-1, GND-4).
   Flush_Interval : constant := Microseconds_Per_Second;

   Most_Decimals : constant := 6;

   function Is_Open (To : Writer) return Boolean with Inline;

   --  Takes over a file that is open for writing. The title says in a
   --  complaint which output it is. Is_Rewritten: the file is a regular one
   --  and holds nothing else, so that Restart may be called.
   procedure Attach
     (To           : in out Writer;
      File         : GNAT.OS_Lib.File_Descriptor;
      Title        : String;
      Is_Rewritten : Boolean := False)
     with Pre => not Is_Open (To), Post => Is_Open (To);

   --  Keeps what is put, up to Block_Length characters, until Clear; for a
   --  task that may not wait for a disk.
   procedure Attach_Memory (To : in out Writer)
     with Pre => not Is_Open (To), Post => Is_Open (To);

   --  What a writer to memory has been given since Clear.
   function Text (To : Writer) return String
     with Pre => Is_Open (To);
   procedure Clear (To : in out Writer)
     with Pre => Is_Open (To);

   --  Another descriptor of the program's standard output or standard
   --  error, so that closing it leaves the program's.
   function Screen (Is_Error : Boolean := False)
                    return GNAT.OS_Lib.File_Descriptor;

   procedure Attach_Screen (To : in out Writer; Is_Error : Boolean := False)
     with Pre => not Is_Open (To), Post => Is_Open (To);

   --  Whether the file could not be written, why, in the system's words, and
   --  whether because it is a pipe that nobody reads any more. A writer that
   --  was closed keeps it.
   function Is_Lost (To : Writer) return Boolean with Inline;
   function Loss (To : Writer) return String
     with Pre => Is_Lost (To);
   function Is_Unread (To : Writer) return Boolean with Inline;

   --  Whether any output of this program has been lost.
   function Any_Lost return Boolean;

   procedure Put (To : in out Writer; Char : Character)
     with Inline, Pre => Is_Open (To);
   procedure Put (To : in out Writer; Text : String)
     with Pre => Is_Open (To);
   procedure Put (To : in out Writer; Value : Text_Numbers.Number)
     with Pre => Is_Open (To);
   procedure New_Line (To : in out Writer)
     with Inline, Pre => Is_Open (To);

   --  The text, then the end of the line.
   procedure Put_Line (To : in out Writer; Text : String)
     with Pre => Is_Open (To);

   --  A number with so many decimals, rounded; "nan" for what is none.
   procedure Put
     (To       : in out Writer;
      Value    : Long_Float;
      Decimals : Positive)
     with Pre => Is_Open (To) and then Decimals <= Most_Decimals;

   --  Writes what is left; the file stays open. Ends early when the file
   --  cannot be written.
   procedure Flush (To : in out Writer)
     with Pre => Is_Open (To);

   --  Whether the file can be written again from its beginning.
   function Can_Restart (To : Writer) return Boolean
     with Pre => Is_Open (To);

   --  What comes next takes the place of all that was written before.
   procedure Restart (To : in out Writer)
     with Pre => Is_Open (To) and then Can_Restart (To);

   --  Writes what is left of a version; where the one before was longer,
   --  blanks take its place.
   procedure End_Version (To : in out Writer)
     with Pre => Is_Open (To);

   --  Writes what is left and closes the file.
   procedure Close (To : in out Writer)
     with Post => not Is_Open (To);

private

   Block_Length : constant := 65_536;

   type Writer_State is (Closed, Written, In_Memory, Lost);

   type Writer is limited record
      State : Writer_State := Closed;
      File  : GNAT.OS_Lib.File_Descriptor := GNAT.OS_Lib.Invalid_FD;
      Title : Unbounded_String;

      --  Of a lost one: the system's error.
      Error : Integer := 0;

      Block : String (1 .. Block_Length);
      Last  : Natural range 0 .. Block_Length := 0;

      --  How long the file's present version is, and the longest before.
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
