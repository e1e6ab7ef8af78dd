--  SPDX-License-Identifier: Apache-2.0

with Ada.Text_IO; use Ada.Text_IO;

package body Live_Results is

   --  Writes the result before the next test begins.
   procedure Put_Result (Outcome : String; Test_Name : Message_String);

   --  The number as a numeral without a leading blank.
   function Image (Number : Natural) return String;

   function Image (Number : Natural) return String is
      Text : constant String := Number'Image;
   begin
      return Text (Text'First + 1 .. Text'Last);
   end Image;

   procedure Put_Result (Outcome : String; Test_Name : Message_String) is
   begin
      Put_Line (Outcome & " " & Test_Name.all);
      Flush;
   end Put_Result;

   overriding procedure Add_Success
     (R            : in out Live_Result;
      Test_Name    : Message_String;
      Routine_Name : Message_String;
      Elapsed      : Time)
   is
   begin
      Put_Result ("ok  ", Test_Name);
      Result (R).Add_Success (Test_Name, Routine_Name, Elapsed);
   end Add_Success;

   overriding procedure Add_Failure
     (R            : in out Live_Result;
      Test_Name    : Message_String;
      Routine_Name : Message_String;
      Failure      : Test_Failure;
      Elapsed      : Time)
   is
   begin
      Put_Result ("FAIL", Test_Name);
      Put_Line
        ("     " & Failure.Source_Name.all & ":" & Image (Failure.Line)
         & ": " & Failure.Message.all);
      Result (R).Add_Failure (Test_Name, Routine_Name, Failure, Elapsed);
   end Add_Failure;

   overriding procedure Add_Error
     (R            : in out Live_Result;
      Test_Name    : Message_String;
      Routine_Name : Message_String;
      Error        : Test_Error;
      Elapsed      : Time)
   is
   begin
      Put_Result ("FAIL", Test_Name);
      Put_Line ("     raised " & Error.Exception_Name.all);
      if Error.Exception_Message /= null then
         Put_Line ("     " & Error.Exception_Message.all);
      end if;
      Result (R).Add_Error (Test_Name, Routine_Name, Error, Elapsed);
   end Add_Error;

   overriding procedure Report
     (Engine  : Totals_Reporter;
      R       : in out Result'Class;
      Options : AUnit.Options.AUnit_Options := AUnit.Options.Default_Options)
   is
      pragma Unreferenced (Engine, Options);
      Failed : constant Natural :=
        Natural (R.Failure_Count) + Natural (R.Error_Count);
   begin
      Put_Line
        (Image (Natural (R.Success_Count)) & " passed, "
         & Image (Failed) & " failed, 0 skipped");
   end Report;

end Live_Results;
