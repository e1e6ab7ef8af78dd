--  SPDX-License-Identifier: Apache-2.0

--  A CORE memory between the controller and its readers (report, 4.3;
--  COR-1).

with Devices.CORE_Memory; use Devices.CORE_Memory;

package Devices.Shared_CORE_Memory with SPARK_Mode is

   protected type Board is

      --  The controller's side.

      procedure Clear;

      procedure Mark_Old;

      procedure Write_Codes
        (Uplink_Codes   : Uplink_Words;
         Downlink_Codes : Downlink_Words;
         Status_Codes   : Status_Words);

      --  What stands in an area, and beside it.

      function Uplink_Area return Coded_Uplink;

      function Downlink_Area return Coded_Downlink;

      procedure Write_Uplink (Words : Uplink_Words);

      procedure Write_Downlink (Words : Downlink_Words);

      --  Writes the words of the status area that are given, at one instant;
      --  the others stay.
      procedure Write_Status (Words : Status_Array);

      --  A row of the node's own log, or of the aircraft's.

      procedure Write_Log (Which : Log_Row_Number; Row : Log_Row);

      procedure Write_Aircraft_Log (Which : Log_Row_Number; Row : Log_Row);

      --  The readers' side: all of it, at one instant.
      function Contents return Memory;

   private
      Present : Memory;
   end Board;

end Devices.Shared_CORE_Memory;
