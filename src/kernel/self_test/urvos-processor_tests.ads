--  SPDX-License-Identifier: Apache-2.0

--  The tests of the processor, as far as an Ada program can state them
--  (report, 2.4; TST-2). docs/self-test.md says what each would find.
--
--  A compiler computes at once what it knows. So each test works on operands
--  that it is given by another unit, and units are compiled one by one; and
--  results are compared by functions that are not expanded in line, since
--  the first comparison would tell the compiler the operand. The
--  instructions are really there; which ones is the compiler's choice.

with URVOS.Self_Tests; use URVOS.Self_Tests;

package URVOS.Processor_Tests with Pure, SPARK_Mode is

   type Operand_Name is
     (Zero, One, Seven, Thousand, Ones, Pattern, Stripes);

   type Operands is array (Operand_Name) of Word;

   Known_Operands : constant Operands :=
     (Zero     => 0,
      One      => 1,
      Seven    => 7,
      Thousand => 1_000,
      Ones     => 16#FFFF#,
      Pattern  => 16#A5C3#,
      Stripes  => 16#0FF0#);

   subtype Processor_Test is Test_Name range Data_Movement .. Registers;

   --  Runs one test. A processor that does what Ada says passes them all;
   --  with other operands a test may fail, so that it can be seen to look.
   function Passes (Test : Processor_Test; Given : Operands) return Boolean
   with
     No_Inline,
     Global => null,
     Post   => (if Given = Known_Operands then Passes'Result);

end URVOS.Processor_Tests;
