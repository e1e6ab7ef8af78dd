--  SPDX-License-Identifier: Apache-2.0

--  A CORE memory, shared by the controller and the readers (report, 4.3;
--  COR-1).

with URV.Buffers;     use URV.Buffers;
with URV.CORE_Memory; use URV.CORE_Memory;

package URV.Shared_CORE_Memory with SPARK_Mode is

   protected type Board is

      --  The controller's side

      procedure Clear;

      procedure Mark_Old;

      procedure Write_Codes
        (Uplink_Codes   : Uplink_Code_List;
         Downlink_Codes : Downlink_Code_List;
         Status_Codes   : Status_Words);

      --  The contents of an area, with its type codes

      function Uplink_Area return Coded_Uplink;

      function Downlink_Area return Coded_Downlink;

      procedure Write_Uplink (Words : Uplink_Buffer);

      --  The words and their frame, at one instant.
      procedure Write_Downlink (Words : Downlink_Buffer; Frame : Frame_Words);

      --  The same if the area's codes are the usual ones: each word then has
      --  its own place. Otherwise nothing is written.

      procedure Store_Uplink (Words : Uplink_Buffer; Is_Stored : out Boolean);

      procedure Store_Downlink
        (Words     : Downlink_Buffer;
         Frame     : Frame_Words;
         Is_Stored : out Boolean);

      --  Writes the given words of the status area at one instant; the others
      --  are unchanged.
      procedure Write_Status (Words : Status_Array);

      --  A row of the node's own log, or of the aircraft's.

      procedure Write_Log (Which : Log_Row_Number; Row : Log_Row);

      procedure Write_Aircraft_Log (Which : Log_Row_Number; Row : Log_Row);

      --  The readers' side: the whole memory, at one instant.
      function Contents return Memory;

   private
      Present : Memory;
   end Board;

end URV.Shared_CORE_Memory;
