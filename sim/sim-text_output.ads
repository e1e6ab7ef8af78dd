--  Writes an output file in large blocks. The flight record and the wire
--  log of a fast simulation are most of what it has to do, so numbers are
--  formatted by hand.
--
--  A writer is open only if its output was asked for. Sim.Outputs opens
--  all of a flight.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;

with Sim.Text_Numbers;

package Sim.Text_Output is

   type Writer is limited private;

   function Is_Open (To : Writer) return Boolean with Inline;

   --  Takes over a file that is open for writing. The title says in a
   --  complaint which output it is.
   procedure Attach
     (To    : in out Writer;
      File  : GNAT.OS_Lib.File_Descriptor;
      Title : String)
     with Pre => not Is_Open (To), Post => Is_Open (To);

   --  Each raises Bad_Input when the file cannot be written.
   procedure Put (To : in out Writer; Char : Character)
     with Inline, Pre => Is_Open (To);
   procedure Put (To : in out Writer; Text : String)
     with Pre => Is_Open (To);
   procedure Put (To : in out Writer; Value : Text_Numbers.Number)
     with Pre => Is_Open (To);
   procedure New_Line (To : in out Writer)
     with Inline, Pre => Is_Open (To);

   --  Writes what is left and closes the file.
   procedure Close (To : in out Writer)
     with Post => not Is_Open (To);

private

   use type GNAT.OS_Lib.File_Descriptor;

   Block_Length : constant := 65_536;

   type Writer is limited record
      File  : GNAT.OS_Lib.File_Descriptor := GNAT.OS_Lib.Invalid_FD;
      Title : Unbounded_String;
      Block : String (1 .. Block_Length);
      Last  : Natural range 0 .. Block_Length := 0;
   end record;

   function Is_Open (To : Writer) return Boolean is
     (To.File /= GNAT.OS_Lib.Invalid_FD);

end Sim.Text_Output;
