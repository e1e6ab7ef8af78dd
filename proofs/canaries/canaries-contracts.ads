--  SPDX-License-Identifier: Apache-2.0

--  False promises of callers and callees.

with URVOS; use URVOS;

package Canaries.Contracts with Pure, SPARK_Mode is

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

   --  False: three times a byte is above 255 exactly if the byte is above 85.
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

end Canaries.Contracts;
