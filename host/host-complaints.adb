--  SPDX-License-Identifier: Apache-2.0

with Ada.Command_Line;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;

package body Host.Complaints is

   --  A path without its folders.
   function Last_Name (Path : String) return String;

   function Last_Name (Path : String) return String is
      First : Positive := Path'First;
   begin
      for Place in Path'Range loop
         if Path (Place) = '/' and then Place < Path'Last then
            First := Place + 1;
         end if;
      end loop;
      return Path (First .. Path'Last);
   end Last_Name;

   Program : constant String :=
     Last_Name (Ada.Command_Line.Command_Name) & ": ";

   --  The first complaint, whole.
   First : Unbounded_String;

   procedure Complain (Line : String) with No_Return;

   --  In one write, so that lines of two tasks do not mix.
   procedure Print_Line (Text : String);

   procedure Complain (Line : String) is
   begin
      --  Later complaints, while the program exits, are not reported.
      if First = Null_Unbounded_String then
         First := To_Unbounded_String (Line);
      end if;
      raise Bad_Input with Line;
   end Complain;

   procedure Refuse (Message : String) is
   begin
      Complain (Program & Message);
   end Refuse;

   procedure Report (Message : String) is
   begin
      Print_Line (Program & Message);
   end Report;

   procedure Refuse (File : String; Line : Positive; Message : String) is
      Number : constant String := Line'Image;
   begin
      Complain
        (File & ":" & Number (Number'First + 1 .. Number'Last)
         & ": " & Message);
   end Refuse;

   function Line_Of (Error : Ada.Exceptions.Exception_Occurrence)
                     return String
   is
      Message : constant String := Ada.Exceptions.Exception_Message (Error);
   begin
      if Message'Length > 0
        and then Message'Length <= Length (First)
        and then Head (First, Message'Length) = Message
      then
         return To_String (First);
      else
         return Program & Message;
      end if;
   end Line_Of;

   procedure Print (Error : Ada.Exceptions.Exception_Occurrence) is
   begin
      Print_Line (Line_Of (Error));
   end Print;

   procedure Print_Line (Text : String) is
      Line    : constant String := Text & ASCII.LF;
      Written : Integer;
   begin
      Written :=
        GNAT.OS_Lib.Write
          (GNAT.OS_Lib.Standerr, Line'Address, Line'Length);

      --  A failed write to standard error cannot be reported anywhere.
      pragma Unreferenced (Written);
   end Print_Line;

   function Quoted (Text : String) return String is
      Longest : constant := 60;
      Shown   : String :=
        (if Text'Length <= Longest
         then Text
         else Text (Text'First .. Text'First + Longest - 1) & "...");
   begin
      for Char of Shown loop
         if Char < ' ' or else Char = ASCII.DEL then
            Char := '?';
         end if;
      end loop;
      return '"' & Shown & '"';
   end Quoted;

end Host.Complaints;
