--  SPDX-License-Identifier: Apache-2.0

--  What a caller or a callee promises.

with URVOS; use URVOS;

package Canaries.Contracts with Pure, SPARK_Mode is

   --  The middle of two neighbours is the lower one.
   function Middle (Low, High : Byte) return Byte is
     (Low + (High - Low) / 2)
   with
     Pre  => Low < High,
     Post =>
       Middle'Result < High
       and then Middle'Result > Low;  --  VC_POSTCONDITION

   --  The last half has no neighbour above.
   function Half (Value : Byte) return Byte is
     (Middle (Value / 2, Value));  --  VC_PRECONDITION

   --  A count that has reached its last value stays there.
   procedure Count_Up (Value : in out Count)
   with
     Global         => null,
     Contract_Cases =>
       (Value = 0 => Value = 1,
        Value > 0 => Value > Value'Old);  --  VC_CONTRACT_CASE

   --  Both are true of 16.
   procedure Keep_Low (Value : in out Byte)
   with
     Global         => null,
     Contract_Cases =>  --  VC_DISJOINT_CONTRACT_CASES
       (Value <= 16 => Value = Value'Old,
        Value >= 16 => Value = 16);

   --  None is true of 16.
   procedure Keep_Away (Value : in out Byte)
   with
     Global         => null,
     Contract_Cases =>  --  VC_COMPLETE_CONTRACT_CASES
       (Value < 16 => Value = 0,
        Value > 16 => Value = 255);

   --  An even number is not always halved to an even one.
   type Even is new Word with Predicate => Even mod 2 = 0;

   procedure Split (Value : in out Even)
   with Global => null;

   --  Two counts, the first never ahead of the second.
   type Pair is record
      First  : Word := 1;
      Second : Word := 0;
   end record
   with Predicate => Pair.First <= Pair.Second;

   procedure Make_Pair (Sum : out Word)
   with Global => null;

   --  Halving odd and even numbers alike; the rank of 1 does not fall.
   function Steps_To_Zero (Value : Byte) return Byte is
     (if Value = 0 then 0
      else 1 + Steps_To_Zero  --  VC_SUBPROGRAM_VARIANT
                 (Value / 2))
   with
     Subprogram_Variant => (Decreases => (Value + 1) / 2),
     Post               => Steps_To_Zero'Result <= 8;

   --  Three times a byte is odd when the byte is, and not only then is it
   --  above 255.
   procedure Triple (Value : Byte)
   with
     Global => null;

   --  A lemma of one line that is true but for the last value.
   procedure Successor_Is_Larger (Value : Word)
   with
     Ghost,
     Global => null,
     Post   => Value + 1 > Value;  --  VC_POSTCONDITION

   --  A lemma for all pairs of bytes, false of exactly one.
   procedure Apart_From_One (Left, Right : Byte)
   with
     Ghost,
     Global => null,
     Post   =>
       (Left xor Right) /= 16#5A#  --  VC_POSTCONDITION
       or else (Left and Right) /= 16#A5#
       or else Left < 16#FF#;

end Canaries.Contracts;
