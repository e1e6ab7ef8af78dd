--  SPDX-License-Identifier: Apache-2.0

with URV.Buffers; use URV.Buffers;
with URV.Errors;  use URV.Errors;

package body GSC with SPARK_Mode is

   procedure Run_Step
     (Name      : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call)
   is
      Set           : constant Schedule_Name := Schedule.Contents;
      Unused_Is_New : Boolean;
   begin
      if First_Run then
         case Name is
            when AD_Task        => AD.Initialise;
            when TELIN_Task     => TELIN.Initialise;
            when CORE_Task      => CORE.Initialise;
            when LOG_Task       => LOG.Initialise;
            when SELF_TEST_Task => SELF_TEST.Initialise;
            when others         => null;
         end case;
      else
         case Name is
            when AD_Task        => AD.Run_Transaction (Now);
            when TELIN_Task     =>
               TELIN.Run_Transaction (Now, Unused_Is_New);
            when GDCIN_Task     => GDCIN.Run_Transaction;
            when GDCOUT_Task    => GDCOUT.Run_Transaction;
            when TELOUT_Task    => TELOUT.Run_Transaction;
            when CORE_Task      => CORE.Run_Transaction;
            when LOG_Task       => LOG.Run_Transaction;
            when SELF_TEST_Task => SELF_TEST.Run_Transaction;
         end case;
      end if;
      Call :=
        (Next_Frame_Call,
         Offset => Task_List (Name) (Set).Offset,
         others => <>);
      if Name = AD_Task then
         AD.Await_Scan (Call);
      end if;
   end Run_Step;

   procedure Reset_Variables is
   begin
      AD_Board.Initialise;
      Status.Write (No_Error);
      Sealing.Restart;
      ADINT_Variable.Reset;
      AD_Variable.Reset;
      TELIN_Variable.Reset;
      Uplink_Variable.Reset;
      Downlink_Variable.Reset;
      TELOUT_Variable.Reset;
      Console_Orders.Reset;
      Recorder_Blocks.Reset;
      Log_Receiver.Restart;
      GDCIN.Reset;
   end Reset_Variables;

   procedure Restart_Variables is
   begin
      AD_Board.Initialise;
      Status.Write (No_Error);
      ADINT_Variable.Restart;
      AD_Variable.Restart;
      TELIN_Variable.Restart;
      Uplink_Variable.Restart;
      Downlink_Variable.Restart;
      TELOUT_Variable.Restart;
      Console_Orders.Restart;
      Recorder_Blocks.Restart;
      Log_Receiver.Restart;
   end Restart_Variables;

   procedure Set_Time (Now : Clock_Tick) is
   begin
      Errors.Set_Time (Now);
   end Set_Time;

   procedure Report_Overrun (Id : Task_Id) is
   begin
      Errors.Report (Task_Overrun, Word (Id));
   end Report_Overrun;

end GSC;
