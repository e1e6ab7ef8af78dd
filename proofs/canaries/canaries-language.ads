--  SPDX-License-Identifier: Apache-2.0

--  False claims of a kind each: expressions, contracts, loops and data flow.

with URVOS; use URVOS;

package Canaries.Language with SPARK_Mode is

   --  Expressions that can raise an exception.

   package Run_Time_Checks is

      subtype Percent is Word range 0 .. 100;

      --  101 times 50, divided by 50.
      function Share (Part, Whole : Word) return Percent is
        (Percent (Part / (Whole / 50 + 1)))  --  VC_RANGE_CHECK
      with Pre => Whole >= 1 and then Part <= 102 * (Whole / 50) and then
                  Whole <= 30_000;

      --  The last count has no successor.
      function Next_Of (Value : Count) return Integer is
        (Integer (Value) + 1);  --  VC_OVERFLOW_CHECK

      --  The divisor is zero if the words differ by one.
      function Ratio (Left, Right : Word) return Word is
        (Left / (Left - Right - 1))  --  VC_DIVISION_CHECK
      with Pre => Left > Right;

      type Row is array (Byte range <>) of Word;

      subtype Short_Row is Row (1 .. 8);

      --  One place beyond the last.
      function Neighbour_Of (Source : Short_Row; I : Byte) return Word is
        (Source (I + 1))  --  VC_INDEX_CHECK
      with Pre => I in Source'Range;

      --  Nine words for eight places.
      procedure Take (Source : Row; Target : out Short_Row)
      with
        Global => null,
        Pre    => Source'Length in 8 .. 9 and then Source'Last < 255;

      type Shape (Round : Boolean := True) is record
         case Round is
            when True  => Radius : Byte;
            when False => Side   : Byte;
         end case;
      end record;

      function Size (Item : Shape; Wanted : Boolean) return Byte is
        (if Wanted then Item.Radius  --  VC_DISCRIMINANT_CHECK
         else 0)
      with Pre => Item.Round or else not Wanted or else Item.Side = 0;

   end Run_Time_Checks;

   --  False promises of callers and callees.

   package Contracts is

      --  False: the middle of two neighbours is the lower one.
      function Middle (Low, High : Byte) return Byte is
        (Low + (High - Low) / 2)
      with
        Pre  => Low < High,
        Post =>
          Middle'Result < High
          and then Middle'Result > Low;  --  VC_POSTCONDITION

      --  False for 255: the last half has no higher neighbour.
      function Half (Value : Byte) return Byte is
        (Middle (Value / 2, Value));  --  VC_PRECONDITION

      --  False for a full count, which keeps its last value.
      procedure Count_Up (Value : in out Count)
      with
        Global         => null,
        Contract_Cases =>
          (Value = 0 => Value = 1,
           Value > 0 => Value > Value'Old);  --  VC_CONTRACT_CASE

      --  Both cases hold for 16.
      procedure Keep_Low (Value : in out Byte)
      with
        Global         => null,
        Contract_Cases =>  --  VC_DISJOINT_CONTRACT_CASES
          (Value <= 16 => Value = Value'Old,
           Value >= 16 => Value = 16);

      --  Neither case holds for 16.
      procedure Keep_Away (Value : in out Byte)
      with
        Global         => null,
        Contract_Cases =>  --  VC_COMPLETE_CONTRACT_CASES
          (Value < 16 => Value = 0,
           Value > 16 => Value = 255);

      --  False: half of an even number may be odd.
      type Even is new Word with Predicate => Even mod 2 = 0;

      procedure Split (Value : in out Even)
      with Global => null;

      --  Two counts, the first never higher than the second. The default value
      --  breaks this.
      type Pair is record
         First  : Word := 1;
         Second : Word := 0;
      end record
      with Predicate => Pair.First <= Pair.Second;

      procedure Make_Pair (Sum : out Word)
      with Global => null;

      --  Odd and even numbers are halved alike. The rank of 1 does not fall.
      function Steps_To_Zero (Value : Byte) return Byte is
        (if Value = 0 then 0
         else 1 + Steps_To_Zero  --  VC_SUBPROGRAM_VARIANT
                    (Value / 2))
      with
        Subprogram_Variant => (Decreases => (Value + 1) / 2),
        Post               => Steps_To_Zero'Result <= 8;

      --  False: 3 times a byte exceeds 255 exactly if the byte exceeds 85.
      procedure Triple (Value : Byte)
      with
        Global => null;

      --  A lemma of one line that is false for the last value only.
      procedure Successor_Is_Larger (Value : Word)
      with
        Ghost,
        Global => null,
        Post   => Value + 1 > Value;  --  VC_POSTCONDITION

      --  A lemma for all pairs of bytes that is false for exactly one pair.
      procedure Apart_From_One (Left, Right : Byte)
      with
        Ghost,
        Global => null,
        Post   =>
          (Left xor Right) /= 16#5A#  --  VC_POSTCONDITION
          or else (Left and Right) /= 16#A5#
          or else Left < 16#FF#;

   end Contracts;

   --  False claims about running loops.

   package Loops is

      type Place is range 1 .. 8;
      type Row is array (Place) of Byte;

      --  False before the loop: it has seen no word.
      function Largest_Of (Source : Row) return Byte
      with Global => null;

      --  False: a sum that wraps round may fall.
      function Sum_Of (Source : Row) return Byte
      with Global => null;

      --  False: the last step of the loop does not decrease its variant.
      function Halvings (Value : Byte) return Word
      with Global => null;

      --  A true invariant that is too weak for the postcondition.
      function Index_Of (Source : Row; Wanted : Byte) return Place
      with
        Global => null,
        Post   =>
          (if (for some I in Place => Source (I) = Wanted)
           then Source (Index_Of'Result) = Wanted  --  VC_POSTCONDITION
          );

   end Loops;

   --  False claims about inputs, outputs and dependencies of subprograms, and
   --  about the state of a package.

   package Data_Flow
     with
       Abstract_State => Memory,
       Initializes    => Memory
   is

      --  Reads nothing if nothing is wanted; Value then has no value.
      procedure Read (Wanted : Boolean; Value : out Word)
      with Global => (Input => Memory);

      --  A look that changes the memory.
      procedure Peek (Value : out Word)
      with Global => (Input => Memory);  --  GLOBAL_MISSING

      --  The higher of two words depends on both.
      procedure Sort (Left, Right : Word; Low, High : out Word)
      with
        Global  => null,
        Depends => (Low => (Left, Right), High => Right);  --  DEPENDS_MISSING

      --  The first of two sums depends on one word alone.
      procedure Add_Up (Left, Right : Word; First, Last : out Word)
      with
        Global  => null,
        Depends => ((First, Last) => (Left, Right));  --  DEPENDS_WRONG

      type Row is array (Byte) of Word;

      --  Two places may be the same.
      procedure Swap (Left, Right : in out Word)
      with Global => null;

      procedure Exchange (Words : in out Row; From, To : Byte)
      with
        Global => null,
        Pre    => From <= To;

      function Is_Empty return Boolean
      with Global => Memory;

      --  The body hides that zero leaves it empty.
      procedure Fill (Value : Word)
      with
        Global => (In_Out => Memory),
        Post   => not Is_Empty;

   end Data_Flow;

end Canaries.Language;
