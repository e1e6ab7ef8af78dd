--  SPDX-License-Identifier: Apache-2.0

--  Claims about the sealed link that go one too far.

with Telemetry;       use Telemetry;
with URVOS;           use URVOS;
with URV.Seal_Blocks; use URV.Seal_Blocks;
with URV.Sessions;    use URV.Sessions;
with URV.Sip_Hash;    use URV.Sip_Hash;

package Canaries.Seals with Pure, SPARK_Mode, Ghost is

   --  After as many losses as an uplink's number tells it is another one.
   procedure One_More_May_Be_Lost (Newest, Number : Counter)
   with
     Global => null,
     Pre    =>
       Newest < Last_Number
       and then Number > Newest
       and then Number - Newest <= Numbers_Told + 1,
     Post   =>
       Following  --  VC_POSTCONDITION
         (Newest, Word (Number mod Numbers_Told)) = Number;

   --  Not the words that exceed 12 bits.
   procedure All_Words_Come_Through (Data : Block_Data; Number : Counter)
   with
     Global => null,
     Post   =>
       Field_At (Packed (Data, Ground, Number), 3) =  --  VC_POSTCONDITION
         Word_At (Data, 3);

   --  Not the newest itself.
   procedure The_Newest_Opens_Again (Item : Session; Block : Block_Data)
   with
     Global => null,
     Pre    =>
       Item.Is_Present
       and then Number_At (Block) = Item.Newest
       and then Has_Tag
         (Block, Aircraft,
          Tag_Of (Block, Aircraft, Item.Newest, Item.Down_Key)),
     Post   =>
       Opens (Block, Aircraft, Item);  --  VC_POSTCONDITION

   --  Nor one without its first byte of the tag.
   procedure Seven_Bytes_Are_Enough
     (Block : Block_Data; With_Key : Key)
   with
     Global => null,
     Pre    =>
       (for all Where in Byte_Index range 2 .. 8 =>
          Block (Covered (Aircraft) + Where) =
            Tag_Byte (Tag_Of (Block, Aircraft, 1, With_Key), Where)),
     Post   =>
       Has_Tag  --  VC_POSTCONDITION
         (Block, Aircraft, Tag_Of (Block, Aircraft, 1, With_Key));

end Canaries.Seals;
