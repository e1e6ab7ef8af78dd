--  SPDX-License-Identifier: Apache-2.0

--  Claims about the sealed link that exceed the truth by one step.

with Telemetry;       use Telemetry;
with URVOS;           use URVOS;
with URV.Seal_Blocks; use URV.Seal_Blocks;
with URV.Sessions;    use URV.Sessions;
with URV.Sip_Hash;    use URV.Sip_Hash;

package Canaries.Seals with Pure, SPARK_Mode, Ghost is

   --  False: a number as many places back as there are remainders reads as
   --  another number.
   procedure One_More_May_Be_Lost (Number, Most : Counter)
   with
     Global => null,
     Pre    =>
       Number <= Most
       and then Most <= Last_Age
       and then Most - Number <= Number_Modulus,
     Post   =>
       Last_With  --  VC_POSTCONDITION
         (Number mod Number_Modulus, Number_Modulus, Most) = Number;

   --  False for words beyond 12 bits.
   procedure All_Words_Come_Through
     (Data : Block_Data; Number, Echo : Counter)
   with
     Global => null,
     Post   =>
       Field_At  --  VC_POSTCONDITION
         (Packed (Data, Ground, Number, Echo), 3) =
       Word_At (Data, 3);

   --  False for the newest block itself.
   procedure The_Newest_Opens_Again (Item : Session; Block : Block_Data)
   with
     Global => null,
     Pre    =>
       Item.Is_Present
       and then Number_At (Block) = Item.Newest
       and then Has_Tag
         (Block, Aircraft,
          Tag_Of (Block, Aircraft, Item.Newest, 0, Item.Down_Key)),
     Post   =>
       Opens (Block, Aircraft, Item);  --  VC_POSTCONDITION

   --  False: a block may be exactly Most_Age old, by the receiver's reference.
   procedure Every_Block_Is_A_Frame_Younger
     (Item : Session; Number, Echo, Sealed_At : Counter)
   with
     Global => null,
     Pre    =>
       Number <= Last_Age
       and then Echo <= Item.Age
       and then Is_Timely (Item, Number, Echo)
       and then Sealed_At >= Earliest (Item, Number, Echo),
     Post   =>
       Item.Age <= Sealed_At  --  VC_POSTCONDITION
       or else Item.Age - Sealed_At <= Most_Age - 1;

   --  False: all eight bytes of the tag count.
   procedure Seven_Bytes_Are_Enough
     (Block : Block_Data; With_Key : Key)
   with
     Global => null,
     Pre    =>
       (for all Where in Byte_Index range 2 .. 8 =>
          Block (Covered (Aircraft) + Where) =
            Tag_Byte
              (Tag_Of (Block, Aircraft, 1, 0, With_Key), Where)),
     Post   =>
       Has_Tag  --  VC_POSTCONDITION
         (Block, Aircraft, Tag_Of (Block, Aircraft, 1, 0, With_Key));

end Canaries.Seals;
