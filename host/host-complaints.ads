--  SPDX-License-Identifier: Apache-2.0

--  The messages with which the program refuses a command line or an input
--  file: one style, one line each.
--
--  An exception's message is cut after 200 characters, which a long path soon
--  fills. The whole line is therefore kept here until it is printed.

with Ada.Exceptions;

package Host.Complaints is

   --  Refuses the command line. The line is "urv_sim: What", with the name of
   --  the running program.
   procedure Refuse (Message : String) with No_Return;

   --  Prints "urv_sim: What" on standard error and continues, even if nothing
   --  reads it.
   procedure Report (Message : String);

   --  Refuses an input file. The line is "File:Line: What".
   procedure Refuse (File : String; Line : Positive; Message : String)
     with No_Return;

   --  The line that belongs to this occurrence of Bad_Input. A message raised
   --  without Refuse gets the program's name in front.
   function Line_Of (Error : Ada.Exceptions.Exception_Occurrence)
                     return String;

   --  Prints that line on standard error, byte for byte: a file's name need
   --  not be valid in any encoding.
   procedure Print (Error : Ada.Exceptions.Exception_Occurrence);

   --  The exit status of a program that refuses its input.
   Exit_Status : constant := 2;

   --  User text in quotes, fit for one line: control characters are replaced
   --  and a long text is cut.
   function Quoted (Text : String) return String;

end Host.Complaints;
