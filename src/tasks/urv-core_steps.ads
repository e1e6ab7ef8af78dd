--  SPDX-License-Identifier: Apache-2.0

--  The decision of the CORE task (D-70): the words that it writes to CORE
--  memory, and the codes there that it reports (report, 4.3; COR-1, INI-7,
--  EXT-2). The task receives, calls these functions, writes and reports;
--  Theorems.Safety calls the same functions. Each is an expression function:
--  its text is its contract.

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URVOS;               use URVOS;
with URV.Buffers;         use URV.Buffers;
with URV.CORE_Layout;     use URV.CORE_Layout;

package URV.CORE_Steps with Pure, SPARK_Mode is

   --  An area is written only with a message of this frame.
   function Is_Written (Fresh : Boolean) return Boolean is (Fresh)
   with Global => null;

   --  The area with each word of the message at the place of its type code. A
   --  place with an unknown code keeps its word.

   function Words_After (Area : Coded_Uplink; Item : Uplink_Buffer)
                         return Uplink_Words
   is (Stored (Area.Codes, Area.Words, Item))
   with Global => null;

   function Words_After (Area : Coded_Downlink; Item : Downlink_Buffer)
                         return Downlink_Words
   is (Stored (Area.Codes, Area.Words, Item))
   with Global => null;

   --  An unknown code is reported, and all codes are written again in the
   --  next frame.

   function Has_Unknown (Area : Coded_Uplink) return Boolean is
     (First_Unknown_Uplink (Area.Codes) > 0)
   with Global => null;

   function Has_Unknown (Area : Coded_Downlink) return Boolean is
     (First_Unknown_Downlink (Area.Codes) > 0)
   with Global => null;

   function First_Unknown (Area : Coded_Uplink) return Word is
     (Area.Codes (Item_Number (First_Unknown_Uplink (Area.Codes))))
   with
     Global => null,
     Pre    => Has_Unknown (Area);

   function First_Unknown (Area : Coded_Downlink) return Word is
     (Area.Codes (Item_Number (First_Unknown_Downlink (Area.Codes))))
   with
     Global => null,
     Pre    => Has_Unknown (Area);

end URV.CORE_Steps;
