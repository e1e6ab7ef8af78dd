--  SPDX-License-Identifier: Apache-2.0

with Kernel_Suite;  use Kernel_Suite;
with Law_Suite;     use Law_Suite;
with Link_Suite;    use Link_Suite;
with Node_Suite;    use Node_Suite;
with Task_Suite;    use Task_Suite;
with Bare_Nodes_Tests;
with Buffers_Tests;
with Frames_Tests;
with Nodes_Tests;

package body All_Tests is

   function Suite (Briefly : Boolean)
     return AUnit.Test_Suites.Access_Test_Suite
   is
      Result : constant AUnit.Test_Suites.Access_Test_Suite :=
        AUnit.Test_Suites.New_Suite;
   begin
      Frames_Tests.Add_To (Result);
      Frame_Locks_Tests.Add_To (Result);
      Bare_Nodes_Tests.Add_To (Result);
      Mailboxes_Tests.Add_To (Result);
      Semaphores_Tests.Add_To (Result);
      Receive_Calls_Tests.Add_To (Result);
      Waiting_Tasks_Tests.Add_To (Result);
      Error_Log_Tests.Add_To (Result);
      Schedulers_Tests.Add_To (Result);
      Scheduler_Histories_Tests.Add_To (Result);
      Executives_Tests.Add_To (Result);
      Clocked_Executives_Tests.Add_To (Result);
      Task_Lists_Tests.Add_To (Result);
      Start_Orders_Tests.Add_To (Result);
      Shared_Nodes_Tests.Add_To (Result);
      if not Briefly then
         Real_Time_Nodes_Tests.Add_To (Result);
      end if;
      Laws_Tests.Add_To (Result);
      Console_Watch_Tests.Add_To (Result);
      LAW_Task_Tests.Add_To (Result);
      Test_Cards_Tests.Add_To (Result);
      Task_Shells_Tests.Add_To (Result);
      Checksum_Tests.Add_To (Result);
      Headers_Tests.Add_To (Result);
      Board_Memory_Tests.Add_To (Result);
      Receivers_Tests.Add_To (Result);
      Senders_Tests.Add_To (Result);
      Buffers_Tests.Add_To (Result);
      Codecs_Tests.Add_To (Result);
      Seal_Tests.Add_To (Result);
      AD_Tests.Add_To (Result);
      Exchange_Tests.Add_To (Result);
      Type_Codes_Tests.Add_To (Result);
      Telemetry_Task_Tests.Add_To (Result);
      PWM_Tests.Add_To (Result);
      Surfaces_Tests.Add_To (Result);
      CORE_Tests.Add_To (Result);
      LOG_Task_Tests.Add_To (Result);
      Recorder_Tests.Add_To (Result);
      Serial_Line_Tests.Add_To (Result);
      Flood_Tests.Add_To (Result);
      Output_Buffers_Tests.Add_To (Result);
      Peer_Watch_Tests.Add_To (Result);
      Guarded_Step_Tests.Add_To (Result);
      Nodes_Tests.Add_To (Result);
      Starts_Tests.Add_To (Result);

      --  These tests take the longest.
      if not Briefly then
         In_Flight_Tests.Add_To (Result);
      end if;
      Self_Test_Tests.Add_To (Result, Briefly);
      Link_Tests.Add_To (Result);
      Slow_Line_Tests.Add_To (Result);
      return Result;
   end Suite;

end All_Tests;
