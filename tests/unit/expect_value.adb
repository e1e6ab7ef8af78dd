--  SPDX-License-Identifier: Apache-2.0

with AUnit.Assertions; use AUnit.Assertions;

procedure Expect_Value
  (What             : String;
   Actual, Expected : Value;
   Source           : String   := GNAT.Source_Info.File;
   Line             : Positive := GNAT.Source_Info.Line)
is
   function Numeral (Item : Value) return String;

   function Numeral (Item : Value) return String is
      Image : constant String := Value'Image (Item);
   begin
      return (if Image (1) = ' ' then Image (2 .. Image'Last) else Image);
   end Numeral;

begin
   --  The message is made only when needed, since some tests expect millions
   --  of values.
   if Actual /= Expected then
      Assert
        (False,
         What & ": " & Numeral (Actual) & ", expected " & Numeral (Expected),
         Source, Line);
   end if;
end Expect_Value;
