--  SPDX-License-Identifier: Apache-2.0

--  The parts of the self-test and its result (report, 2.4; TST-1, TST-2,
--  TST-4). The numbers are the report's.

with URVOS.Memories; use URVOS.Memories;

package URVOS.Self_Tests with Pure, SPARK_Mode is

   --  Floating point is tested only if it is used; this software uses none.
   type Test_Name is
     (ROM, RAM, Data_Movement, Arithmetic, Floating_Point, Logical,
      Shift_And_Rotate, Bit_Manipulation, Program_Control, Addressing,
      Test_And_Set, Registers);

   --  Failed has a meaning only if a test failed, and Where only if the RAM's
   --  did. Otherwise both have their first value.
   type Test_Result is record
      Passed : Boolean      := True;
      Failed : Test_Name    := ROM;
      Where  : Word_Address := 0;
   end record;

   All_Passed : constant Test_Result := (others => <>);

   function Failure
     (Of_Test : Test_Name;
      Where   : Word_Address := 0) return Test_Result
   is ((Passed => False, Failed => Of_Test, Where => Where))
   with Global => null;

   --  The result as one word of CORE memory: 0 if all tests passed. Otherwise
   --  the high four bits hold the test's number. The low twelve hold the
   --  failing RAM word's block of 16 words, FFFh for the last block that fits
   --  and all later ones.

   Words_Per_Block : constant := 16;

   Last_Block : constant := 16#FFF#;

   function Test_Number (Name : Test_Name) return Word is
     (Word (Test_Name'Pos (Name)) + 1)
   with Global => null;

   function Block_Of (Where : Word_Address) return Word is
     (Word (Word_Address'Min (Where / Words_Per_Block, Last_Block)))
   with Global => null;

   function To_Word (Result : Test_Result) return Word is
     (if Result.Passed then 0
      else Test_Number (Result.Failed) * 16#1000# + Block_Of (Result.Where))
   with
     Global => null,
     Post   =>
       (To_Word'Result = 0) = Result.Passed
       and then
         (if not Result.Passed
          then To_Word'Result / 16#1000# = Test_Number (Result.Failed)
            and then To_Word'Result mod 16#1000# = Block_Of (Result.Where));

end URVOS.Self_Tests;
