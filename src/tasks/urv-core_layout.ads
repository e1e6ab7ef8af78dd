--  Where the buffers stand in CORE memory, and the type codes of their
--  items (report, 2.5; BUF-4): 0101h onward for the uplink, 0201h onward
--  for the downlink, in the order of the buffers.

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URVOS;               use URVOS;
with URV.Buffers;         use URV.Buffers;

package URV.CORE_Layout with Pure, SPARK_Mode is

   function Place (Item : Uplink_Item) return Item_Number is
     (Item_Number (Uplink_Item'Pos (Item) + 1));

   function Place (Item : Downlink_Item) return Item_Number is
     (Item_Number (Downlink_Item'Pos (Item) + 1));

   function Type_Code (Item : Uplink_Item) return Word is
     (16#0100# + Word (Place (Item)));

   function Type_Code (Item : Downlink_Item) return Word is
     (16#0200# + Word (Place (Item)));

   function Uplink_Type_Codes return Uplink_Words
   with
     Post =>
       (for all Item in Uplink_Item =>
          Uplink_Type_Codes'Result (Place (Item)) = Type_Code (Item));

   function Downlink_Type_Codes return Downlink_Words
   with
     Post =>
       (for all Item in Downlink_Item =>
          Downlink_Type_Codes'Result (Place (Item)) = Type_Code (Item));

   function To_Words (Source : Uplink_Buffer) return Uplink_Words
   with
     Post =>
       (for all Item in Uplink_Item =>
          To_Words'Result (Place (Item)) = Source (Item));

   function To_Words (Source : Downlink_Buffer) return Downlink_Words
   with
     Post =>
       (for all Item in Downlink_Item =>
          To_Words'Result (Place (Item)) = Source (Item));

   --  For the readers of CORE memory.

   function To_Buffer (Source : Uplink_Words) return Uplink_Buffer
   with
     Post =>
       (for all Item in Uplink_Item =>
          To_Buffer'Result (Item) = Source (Place (Item)));

   function To_Buffer (Source : Downlink_Words) return Downlink_Buffer
   with
     Post =>
       (for all Item in Downlink_Item =>
          To_Buffer'Result (Item) = Source (Place (Item)));

end URV.CORE_Layout;
