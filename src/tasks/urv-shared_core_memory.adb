--  SPDX-License-Identifier: Apache-2.0

with URV.CORE_Layout; use URV.CORE_Layout;

package body URV.Shared_CORE_Memory with SPARK_Mode is

   protected body Board is

      procedure Clear is
      begin
         Present := Cleared;
      end Clear;

      procedure Mark_Old is
      begin
         Present := Marked_Old (Present);
      end Mark_Old;

      procedure Write_Codes
        (Uplink_Codes   : Uplink_Code_List;
         Downlink_Codes : Downlink_Code_List;
         Status_Codes   : Status_Words)
      is
      begin
         Present.Uplink_Codes := Uplink_Codes;
         Present.Downlink_Codes := Downlink_Codes;
         Present.Status_Codes := Status_Codes;
      end Write_Codes;

      function Uplink_Area return Coded_Uplink is
        (Codes => Present.Uplink_Codes, Words => Present.Uplink);

      function Downlink_Area return Coded_Downlink is
        (Codes => Present.Downlink_Codes, Words => Present.Downlink);

      procedure Write_Uplink (Words : Uplink_Buffer) is
      begin
         Present.Uplink := Words;
      end Write_Uplink;

      procedure Write_Downlink (Words : Downlink_Buffer; Frame : Frame_Words)
      is
      begin
         Present.Downlink := Words;
         Present.Frame := Frame;
      end Write_Downlink;

      procedure Store_Uplink (Words : Uplink_Buffer; Is_Stored : out Boolean)
      is
      begin
         Is_Stored := Is_Usual (Present.Uplink_Codes);
         if Is_Stored then
            Present.Uplink := Words;
         end if;
      end Store_Uplink;

      procedure Store_Downlink
        (Words     : Downlink_Buffer;
         Frame     : Frame_Words;
         Is_Stored : out Boolean)
      is
      begin
         Is_Stored := Is_Usual (Present.Downlink_Codes);
         if Is_Stored then
            Present.Downlink := Words;
            Present.Frame := Frame;
         end if;
      end Store_Downlink;

      procedure Write_Status (Words : Status_Array) is
      begin
         Present.Status (Words'Range) := Words;
      end Write_Status;

      procedure Write_Log (Which : Log_Row_Number; Row : Log_Row) is
      begin
         Present.Log (Which) := Row;
      end Write_Log;

      procedure Write_Aircraft_Log (Which : Log_Row_Number; Row : Log_Row) is
      begin
         Present.Aircraft_Log (Which) := Row;
      end Write_Aircraft_Log;

      function Contents return Memory is (Present);

   end Board;

end URV.Shared_CORE_Memory;
