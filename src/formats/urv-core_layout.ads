--  SPDX-License-Identifier: Apache-2.0

--  The type codes in CORE memory (report, 2.5; BUF-4): 0101h onward for the
--  uplink and 0201h onward for the downlink, in the order of the buffers;
--  0301h onward for the status area. A word is stored at the place of its
--  item's code (EXT-2). The error log's words and rows are also defined here
--  (EXT-1).

with URVOS;           use URVOS;
with URVOS.Frames;    use URVOS.Frames;
with URV.Buffers;     use URV.Buffers;
with URV.CORE_Memory; use URV.CORE_Memory;
with URV.Errors;      use URV.Errors;
with URV.Type_Codes;  use URV.Type_Codes;

package URV.CORE_Layout with Pure, SPARK_Mode is

   function Type_Code (Item : Status_Item) return Word is
     (Status_Kind + 1 + Word (Status_Item'Pos (Item)))
   with Global => null;

   function Uplink_Type_Codes return Uplink_Code_List is
     ([for Item in Uplink_Item => Code_Of (Item)])
   with Global => null;

   function Downlink_Type_Codes return Downlink_Code_List is
     ([for Item in Downlink_Item => Code_Of (Item)])
   with Global => null;

   function Status_Type_Codes return Status_Words is
     ([for Item in Status_Item => Type_Code (Item)])
   with Global => null;

   --  The area has the codes of above: its places are those of the buffer.

   function Is_Usual (Codes : Uplink_Code_List) return Boolean is
     (for all Item in Uplink_Item => Codes (Item) = Code_Of (Item))
   with Global => null;

   function Is_Usual (Codes : Downlink_Code_List) return Boolean is
     (for all Item in Downlink_Item => Codes (Item) = Code_Of (Item))
   with Global => null;

   --  The words of an area after a buffer is stored by the area's codes: each
   --  word is that of its code. A place with a code that no item of the buffer
   --  has keeps its word.

   function Stored
     (Codes  : Uplink_Code_List;
      Before : Uplink_Buffer;
      Source : Uplink_Buffer) return Uplink_Buffer
   is
     ([for Where in Uplink_Item =>
         (if Codes (Where) in Uplink_Code
          then Source (Uplink_Item_Of (Codes (Where))) else Before (Where))])
   with
     Global => null,
     Post   => (if Is_Usual (Codes) then Stored'Result = Source);

   function Stored
     (Codes  : Downlink_Code_List;
      Before : Downlink_Buffer;
      Source : Downlink_Buffer) return Downlink_Buffer
   is
     ([for Where in Downlink_Item =>
         (if Codes (Where) in Downlink_Code
          then Source (Downlink_Item_Of (Codes (Where)))
          else Before (Where))])
   with
     Global => null,
     Post   => (if Is_Usual (Codes) then Stored'Result = Source);

   --  The first unknown code

   function Has_Unknown (Codes : Uplink_Code_List) return Boolean is
     (for some Code of Codes => Code not in Uplink_Code)
   with Global => null;

   function Has_Unknown (Codes : Downlink_Code_List) return Boolean is
     (for some Code of Codes => Code not in Downlink_Code)
   with Global => null;

   function First_Unknown (Codes : Uplink_Code_List) return Word
   with
     Global => null,
     Pre    => Has_Unknown (Codes),
     Post   =>
       (for some Where in Uplink_Item =>
          First_Unknown'Result = Codes (Where)
          and then Codes (Where) not in Uplink_Code
          and then
            (for all Earlier in Uplink_Item =>
               (if Earlier < Where then Codes (Earlier) in Uplink_Code)));

   function First_Unknown (Codes : Downlink_Code_List) return Word
   with
     Global => null,
     Pre    => Has_Unknown (Codes),
     Post   =>
       (for some Where in Downlink_Item =>
          First_Unknown'Result = Codes (Where)
          and then Codes (Where) not in Downlink_Code
          and then
            (for all Earlier in Downlink_Item =>
               (if Earlier < Where then Codes (Earlier) in Downlink_Code)));

   --  A count in one word. The last value means that number or more.
   function To_Word (Value : Count) return Word is
     (if Value > Count (Word'Last) then Word'Last else Word (Value))
   with Global => null;

   --  A number in two words. The largest value means that number or more.

   type Long_Count is range 0 .. 2 ** 32 - 1;

   function High_Word (Value : Long_Count) return Word is
     (Word (Value / 2 ** 16))
   with Global => null;

   function Low_Word (Value : Long_Count) return Word is
     (Word (Value mod 2 ** 16))
   with Global => null;

   --  The major frame of a tick.
   function Frame_Of (Now : Clock_Tick) return Long_Count is
     (if Now / Ticks_Per_Major_Frame > Clock_Tick (Long_Count'Last)
      then Long_Count'Last
      else Long_Count (Now / Ticks_Per_Major_Frame))
   with Global => null;

   --  The error log's words in the status area

   subtype Log_Item is
     Status_Item range Error_Total_High .. Last_Error_Frame_Low;

   subtype Log_Words is Status_Array (Log_Item);

   function To_Status (Item : Logs.Summary) return Log_Words is
     (if Item.Total = 0
      then (others => 0)
      else
        (Error_Total_High      => High_Word (Long_Count (Item.Total)),
         Error_Total_Low       => Low_Word (Long_Count (Item.Total)),
         Last_Error            => Error_Kind'Pos (Item.Latest) + 1,
         Last_Error_Frame_High => High_Word (Frame_Of (Item.Last)),
         Last_Error_Frame_Low  => Low_Word (Frame_Of (Item.Last))))
   with Global => null;

   --  The log's rows (SAF-7)

   function Row_Of (Kind : Error_Kind) return Log_Row_Number is
     (Error_Kind'Pos (Kind) + 1)
   with Global => null;

   function To_Row (History : Logs.History) return Log_Row is
     (if History.Occurrences = 0
      then No_Errors
      else
        (Occurrences_High => High_Word (Long_Count (History.Occurrences)),
         Occurrences_Low  => Low_Word (Long_Count (History.Occurrences)),
         First_Frame_High => High_Word (Frame_Of (History.First)),
         First_Frame_Low  => Low_Word (Frame_Of (History.First)),
         Last_Frame_High  => High_Word (Frame_Of (History.Last)),
         Last_Frame_Low   => Low_Word (Frame_Of (History.Last)),
         Last_Detail      => History.Last_Detail))
   with Global => null;

end URV.CORE_Layout;
