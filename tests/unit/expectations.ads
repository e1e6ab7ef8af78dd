--  SPDX-License-Identifier: Apache-2.0

--  How a test says what it expects. Tests of a type of their own instantiate
--  Expect_Value.

with GNAT.Source_Info;

with Expect_Value;
with URVOS;        use URVOS;
with URVOS.Frames; use URVOS.Frames;

package Expectations is

   --  Words that a test takes one after the other.
   type Word_List is array (Positive range <>) of Word;

   procedure Expect is new Expect_Value (Word);
   procedure Expect is new Expect_Value (Byte);
   procedure Expect is new Expect_Value (Count);
   procedure Expect is new Expect_Value (Tick);
   procedure Expect is new Expect_Value (Boolean);

   --  Lengths, positions and other plain numbers.
   procedure Expect_Number is new Expect_Value (Integer);

   --  That something raises an exception, a contract for one: Action is
   --  expected not to return.
   procedure Expect_Refusal
     (What   : String;
      Action : not null access procedure;
      Source : String   := GNAT.Source_Info.File;
      Line   : Positive := GNAT.Source_Info.Line);

   --  What is done many times is done less often where contracts take a
   --  hundred times as long as the rest.
   function Contracts_Are_Executed return Boolean;

end Expectations;
