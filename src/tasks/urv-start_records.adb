package body URV.Start_Records with SPARK_Mode is

   procedure Record_Start
     (Condition : Starts.Start_Condition;
      Result    : Test_Result)
   is
      CORE   : Memory;
      Counts : Status_Array (Cold_Starts .. Processor_Restarts);
      Which  : constant Status_Item :=
        (case Condition is
            when Cold_Start                => Cold_Starts,
            when Starts.Warm_Reset         => Warm_Resets,
            when Starts.Processor_Restart  => Processor_Restarts);
   begin
      Inspect_CORE (CORE);
      Counts := CORE.Status (Counts'Range);
      Counts (Which) := Incremented (Counts (Which));
      Write_Status
        ((Devices.CORE_Memory.Start_Condition =>
            Word (Starts.Start_Condition'Pos (Condition)) + 1));
      Write_Status (Counts);
      Write_Status ((Self_Test_Result => To_Word (Result)));

      case Condition is
         when Cold_Start =>
            null;
         when Starts.Warm_Reset =>
            Report (Errors.Warm_Reset, 0);
         when Starts.Processor_Restart =>
            Report (Errors.Processor_Restart, 0);
      end case;
      if not Result.Passed then
         Report (Self_Test_Failed, To_Word (Result));
      end if;
   end Record_Start;

end URV.Start_Records;
