--  SPDX-License-Identifier: Apache-2.0

--  The block of a test card (FTI-1, FTI-2).
--
--  A card goes up in place of a frame's commands, as a block of its own kind:
--
--     word 1         the kind, 0500h
--     words 2 .. 12  the items of the card, 0501h onward
--     word 13        their weighted sum
--     word 14        error/status, with the bit of another kind
--
--  No word has more than 12 bits, so that both message formats carry it. The
--  aircraft takes a card whole or refuses it whole.

with URVOS;          use URVOS;
with URV.Buffers;    use URV.Buffers;
with URV.Test_Cards; use URV.Test_Cards;
with URV.Type_Codes; use URV.Type_Codes;

package URV.Card_Blocks with Pure, SPARK_Mode is

   subtype Card_Word is Command_Item range Pitch .. Switch_7;

   --  Each weight is odd, so one wrong word changes the sum.
   subtype Weight is Word range 1 .. 21;

   function Weight_Of (Item : Card_Item) return Weight is
     (2 * Card_Item'Pos (Item) + 1)
   with Global => null;

   --  The weighted sum of the items up to one.
   function Sum_Up_To (Source : Card; Item : Card_Item) return Word is
     ((if Item = Head then 0
       else Sum_Up_To (Source, Card_Item'Pred (Item)))
      + Weight_Of (Item) * Source (Item))
   with
     Ghost,
     Global             => null,
     Subprogram_Variant => (Decreases => Item);

   function Sum_Of (Source : Card) return Field
   with
     Global => null,
     Post   => Sum_Of'Result = Sum_Up_To (Source, Lowest) mod 4_096;

   function Block_Of (Source : Card) return Uplink_Buffer is
     (Roll         => Test_Card_Kind,
      Pitch        => Source (Head),
      Yaw          => Source (Surfaces),
      Throttle     => Source (Amplitude),
      Brake        => Source (Time),
      Switch_1     => Source (First),
      Switch_2     => Source (Last),
      Switch_3     => Source (Attitude),
      Switch_4     => Source (Airflow),
      Switch_5     => Source (Slowest),
      Switch_6     => Source (Fastest),
      Switch_7     => Source (Lowest),
      Switch_8     => Sum_Of (Source),
      Error_Status => Other_Kind)
   with Global => null;

   function Has_Fields (Block : Uplink_Buffer) return Boolean is
     (for all Item in Card_Word => Block (Item) in Field)
   with Global => null;

   function Card_Of (Block : Uplink_Buffer) return Card is
     (Head      => Block (Pitch),
      Surfaces  => Block (Yaw),
      Amplitude => Block (Throttle),
      Time      => Block (Brake),
      First     => Block (Switch_1),
      Last      => Block (Switch_2),
      Attitude  => Block (Switch_3),
      Airflow   => Block (Switch_4),
      Slowest   => Block (Switch_5),
      Fastest   => Block (Switch_6),
      Lowest    => Block (Switch_7))
   with
     Global => null,
     Pre    => Has_Fields (Block);

   --  All words of a block agree. The card may still be out of range.
   function Is_Whole (Block : Uplink_Buffer) return Boolean is
     (Is_Other_Kind (Block)
      and then Kind_Of (Block) = Test_Card_Kind
      and then Has_Fields (Block)
      and then Block (Switch_8) = Sum_Of (Card_Of (Block)))
   with Global => null;

end URV.Card_Blocks;
