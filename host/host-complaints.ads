--  SPDX-License-Identifier: Apache-2.0

--  What the program says when it refuses a command line or an input file,
--  in one style and on one line.
--
--  An exception's message ends after 200 characters, which a long path
--  soon fills. The whole line is therefore kept here until it is printed.

with Ada.Exceptions;

package Host.Complaints is

   --  Refuses the command line. The line is "urv_sim: What", with
   --  the name of the program that runs.
   procedure Refuse (What : String) with No_Return;

   --  Prints "urv_sim: What" on standard error, should anybody read it, and
   --  goes on.
   procedure Report (What : String);

   --  Refuses an input file. The line is "File:Line: What".
   procedure Refuse (File : String; Line : Positive; What : String)
     with No_Return;

   --  The line that belongs to this occurrence of Bad_Input. A message
   --  that was raised without Refuse gets the program's name in front.
   function Line_Of (Error : Ada.Exceptions.Exception_Occurrence)
                     return String;

   --  Prints that line on standard error, byte for byte: a file's name
   --  need not be text in any encoding.
   procedure Print (Error : Ada.Exceptions.Exception_Occurrence);

   --  With what the program then ends.
   Exit_Status : constant := 2;

   --  Text of the user's in quotes, fit for one line: control characters
   --  are replaced and the rest of a long text is cut off.
   function Quoted (Text : String) return String;

end Host.Complaints;
