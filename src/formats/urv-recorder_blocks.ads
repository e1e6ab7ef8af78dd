--  SPDX-License-Identifier: Apache-2.0

--  The blocks that fetch the flight recorder's rows (FTI-10). The ground's
--  request goes up in place of a frame's commands:
--
--     word 1         the kind, 0700h
--     words 2, 3     first row, its number's high 10 and low 12 bits; if it is
--                    not held any more, the oldest one is the first
--     word 4         number of rows, 0 to 4095
--     words 5 .. 7   words 2 to 4 inverted
--     word 8         their weighted sum
--     words 9 .. 13  0
--     word 14        error/status, with the bit of another kind
--
--  The aircraft answers with a report, then the rows, each in four blocks.
--  They go down in place of a frame's sensors. No word has more than 12 bits,
--  so that both message formats carry them. Report, of kind 0800h:
--
--     word 1         its place in Answer, from 0
--     words 2, 3     oldest row that is held, as above
--     words 4, 5     number of rows held, the same
--     words 6, 7     rows that the recorder has room for, the same
--     words 8 .. 26  0
--     word 27        weighted sum of words 1 to 26
--
--  A quarter of a row, of kind 0700h:
--
--     word 1         part, 0 to 3, above the row's number's high 10 bits
--     word 2         its low 12 bits
--     words 3 .. 26  18 words of the row, from 18 * part + 1 on; of each three
--                    the bits in order, in four words
--     word 27        weighted sum of words 1 to 26

with URVOS;              use URVOS;
with URV.Buffers;        use URV.Buffers;
with URV.Log_Pieces;     use URV.Log_Pieces;
with URV.Recorder_Rings; use URV.Recorder_Rings;
with URV.Recorder_Rows;  use URV.Recorder_Rows;
with URV.Type_Codes;     use URV.Type_Codes;

