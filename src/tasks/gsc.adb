package body GSC with SPARK_Mode is

   procedure Run_Transaction (Who : Task_Name) is
   begin
      case Who is
         when AD_Task     => AD.Run_Transaction;
         when TELIN_Task  => TELIN.Run_Transaction;
         when GDCIN_Task  => GDCIN.Run_Transaction;
         when GDCOUT_Task => GDCOUT.Run_Transaction;
         when TELOUT_Task => TELOUT.Run_Transaction;
         when CORE_Task   => CORE.Run_Transaction;
         when LOG_Task    => LOG.Run_Transaction;
      end case;
   end Run_Transaction;

   procedure Cold_Start (Now : Clock_Tick) is
   begin
      --  Boards
      CORE_Memory.Clear;
      Telemetry_Board.Clear_Transmit_Half;
      AD_Board.Initialise;

      --  Variables
      ADINT_Variable.Reset;
      AD_Variable.Reset;
      TELIN_Variable.Reset;
      Uplink_Variable.Reset;
      Downlink_Variable.Reset;
      TELOUT_Variable.Reset;

      --  Error log
      Errors.Set_Time (Now);
      Errors.Clear;
      LOG.Forget;

      --  Tasks
      AD.Initialise;
      TELIN.Initialise;
      CORE.Initialise;
      Executive.Start (Now);
   end Cold_Start;

   procedure Clock_Interrupt (Now : Clock_Tick) is
   begin
      Errors.Set_Time (Now);
      Executive.Run_Due_Tasks (Now);
   end Clock_Interrupt;

end GSC;
