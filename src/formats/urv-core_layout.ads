--  SPDX-License-Identifier: Apache-2.0

--  The places of the buffers in CORE memory, and the type codes of their items
--  (report, 2.5; BUF-4): 0101h onward for the uplink and 0201h onward for the
--  downlink, in the order of the buffers; 0301h onward for the status area. A
--  word is stored at the place of its item's code (EXT-2). The error log's
--  words and rows are also defined here (EXT-1).

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URVOS;               use URVOS;
with URVOS.Frames;        use URVOS.Frames;
with URV.Buffers;         use URV.Buffers;
with URV.Errors;          use URV.Errors;
with URV.Type_Codes;      use URV.Type_Codes;

package URV.CORE_Layout with Pure, SPARK_Mode is

   function Place (Item : Uplink_Item) return Item_Number is
     (Item_Number (Uplink_Item'Pos (Item) + 1))
   with Global => null;

   function Place (Item : Downlink_Item) return Item_Number is
     (Item_Number (Downlink_Item'Pos (Item) + 1))
   with Global => null;

   function Type_Code (Item : Uplink_Item) return Word is (Code_Of (Item))
   with Global => null;

   function Type_Code (Item : Downlink_Item) return Word is (Code_Of (Item))
   with Global => null;

   function Type_Code (Item : Status_Item) return Word is
     (Status_Kind + 1 + Word (Status_Item'Pos (Item)))
   with Global => null;

   function Uplink_Type_Codes return Uplink_Words
   with
     Global => null,
     Post   =>
       (for all Item in Uplink_Item =>
          Uplink_Type_Codes'Result (Place (Item)) = Type_Code (Item));

   function Downlink_Type_Codes return Downlink_Words
   with
     Global => null,
     Post   =>
       (for all Item in Downlink_Item =>
          Downlink_Type_Codes'Result (Place (Item)) = Type_Code (Item));

   function Status_Type_Codes return Status_Words
   with
     Global => null,
     Post   =>
       (for all Item in Status_Item =>
          Status_Type_Codes'Result (Item) = Type_Code (Item));

   function To_Words (Source : Uplink_Buffer) return Uplink_Words
   with
     Global => null,
     Post   =>
       (for all Item in Uplink_Item =>
          To_Words'Result (Place (Item)) = Source (Item));

   function To_Words (Source : Downlink_Buffer) return Downlink_Words
   with
     Global => null,
     Post   =>
       (for all Item in Downlink_Item =>
          To_Words'Result (Place (Item)) = Source (Item));

   --  The words of an area after a buffer is stored by the area's codes: each
   --  word is that of its code. A place with a code that no item of the buffer
   --  has keeps its word.

   function Stored
     (Codes  : Uplink_Words;
      Before : Uplink_Words;
      Source : Uplink_Buffer) return Uplink_Words
   with
     Global => null,
     Post   =>
       (for all Where in Uplink_Words'Range =>
          Stored'Result (Where) =
            (if Codes (Where) in Uplink_Code
             then Source (Uplink_Item_Of (Codes (Where)))
             else Before (Where)));

   function Stored
     (Codes  : Downlink_Words;
      Before : Downlink_Words;
      Source : Downlink_Buffer) return Downlink_Words
   with
     Global => null,
     Post   =>
       (for all Where in Downlink_Words'Range =>
          Stored'Result (Where) =
            (if Codes (Where) in Downlink_Code
             then Source (Downlink_Item_Of (Codes (Where)))
             else Before (Where)));

   --  The first place with an unknown code; 0 if there is none

   type Place_Or_None is
     range 0 .. Downlink_Item'Pos (Downlink_Item'Last) + 1;

   function First_Unknown_Uplink (Codes : Uplink_Words) return Place_Or_None
   with
     Global => null,
     Post   =>
       First_Unknown_Uplink'Result <=
         Place_Or_None (Uplink_Words'Last)
       and then
         (if First_Unknown_Uplink'Result = 0
          then (for all Code of Codes => Code in Uplink_Code)
          else Codes (Item_Number (First_Unknown_Uplink'Result))
                 not in Uplink_Code);

   function First_Unknown_Downlink
     (Codes : Downlink_Words) return Place_Or_None
   with
     Global => null,
     Post   =>
       (if First_Unknown_Downlink'Result = 0
        then (for all Code of Codes => Code in Downlink_Code)
        else Codes (Item_Number (First_Unknown_Downlink'Result))
               not in Downlink_Code);

   --  For the readers of CORE memory

   function To_Buffer (Source : Uplink_Words) return Uplink_Buffer
   with
     Global => null,
     Post   =>
       (for all Item in Uplink_Item =>
          To_Buffer'Result (Item) = Source (Place (Item)));

   function To_Buffer (Source : Downlink_Words) return Downlink_Buffer
   with
     Global => null,
     Post   =>
       (for all Item in Downlink_Item =>
          To_Buffer'Result (Item) = Source (Place (Item)));

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

   --  The major frame of the last error.
   function Last_Frame (Log : Error_Log) return Long_Count is
     (Frame_Of (Logs.History_Of (Log, Logs.Latest (Log)).Last))
   with Global => null;

   --  The error log's words in the status area

   subtype Log_Item is
     Status_Item range Error_Total_High .. Last_Error_Frame_Low;

   subtype Log_Words is Status_Array (Log_Item);

   function To_Status (Log : Error_Log) return Log_Words is
     (if Logs.Total (Log) = 0
      then (others => 0)
      else
        (Error_Total_High      => High_Word (Long_Count (Logs.Total (Log))),
         Error_Total_Low       => Low_Word (Long_Count (Logs.Total (Log))),
         Last_Error            => Error_Kind'Pos (Logs.Latest (Log)) + 1,
         Last_Error_Frame_High => High_Word (Last_Frame (Log)),
         Last_Error_Frame_Low  => Low_Word (Last_Frame (Log))))
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
