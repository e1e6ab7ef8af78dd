--  SPDX-License-Identifier: Apache-2.0

with URVOS;           use URVOS;
with URV.CORE_Layout; use URV.CORE_Layout;
with URV.Link_Errors; use URV.Link_Errors;

package body URV.LOG_Task with SPARK_Mode is

   procedure Initialise is
      Log   : constant Error_Log  := Errors.Contents;
      Tally : constant Statistics := Telemetry_Board.Tally;
      Now   : Progress            := Seen.Contents;
   begin
      Now.Kind_In_Turn := Error_Kind'First;
      if Logs.History_Of (Log, Warm_Reset).Occurrences = 0
        and then Logs.History_Of (Log, Processor_Restart).Occurrences = 0
      then
         Now.Seen_Tally := Tally;
      end if;
      Seen.Write (Now);
   end Initialise;

   procedure Run_Transaction is
      Tally : constant Statistics := Telemetry_Board.Tally;
      Last  : constant Progress   := Seen.Contents;
      Kind  : constant Error_Kind := Last.Kind_In_Turn;
      Fresh : Count;
      Log   : Error_Log;
   begin
      for Error in Link_Error loop
         Fresh :=
           New_Since
             (Counted (Last.Seen_Tally, Error), Counted (Tally, Error));
         if Fresh > 0 then
            Errors.Report_Several (Error, Fresh, To_Word (Fresh));
         end if;
      end loop;

      Log := Errors.Contents;
      CORE_Memory.Write_Status (To_Status (Log));
      CORE_Memory.Write_Log
        (Row_Of (Kind), To_Row (Logs.History_Of (Log, Kind)));
      Seen.Write
        ((Seen_Tally   => Tally,
          Kind_In_Turn =>
            (if Kind = Error_Kind'Last then Error_Kind'First
             else Error_Kind'Succ (Kind))));
   end Run_Transaction;

end URV.LOG_Task;
