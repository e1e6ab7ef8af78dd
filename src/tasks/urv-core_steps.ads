--  SPDX-License-Identifier: Apache-2.0

--  The decision of the CORE task (D-70): the words that it writes to CORE
--  memory, and the codes there that it reports (report, 4.3; COR-1, INI-7,
--  EXT-2). The task receives, calls these functions, writes and reports;
--  Theorems.Safety calls the same functions. Each is an expression function:
--  its text is its contract.

with URV.Buffers;     use URV.Buffers;
with URV.CORE_Layout; use URV.CORE_Layout;
with URV.CORE_Memory; use URV.CORE_Memory;

package URV.CORE_Steps with Pure, SPARK_Mode is

   --  An area is written only with a message of this frame.
   function Is_Written (Fresh : Boolean) return Boolean is (Fresh)
   with Global => null;

   --  The area with each word of the message at the place of its type code. A
   --  place with an unknown code keeps its word.

   function Words_After (Area : Coded_Uplink; Item : Uplink_Buffer)
                         return Uplink_Buffer
   is (Stored (Area.Codes, Area.Words, Item))
   with Global => null;

   function Words_After (Area : Coded_Downlink; Item : Downlink_Buffer)
                         return Downlink_Buffer
   is (Stored (Area.Codes, Area.Words, Item))
   with Global => null;

end URV.CORE_Steps;
