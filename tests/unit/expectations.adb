--  SPDX-License-Identifier: Apache-2.0

with AUnit.Assertions; use AUnit.Assertions;

package body Expectations is

   function Contracts_Are_Executed return Boolean is
      Executed : Boolean := False;

      --  An assertion that records its own evaluation.
      function Noted return Boolean;

      function Noted return Boolean is
      begin
         Executed := True;
         return True;
      end Noted;
   begin
      pragma Assert (Noted);
      return Executed;
   end Contracts_Are_Executed;

   procedure Expect_Refusal
     (What   : String;
      Action : not null access procedure;
      Source : String   := GNAT.Source_Info.File;
      Line   : Positive := GNAT.Source_Info.Line)
   is
      Refused : Boolean := False;
   begin
      begin
         Action.all;
      exception
         when others =>
            Refused := True;
      end;
      Assert (Refused, What & ": accepted, expected a refusal", Source, Line);
   end Expect_Refusal;

end Expectations;
