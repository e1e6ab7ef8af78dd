with Devices.CORE_Memory; use Devices.CORE_Memory;
with URV.Errors; use URV.Errors;

package body GSC with SPARK_Mode is

   --  A count in one word.
   function To_Word (Number : Count) return Word is
     (if Number > Count (Word'Last) then Word'Last else Word (Number));

   procedure Write_ROM_Result (Good_Passes, Bad_Passes : Count) is
   begin
      CORE_Memory.Write_Status
        ((ROM_Passes   => To_Word (Good_Passes),
          ROM_Failures => To_Word (Bad_Passes)));
      if Bad_Passes > 0 then
         Status.Write (ROM_Differs);
      end if;
   end Write_ROM_Result;

   procedure Report_ROM_Failure (Detail : Word) is
   begin
      Errors.Report (ROM_Check_Failed, Detail);
   end Report_ROM_Failure;

   procedure Run_Step (Who : Task_Name; First_Run : Boolean) is
   begin
      if First_Run then
         case Who is
            when AD_Task        => AD.Initialise;
            when TELIN_Task     => TELIN.Initialise;
            when CORE_Task      => CORE.Initialise;
            when LOG_Task       => LOG.Initialise;
            when SELF_TEST_Task => SELF_TEST.Initialise;
            when others         => null;
         end case;
      else
         case Who is
            when AD_Task        => AD.Run_Transaction;
            when TELIN_Task     => TELIN.Run_Transaction;
            when GDCIN_Task     => GDCIN.Run_Transaction;
            when GDCOUT_Task    => GDCOUT.Run_Transaction;
            when TELOUT_Task    => TELOUT.Run_Transaction;
            when CORE_Task      => CORE.Run_Transaction;
            when LOG_Task       => LOG.Run_Transaction;
            when SELF_TEST_Task => SELF_TEST.Run_Transaction;
         end case;
      end if;
   end Run_Step;

   --  What the telemetry board received before the start is not acted on
   --  (SAF-4).
   procedure Discard_Received;

   procedure Discard_Received is
      Unused_Data          : Telemetry.Block_Data;
      Unused_Fresh         : Boolean;
      Unused_Ever_Received : Boolean;
   begin
      Telemetry_Board.Take
        (Unused_Data, Unused_Fresh, Unused_Ever_Received);
   end Discard_Received;

   procedure Cold_Start is
   begin
      --  Boards
      CORE_Memory.Clear;
      Telemetry_Board.Clear_Transmit_Half;
      Discard_Received;
      AD_Board.Initialise;

      --  Variables
      ADINT_Variable.Reset;
      AD_Variable.Reset;
      TELIN_Variable.Reset;
      Uplink_Variable.Reset;
      Downlink_Variable.Reset;
      TELOUT_Variable.Reset;

      --  Error log and status
      Errors.Clear;
      Status.Write (No_Error);
   end Cold_Start;

   procedure Warm_Start is
   begin
      --  Boards
      Telemetry_Board.Clear_Transmit_Half;
      Discard_Received;
      AD_Board.Initialise;

      --  Variables
      ADINT_Variable.Restart;
      AD_Variable.Restart;
      TELIN_Variable.Restart;
      Uplink_Variable.Restart;
      Downlink_Variable.Restart;
      TELOUT_Variable.Restart;

      Status.Write (No_Error);
   end Warm_Start;

   procedure Refuse_Start is
   begin
      Telemetry_Board.Clear_Transmit_Half;
   end Refuse_Start;

end GSC;