package URV.Recorder_Blocks with Pure, SPARK_Mode is

   subtype Field is Word range 0 .. 16#FFF#;

   function High_Bits (Value : Row_Number) return Field is
     (Word (Value / 2 ** 12))
   with
     Global => null,
     Post   => High_Bits'Result < 2 ** 10;

   function Low_Bits (Value : Row_Number) return Field is
     (Word (Value mod 2 ** 12))
   with Global => null;

   --  The request

   type Request is record
      First : Row_Number := 0;
      Rows  : Field      := 0;
   end record;

   function Inverted (Value : Field) return Field is (Field'Last - Value)
   with Global => null;

   function Sum_Of (High, Low, Rows : Field) return Field is
     ((High + 3 * Low + 5 * Rows) mod 4_096)
   with Global => null;

   function Block_Of (Item : Request) return Uplink_Buffer is
     (Roll         => Recorder_Kind,
      Pitch        => High_Bits (Item.First),
      Yaw          => Low_Bits (Item.First),
      Throttle     => Item.Rows,
      Brake        => Inverted (High_Bits (Item.First)),
      Switch_1     => Inverted (Low_Bits (Item.First)),
      Switch_2     => Inverted (Item.Rows),
      Switch_3     =>
        Sum_Of (High_Bits (Item.First), Low_Bits (Item.First), Item.Rows),
      Switch_4 .. Switch_8 => 0,
      Error_Status => Other_Kind)
   with Global => null;

   --  All words of a block agree.
   function Is_Whole (Block : Uplink_Buffer) return Boolean is
     (Is_Other_Kind (Block)
      and then Kind_Of (Block) = Recorder_Kind
      and then Block (Pitch) < 2 ** 10
      and then Block (Yaw) in Field
      and then Block (Throttle) in Field
      and then Block (Brake) = Inverted (Block (Pitch))
      and then Block (Switch_1) = Inverted (Block (Yaw))
      and then Block (Switch_2) = Inverted (Block (Throttle))
      and then Block (Switch_3) =
        Sum_Of (Block (Pitch), Block (Yaw), Block (Throttle))
      and then (for all Item in Switch_4 .. Switch_8 => Block (Item) = 0))
   with Global => null;

   function Request_Of (Block : Uplink_Buffer) return Request is
     ((First => Row_Number (Block (Pitch)) * 2 ** 12
         + Row_Number (Block (Yaw)),
       Rows  => Block (Throttle)))
   with
     Global => null,
     Pre    => Is_Whole (Block);

   --  The answer

   type Answer is
     (Accepted,
      Flies,          --  the aircraft is not known to be on the ground
      Not_Held);      --  no row from the first one on is held

   --  The weighted sum of the words before the last.

   subtype Summed_Item is
     Sensor_Item range Sensor_Item'First .. Altitude;

   subtype Weight is Word range 1 .. 51;

   function Weight_Of (Item : Summed_Item) return Weight is
     (2 * Summed_Item'Pos (Item) + 1)
   with Global => null;

   function Sum_Up_To
     (Block : Downlink_Buffer; Item : Summed_Item) return Word
   is
     ((if Item = Summed_Item'First then 0
       else Sum_Up_To (Block, Summed_Item'Pred (Item)))
      + Weight_Of (Item) * Block (Item))
   with
     Ghost,
     Global             => null,
     Subprogram_Variant => (Decreases => Item);

   function Sum_Of (Block : Downlink_Buffer) return Field
   with
     Global => null,
     Post   =>
       Sum_Of'Result = Sum_Up_To (Block, Summed_Item'Last) mod 4_096;

   function With_Sum (Block : Downlink_Buffer; Kind : Word)
                      return Downlink_Buffer
   is
     ((Block with delta
         Uplink_Signal_Strength => Sum_Of (Block),
         Error_Status           => Kind / 256 * Piece_Unit))
   with
     Global => null,
     Pre    => Kind in Recorder_Kind | Recorder_Report_Kind;

   function Report_Of (Reply : Answer; Kept : Ring) return Downlink_Buffer is
     (With_Sum
        ((Right_Flap_1   => Answer'Pos (Reply),
          Left_Flap_1    => High_Bits (First (Kept)),
          Right_Flap_2   => Low_Bits (First (Kept)),
          Left_Flap_2    => High_Bits (Row_Number (Kept.Held)),
          Right_Aileron  => Low_Bits (Row_Number (Kept.Held)),
          Left_Aileron   => High_Bits (Row_Number (Kept.Length)),
          Right_Elevator => Low_Bits (Row_Number (Kept.Length)),
          others         => 0),
         Recorder_Report_Kind))
   with Global => null;

   --  A row in four blocks

   type Part is range 0 .. 3;

   --  Three words as four fields, and the words from the fields.

   function Field_Of (One, Two, Three : Word; Place : Part) return Field is
     (case Place is
         when 0 => One / 2 ** 4,
         when 1 => One mod 2 ** 4 * 2 ** 8 + Two / 2 ** 8,
         when 2 => Two mod 2 ** 8 * 2 ** 4 + Three / 2 ** 12,
         when 3 => Three mod 2 ** 12)
   with Global => null;

   function Word_From
     (One, Two, Three, Four : Field; Place : Part) return Word
   is
     (case Place is
         when 0      => One * 2 ** 4 + Two / 2 ** 8,
         when 1      => Two mod 2 ** 8 * 2 ** 8 + Three / 2 ** 4,
         when others => Three mod 2 ** 4 * 2 ** 12 + Four)
   with
     Global => null,
     Pre    => Place < 3;

   --  A part has six groups of three words.

   type Group is range 0 .. 5;

   function First_Word (Which : Part; Three : Group) return Row_Word is
     (Row_Word (18 * Integer (Which) + 3 * Integer (Three) + 1))
   with
     Global => null,
     Post   => First_Word'Result <= 70;

   function Field_At
     (Item : Row; Which : Part; Three : Group; Place : Part) return Field
   is
     (Field_Of
        (Word_At (Item, First_Word (Which, Three)),
         Word_At (Item, First_Word (Which, Three) + 1),
         Word_At (Item, First_Word (Which, Three) + 2),
         Place))
   with Global => null;

   --  The place of a field among the 24 of a part.
   subtype Data_Place is Integer range 0 .. 23;

   function Place_Of (Name : Summed_Item) return Data_Place is
     (Downlink_Item'Pos (Name) - Downlink_Item'Pos (Right_Flap_2))
   with
     Global => null,
     Pre    => Name >= Right_Flap_2;

   function Block_Of (Item : Row; Which : Part) return Downlink_Buffer is
     (With_Sum
        ([for Name in Downlink_Item =>
            (case Name is
                when Right_Flap_1 =>
                  Word (Which) * 2 ** 10 + High_Bits (Item.Number),
                when Left_Flap_1  => Low_Bits (Item.Number),
                when Right_Flap_2 .. Altitude =>
                  Field_At
                    (Item, Which, Group (Place_Of (Name) / 4),
                     Part (Place_Of (Name) mod 4)),
                when others       => 0)],
         Recorder_Kind))
   with Global => null;

end URV.Recorder_Blocks;
