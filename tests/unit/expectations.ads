--  SPDX-License-Identifier: Apache-2.0

--  The expectations of tests. Tests of a type of their own instantiate
--  Expect_Value.

with GNAT.Source_Info;

with Expect_Value;
with URVOS;        use URVOS;
with URVOS.Frames; use URVOS.Frames;

package Expectations is

   --  Words that a test takes in order.
   type Word_List is array (Positive range <>) of Word;

   procedure Expect is new Expect_Value (Word);
   procedure Expect is new Expect_Value (Byte);
   procedure Expect is new Expect_Value (Count);
   procedure Expect is new Expect_Value (Tick);
   procedure Expect is new Expect_Value (Boolean);

   --  Lengths, positions and other plain numbers.
   procedure Expect_Number is new Expect_Value (Integer);

   --  Expects that Action raises an exception, for example by a contract, and
   --  does not return.
   procedure Expect_Refusal
     (What   : String;
      Action : not null access procedure;
      Source : String   := GNAT.Source_Info.File;
      Line   : Positive := GNAT.Source_Info.Line);

   --  Contracts take a hundred times as long as the code. Tests with many
   --  repetitions make fewer where contracts are executed.
   function Contracts_Are_Executed return Boolean;

end Expectations;
