--  SPDX-License-Identifier: Apache-2.0

with URVOS;           use URVOS;
with URV.CORE_Memory; use URV.CORE_Memory;
with URV.Errors;      use URV.Errors;

package body URV.Start_Records with SPARK_Mode is

   procedure Record_Start
     (Condition : URVOS.Starts.Start_Condition;
      Result    : Test_Result)
   is
      CORE   : constant Memory := CORE_Memory.Contents;
      Counts : Status_Array (Cold_Starts .. Processor_Restarts);
      Which  : constant Status_Item :=
        (case Condition is
            when Cold_Start                => Cold_Starts,
            when Starts.Warm_Reset         => Warm_Resets,
            when Starts.Processor_Restart  => Processor_Restarts);
   begin
      Counts := CORE.Status (Counts'Range);
      Counts (Which) := Incremented (Counts (Which));
      CORE_Memory.Write_Status
        ((URV.CORE_Memory.Start_Condition =>
            Word (Starts.Start_Condition'Pos (Condition)) + 1));
      CORE_Memory.Write_Status (Counts);
      CORE_Memory.Write_Status ((Self_Test_Result => To_Word (Result)));

      Errors.Start (Condition, Result.Passed);
      case Condition is
         when Cold_Start =>
            null;
         when Starts.Warm_Reset =>
            Errors.Report (URV.Errors.Warm_Reset, 0);
         when Starts.Processor_Restart =>
            Errors.Report (URV.Errors.Processor_Restart, 0);
      end case;
      if not Result.Passed then
         Errors.Report (Self_Test_Failed, To_Word (Result));
      end if;
   end Record_Start;

end URV.Start_Records;
