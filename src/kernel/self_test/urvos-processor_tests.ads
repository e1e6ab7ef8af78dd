--  SPDX-License-Identifier: Apache-2.0

--  The processor's tests, as far as an Ada program can express them (report,
--  2.4; TST-2). docs/self-test.md lists the faults that each finds.
--
--  A compiler evaluates known expressions itself. Each test therefore works on
--  operands from another unit, which is compiled apart. Functions that are not
--  expanded in line compare the results, since the first comparison would
--  disclose the operand. The compiled code thus contains real instructions;
--  the compiler chooses which.

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

   --  Runs one test. A processor that follows Ada's rules passes all tests.
   --  With other operands a test may fail; this shows that it does compare.
   function Passes (Test : Processor_Test; Given : Operands) return Boolean
   with
     No_Inline,
     Global => null,
     Post   => (if Given = Known_Operands then Passes'Result);

end URVOS.Processor_Tests;
