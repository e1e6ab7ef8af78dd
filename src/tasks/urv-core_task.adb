--  SPDX-License-Identifier: Apache-2.0

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URV.Buffers;         use URV.Buffers;
with URV.CORE_Layout;     use URV.CORE_Layout;
with URV.Errors;          use URV.Errors;

package body URV.CORE_Task with SPARK_Mode is

   procedure Initialise is
   begin
      Codes_Wanted.Write (True);
   end Initialise;

   procedure Run_Transaction is
      First_Run : constant Boolean := Codes_Wanted.Contents;
      Uplink    : Uplink_Buffer;
      Downlink  : Downlink_Buffer;
      Fresh     : Boolean;
      Unknown   : Place_Or_None;
   begin
      if First_Run then
         CORE_Memory.Write_Codes
           (Uplink_Type_Codes, Downlink_Type_Codes, Status_Type_Codes);
         Codes_Wanted.Write (False);
      end if;

      Uplink_Variable.Receive (Uplink, Fresh);
      if Fresh then
         declare
            Area : constant Coded_Uplink := CORE_Memory.Uplink_Area;
         begin
            CORE_Memory.Write_Uplink
              (Stored (Area.Codes, Area.Words, Uplink));
            Unknown := First_Unknown_Uplink (Area.Codes);
            if Unknown > 0 then
               Errors.Report
                 (Unknown_Code, Area.Codes (Item_Number (Unknown)));
               Codes_Wanted.Write (True);
            end if;
         end;
      else
         Errors.Report (CORE_No_Uplink, 0);
      end if;

      Downlink_Variable.Receive (Downlink, Fresh);
      if Fresh then
         declare
            Area : constant Coded_Downlink := CORE_Memory.Downlink_Area;
         begin
            CORE_Memory.Write_Downlink
              (Stored (Area.Codes, Area.Words, Downlink));
            Unknown := First_Unknown_Downlink (Area.Codes);
            if Unknown > 0 then
               Errors.Report
                 (Unknown_Code, Area.Codes (Item_Number (Unknown)));
               Codes_Wanted.Write (True);
            end if;
         end;
      else
         Errors.Report (CORE_No_Downlink, 0);
      end if;
   end Run_Transaction;

end URV.CORE_Task;
