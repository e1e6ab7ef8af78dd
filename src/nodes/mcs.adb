--  SPDX-License-Identifier: Apache-2.0

with Telemetry;   use Telemetry;
with URV.Allocation;
with URV.Buffers; use URV.Buffers;
with URV.Card_Status;
with URV.Errors;  use URV.Errors;
with URV.LAW_Steps;
with URV.PWM_Layout;
with URV.Test_Inputs;

package body MCS with SPARK_Mode is

   --  Look_At_Frame while the lock is in use.
   procedure Ask_Lock (Ticks : Tick_Count; Request : out Frame_Request)
   with
     No_Inline,
     Global => (Input => Telemetry_Board, In_Out => Frame_Lock);

   procedure Ask_Lock (Ticks : Tick_Count; Request : out Frame_Request) is
      Available : Boolean;
   begin
      if Ticks > 0 then
         Available := Telemetry_Board.Has_Received;
         Frame_Lock.Tick (Available);
      end if;
      Request := Frame_Lock.Request;
   end Ask_Lock;

   procedure Look_At_Frame
     (Ticks : Tick_Count; Request : in out Frame_Request)
   is
      Is_Locked : constant Boolean := Frame_Lock.Is_In_Use;
   begin
      if Is_Locked then
         Ask_Lock (Ticks, Request);
      else
         Request.Length := Usual_Length;
      end if;
   end Look_At_Frame;

   procedure Run_Step
     (Name      : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call)
   is
      Set    : constant Schedule_Name := Schedule.Contents;
      Is_New : Boolean;
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
               TELIN.Run_Transaction (Now, Is_New);
               Frame_Lock.Take (Is_New, Now);
            when MDCIN_Task     => MDCIN.Run_Transaction;
            when MDCOUT_Task    => MDCOUT.Run_Transaction (Now);
            when LAW_Task       => LAW.Run_Transaction;
            when PWM_Task       => PWM.Run_Transaction;
            when TELOUT_Task    => TELOUT.Run_Transaction;
            when CORE_Task      => CORE.Run_Transaction;
            when LOG_Task       =>
               LOG.Run_Transaction;
               Flight_Recorder.Record_Frame;
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
      Frame_Lock.Restart;
      Sealing.Restart;
      PWM_Board.Write (URV.PWM_Layout.Safe_Area);
      ADINT_Variable.Reset;
      AD_Variable.Reset;
      TELIN_Variable.Reset;
      Uplink_Variable.Reset;
      Downlink_Variable.Reset;
      TELOUT_Variable.Reset;
      Commands_Variable.Reset;
      Configuration_Variable.Reset;
      Recorder_Requests.Reset;
      Sensors_Variable.Reset;
      PWM_Variable.Reset;
      MDCIN.Reset;
      Recorder.Clear;
      Recorder_Sender.Restart;
      Log_Sender.Restart;
      Law_Memory.Write (URV.LAW_Steps.At_Start);
      Law_Record.Write
        (URV.Shared_Laws.Recorded_Of (URV.LAW_Steps.At_Start));
      Surface_Health.Write (URV.Allocation.All_Well);
      Test_Added.Write (URV.Test_Inputs.Nothing_Added);
      Card_Shown.Write (0);
   end Reset_Variables;

   procedure Restart_Variables is
      Before : constant URV.LAW_Steps.Kept := Law_Memory.Contents;
      Kept   : constant URV.LAW_Steps.Kept :=
        URV.LAW_Steps.Restarted (Before);
   begin
      AD_Board.Initialise;
      Status.Write (No_Error);
      Frame_Lock.Restart;
      ADINT_Variable.Restart;
      AD_Variable.Restart;
      TELIN_Variable.Restart;
      Uplink_Variable.Restart;
      Downlink_Variable.Restart;
      TELOUT_Variable.Restart;
      Commands_Variable.Restart;
      Configuration_Variable.Restart;
      Recorder_Requests.Restart;
      Recorder_Sender.Restart;
      Sensors_Variable.Restart;
      PWM_Variable.Restart;
      Law_Memory.Write (Kept);
      Law_Record.Write (URV.Shared_Laws.Recorded_Of (Kept));
      Card_Shown.Write (URV.Card_Status.Card_Word (Kept.Cards.Run));
   end Restart_Variables;

   procedure Report_Refused_Start is
      Data      : Block_Data;
      Overwrote : Boolean;
   begin
      Sealing.Close
        (Downlink.Words_Of
           (Marked (Neutral_Downlink, URV.Buffers.Self_Test_Failed)),
         Data);
      Telemetry_Board.Put (Data, Overwrote);
      if Overwrote then
         Errors.Report (TELOUT_Overwrote_Block, 0);
      end if;
   end Report_Refused_Start;

   procedure Set_Time (Now : Clock_Tick) is
   begin
      Errors.Set_Time (Now);
   end Set_Time;

   procedure Report_Overrun (Id : Task_Id) is
   begin
      Errors.Report (Task_Overrun, Word (Id));
   end Report_Overrun;

end MCS;
