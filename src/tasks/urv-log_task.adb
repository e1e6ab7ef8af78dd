with URV.CORE_Layout;
with URV.Link_Errors; use URV.Link_Errors;

package body URV.LOG_Task
  with
    SPARK_Mode,
    Refined_State => (Seen => (Seen_Tally, Kind_In_Turn))
is

   Seen_Tally : Statistics := (others => 0);

   --  The kind whose row is written next.
   Kind_In_Turn : Error_Kind := Error_Kind'First;

   procedure Initialise is
      Log : Error_Log;
   begin
      Kind_In_Turn := Error_Kind'First;
      Inspect_Log (Log);
      if Logs.History_Of (Log, Warm_Reset).Occurrences = 0
        and then Logs.History_Of (Log, Processor_Restart).Occurrences = 0
      then
         Inspect_Link (Seen_Tally);
      end if;
   end Initialise;

   procedure Run_Transaction is
      Tally : Statistics;
      Fresh : Count;
      Log   : Error_Log;
   begin
      Inspect_Link (Tally);
      for Error in Link_Error loop
         Fresh :=
           New_Since (Counted (Seen_Tally, Error), Counted (Tally, Error));
         if Fresh > 0 then
            Report_Several (Error, Fresh, CORE_Layout.To_Word (Fresh));
         end if;
      end loop;
      Seen_Tally := Tally;

      Inspect_Log (Log);
      Write_Status (CORE_Layout.To_Status (Log));
      Write_Log
        (CORE_Layout.Row_Of (Kind_In_Turn),
         CORE_Layout.To_Row (Logs.History_Of (Log, Kind_In_Turn)));
      Kind_In_Turn :=
        (if Kind_In_Turn = Error_Kind'Last then Error_Kind'First
         else Error_Kind'Succ (Kind_In_Turn));
   end Run_Transaction;

end URV.LOG_Task;
