--  SPDX-License-Identifier: Apache-2.0

with Telemetry;       use Telemetry;
with URVOS;           use URVOS;
with URV.CORE_Layout; use URV.CORE_Layout;
with URV.Errors;      use URV.Errors;
with URV.Link_Errors; use URV.Link_Errors;

package body URV.LOG_Task with SPARK_Mode is

   procedure Initialise is
      Log   : constant Error_Log  := Errors.Contents;
      Tally : constant Statistics := Telemetry_Board.Tally;
      Last  : constant Progress   := Seen.Contents;
   begin
      Seen.Write (At_Start (Last, Log, Tally));
   end Initialise;

   procedure Run_Transaction is
      Tally      : constant Statistics := Telemetry_Board.Tally;
      Last       : constant Progress   := Seen.Contents;
      Fresh      : Count;
      All_Errors : Logs.Summary;
      History    : Logs.History;
   begin
      for Error in Link_Error loop
         Fresh := New_Errors (Last, Tally, Error);
         if Fresh > 0 then
            Errors.Report_Several (Error, Fresh, To_Word (Fresh));
         end if;
      end loop;

      All_Errors := Errors.Summary;
      CORE_Memory.Write_Status (To_Status (All_Errors));
      History := Errors.History_Of (Last.Kind_In_Turn);
      CORE_Memory.Write_Log (Row_Of (Last.Kind_In_Turn), To_Row (History));
      Seen.Write (After (Last, Tally));
   end Run_Transaction;

end URV.LOG_Task;
