--  SPDX-License-Identifier: Apache-2.0

with Interfaces;

package body URVOS.Processor_Tests with SPARK_Mode is

   type Long is new Interfaces.Unsigned_32;

   --  The tests by name; see docs/self-test.md. The expected numbers are
   --  computed by hand from the known operands.

   function Data_Movement_Passes (Given : Operands) return Boolean
   with Post => (if Given = Known_Operands then Data_Movement_Passes'Result);

   function Arithmetic_Passes (Given : Operands) return Boolean
   with Post => (if Given = Known_Operands then Arithmetic_Passes'Result);

   function Logical_Passes (Given : Operands) return Boolean
   with Post => (if Given = Known_Operands then Logical_Passes'Result);

   function Shift_And_Rotate_Passes (Given : Operands) return Boolean
   with
     Post => (if Given = Known_Operands then Shift_And_Rotate_Passes'Result);

   function Bit_Manipulation_Passes (Given : Operands) return Boolean
   with
     Post => (if Given = Known_Operands then Bit_Manipulation_Passes'Result);

   function Program_Control_Passes (Given : Operands) return Boolean
   with
     Post => (if Given = Known_Operands then Program_Control_Passes'Result);

   function Addressing_Passes (Given : Operands) return Boolean
   with Post => (if Given = Known_Operands then Addressing_Passes'Result);

   function Test_And_Set_Passes (Given : Operands) return Boolean
   with Post => (if Given = Known_Operands then Test_And_Set_Passes'Result);

   function Registers_Pass (Given : Operands) return Boolean
   with Post => (if Given = Known_Operands then Registers_Pass'Result);

   --  Comparisons that the compiler cannot see through. Otherwise the first
   --  comparison would fix the operand, and the compiler would compute the
   --  rest itself.

   function Is_Same (Actual, Expected : Long) return Boolean is
     (Actual = Expected)
   with No_Inline;

   function Is_Same (Actual, Expected : Word) return Boolean is
     (Actual = Expected)
   with No_Inline;

   function Is_Same (Actual, Expected : Byte) return Boolean is
     (Actual = Expected)
   with No_Inline;

   function Is_Same (Actual, Expected : Integer) return Boolean is
     (Actual = Expected)
   with No_Inline;

   --  Two words as one of 32 bits.
   function Joined (High, Low : Word) return Long is
     (Long (High) * 16#1_0000# + Long (Low));

   function Data_Movement_Passes (Given : Operands) return Boolean is
      Copy   : constant Operands := Given;
      Moved  : Word := Given (Pattern);
      Left   : Byte := Byte (Moved / 256);
      Right  : Byte := Byte (Moved mod 256);
      Middle : Byte;
   begin
      --  Bytes, words and longs between variables, and from one size to
      --  another.
      Middle := Left;
      Left := Right;
      Right := Middle;
      Moved := Word (Left) * 256 + Word (Right);

      return Is_Same (Copy (Zero), 0)
        and then Is_Same (Copy (One), 1)
        and then Is_Same (Copy (Seven), 7)
        and then Is_Same (Copy (Thousand), 1_000)
        and then Is_Same (Copy (Ones), 16#FFFF#)
        and then Is_Same (Copy (Pattern), 16#A5C3#)
        and then Is_Same (Copy (Stripes), 16#0FF0#)
        and then Is_Same (Left, 16#C3#)
        and then Is_Same (Right, 16#A5#)
        and then Is_Same (Moved, 16#C3A5#)
        and then Is_Same (Joined (Moved, Copy (Stripes)), 16#C3A5_0FF0#);
   end Data_Movement_Passes;

   function Arithmetic_Passes (Given : Operands) return Boolean is
      --  Limited to 14 bits, so that no product overflows.
      Few     : constant Integer := Integer (Given (Seven) and 16#3FFF#);
      Many    : constant Integer := Integer (Given (Thousand) and 16#3FFF#);
      All_One : constant Word := Given (Ones);
   begin
      --  A defect that yields zero for seven must not divide by zero.
      if Few = 0 then
         return False;
      end if;

      return Is_Same (Given (Thousand) + Given (Seven), 1_007)
        and then Is_Same (Given (Thousand) - Given (Seven), 993)
        and then Is_Same (Given (Thousand) * Given (Seven), 7_000)
        and then Is_Same (Given (Thousand) / Word (Few), 142)
        and then Is_Same (Given (Thousand) mod Word (Few), 6)

        --  Carry and borrow, within a word and beyond it.
        and then Is_Same (All_One + Given (One), 0)
        and then Is_Same (Given (Zero) - Given (One), 16#FFFF#)
        and then Is_Same (Long (All_One) + Long (Given (One)), 16#1_0000#)
        and then Is_Same (Long (All_One) * Long (All_One), 16#FFFE_0001#)
        and then Is_Same
          (Long (Given (Zero)) - Long (Given (One)), 16#FFFF_FFFF#)

        --  With signs
        and then Is_Same (-Many - Few, -1_007)
        and then Is_Same (Few - Many, -993)
        and then Is_Same ((-Many) * Few, -7_000)
        and then Is_Same ((-Many) / Few, -142)
        and then Is_Same ((-Many) rem Few, -6)
        and then Is_Same ((-Many) mod Few, 1)
        and then Is_Same (abs (-Many), 1_000);
   end Arithmetic_Passes;

   function Logical_Passes (Given : Operands) return Boolean is
      Left  : constant Word := Given (Pattern);
      Right : constant Word := Given (Stripes);
   begin
      return Is_Same (Left and Right, 16#05C0#)
        and then Is_Same (Left or Right, 16#AFF3#)
        and then Is_Same (Left xor Right, 16#AA33#)
        and then Is_Same (not Left, 16#5A3C#)
        and then Is_Same (Left and Given (Zero), 0)
        and then Is_Same (Left and Given (Ones), 16#A5C3#)
        and then Is_Same (Left or Given (Ones), 16#FFFF#)
        and then Is_Same (Left xor Given (Ones), 16#5A3C#)
        and then
          Is_Same
            (Joined (Left, Right) and Joined (Right, Left), 16#05C0_05C0#)
        and then
          Is_Same
            (Joined (Left, Right) xor Joined (Right, Left), 16#AA33_AA33#);
   end Logical_Passes;

   function Shift_And_Rotate_Passes (Given : Operands) return Boolean is
      Item   : constant Word := Given (Pattern);
      Little : constant Byte := Byte (Item mod 256);
   begin
      return Is_Same (Shift_Left (Item, 1), 16#4B86#)
        and then Is_Same (Shift_Right (Item, 1), 16#52E1#)
        and then Is_Same (Rotate_Left (Item, 1), 16#4B87#)
        and then Is_Same (Rotate_Right (Item, 1), 16#D2E1#)
        and then Is_Same (Shift_Right_Arithmetic (Item, 1), 16#D2E1#)
        and then Is_Same (Shift_Left (Item, 4), 16#5C30#)
        and then Is_Same (Shift_Right (Item, 4), 16#0A5C#)
        and then Is_Same (Rotate_Left (Item, 4), 16#5C3A#)
        and then Is_Same (Rotate_Right (Item, 4), 16#3A5C#)
        and then Is_Same (Rotate_Left (Item, 8), 16#C3A5#)
        and then Is_Same (Shift_Left (Item, 15), 16#8000#)
        and then Is_Same (Shift_Right (Item, 15), 1)
        and then Is_Same (Shift_Right_Arithmetic (Item, 15), 16#FFFF#)
        and then Is_Same (Shift_Left (Little, 1), 16#86#)
        and then Is_Same (Shift_Right (Little, 1), 16#61#)
        and then Is_Same (Rotate_Left (Little, 1), 16#87#)
        and then Is_Same (Rotate_Right (Little, 1), 16#E1#);
   end Shift_And_Rotate_Passes;

   function Bit_Manipulation_Passes (Given : Operands) return Boolean is
      Set     : Word := Given (Zero);
      Cleared : Word := Given (Ones);
      Changed : Word := Given (Pattern);
      Seen    : Word := Given (Zero);
      Mask    : Word;
   begin
      for Bit in 0 .. 15 loop
         Mask := Shift_Left (Given (One), Bit);
         Set := Set or Mask;
         Cleared := Cleared and not Mask;
         Changed := Changed xor Mask;
         if (Given (Pattern) and Mask) /= 0 then
            Seen := Seen + Mask;
         end if;
      end loop;

      return Is_Same (Set, 16#FFFF#)
        and then Is_Same (Cleared, 0)
        and then Is_Same (Changed, 16#5A3C#)
        and then Is_Same (Seen, 16#A5C3#);
   end Bit_Manipulation_Passes;

   function Program_Control_Passes (Given : Operands) return Boolean is

      --  A call that contains a choice.
      function Chosen (Selector : Word) return Word is
        (case Selector and 3 is
            when 0      => 11,
            when 1      => 23,
            when 2      => 37,
            when others => 53)
      with No_Inline;

      Trace    : Word := Given (Zero);
      Selector : Word;
   begin
      for Round in 0 .. 7 loop
         Selector := Shift_Right (Given (Pattern), 2 * Round) and 3;
         Trace := Trace * 3 + Chosen (Selector);
         if Selector /= 3 then
            if Trace > 16#8000# then
               Trace := Trace xor 16#1234#;
            elsif Trace < 100 then
               Trace := Trace + Given (Thousand);
            end if;
         end if;
      end loop;
      return Trace = 16#2CFC#;
   end Program_Control_Passes;

   function Addressing_Passes (Given : Operands) return Boolean is

      type Small is range 0 .. 3;
      type Row is array (Small) of Word;
      type Square is array (Small) of Row;

      type Pair is record
         First, Second : Word;
      end record;

      --  Exchanges two variables through their addresses.
      procedure Exchange (Left, Right : in out Word)
      with
        No_Inline,
        Post => Left = Right'Old and then Right = Left'Old;

      procedure Exchange (Left, Right : in out Word) is
         Kept : constant Word := Left;
      begin
         Left := Right;
         Right := Kept;
      end Exchange;

      Index  : constant Small := Small (Given (Seven) mod 4);
      Table  : Square := (others => (others => Given (Zero)));
      Couple : Pair := (First => Given (One), Second => Given (Seven));
   begin
      --  Constant and computed indices, forwards and backwards.
      Table (0) (1) := Given (Seven);
      Table (Index) (Index) := Given (Pattern);
      Table (3 - Index) (Index) := Given (Stripes);
      Table (Index) (3 - Index) := Given (Thousand);
      Exchange (Table (0) (1), Table (Index) (0));
      Exchange (Couple.First, Couple.Second);

      return Is_Same (Table (0) (1), 1_000)
        and then Is_Same (Table (3) (0), 7)
        and then Is_Same (Table (3) (3), 16#A5C3#)
        and then Is_Same (Table (0) (3), 16#0FF0#)
        and then Is_Same (Table (1) (2), 0)
        and then Is_Same (Couple.First, 7)
        and then Is_Same (Couple.Second, 1);
   end Addressing_Passes;

   function Test_And_Set_Passes (Given : Operands) return Boolean is

      Taken : constant Byte := 16#80#;

      --  The effect of a test-and-set instruction. Ada cannot express that its
      --  bus cycle is indivisible.
      procedure Claim (Lock : in out Byte; Was_Free : out Boolean)
      with
        No_Inline,
        Post =>
          Was_Free = (Lock'Old < Taken)
          and then Lock = (Lock'Old or Taken);

      procedure Claim (Lock : in out Byte; Was_Free : out Boolean) is
      begin
         Was_Free := Lock < Taken;
         Lock := Lock or Taken;
      end Claim;

      Lock                 : Byte := Byte (Given (Zero) mod 256);
      First, Second, Third : Boolean;
   begin
      Claim (Lock, First);
      Claim (Lock, Second);
      Lock := Lock and Byte (Given (Seven) mod 256);
      Claim (Lock, Third);
      return First and then not Second and then Third and then Lock = Taken;
   end Test_And_Set_Passes;

   --  This test holds more values at once than such a processor has data
   --  registers or a compiler keeps in them.
   function Registers_Pass (Given : Operands) return Boolean is
      Base : constant Long := Joined (Given (Pattern), Given (Stripes));

      R0  : Long := Rotate_Left (Base, 1);
      R1  : Long := Rotate_Left (Base, 3);
      R2  : Long := Rotate_Left (Base, 5);
      R3  : Long := Rotate_Left (Base, 7);
      R4  : Long := Rotate_Left (Base, 9);
      R5  : Long := Rotate_Left (Base, 11);
      R6  : Long := Rotate_Left (Base, 13);
      R7  : Long := Rotate_Left (Base, 15);
      R8  : Long := Rotate_Left (Base, 17);
      R9  : Long := Rotate_Left (Base, 19);
      R10 : Long := Rotate_Left (Base, 21);
      R11 : Long := Rotate_Left (Base, 23);
      R12 : Long := Rotate_Left (Base, 25);
      R13 : Long := Rotate_Left (Base, 27);
   begin
      R0 := R0 + R1;
      R1 := R1 xor R2;
      R2 := R2 - R3;
      R3 := R3 + R4;
      R4 := R4 xor R5;
      R5 := R5 - R6;
      R6 := R6 + R7;
      R7 := R7 xor R8;
      R8 := R8 - R9;
      R9 := R9 + R10;
      R10 := R10 xor R11;
      R11 := R11 - R12;
      R12 := R12 + R13;
      R13 := R13 xor R0;
      return Is_Same (R0, 16#799E_9F66#)
        and then Is_Same (R1, 16#9679_8191#)
        and then Is_Same (R2, 16#D6DA_05C2#)
        and then Is_Same (R3, 16#67A7_D99D#)
        and then Is_Same (R4, 16#9E60_6465#)
        and then Is_Same (R5, 16#B681_7076#)
        and then Is_Same (R6, 16#E9F6_6799#)
        and then Is_Same (R7, 16#9819_1967#)
        and then Is_Same (R8, 16#A05C_1D6E#)
        and then Is_Same (R9, 16#7D99_E679#)
        and then Is_Same (R10, 16#0646_59E6#)
        and then Is_Same (R11, 16#1707_5B68#)
        and then Is_Same (R12, 16#6679_9E9E#)
        and then Is_Same (R13, 16#FCB0_8719#);
   end Registers_Pass;

   function Passes (Test : Processor_Test; Given : Operands) return Boolean
   is
     (case Test is
         when Data_Movement    => Data_Movement_Passes (Given),
         when Arithmetic       => Arithmetic_Passes (Given),

         --  The report tests it only if it is used; URV does not use it.
         when Floating_Point   => True,
         when Logical          => Logical_Passes (Given),
         when Shift_And_Rotate => Shift_And_Rotate_Passes (Given),
         when Bit_Manipulation => Bit_Manipulation_Passes (Given),
         when Program_Control  => Program_Control_Passes (Given),
         when Addressing       => Addressing_Passes (Given),
         when Test_And_Set     => Test_And_Set_Passes (Given),
         when Registers        => Registers_Pass (Given));

end URVOS.Processor_Tests;
