--  SPDX-License-Identifier: Apache-2.0

--  The kinds of errors of a node, and their log (report, the sections "Error
--  handling" of 4 and 5, 3.5, appendix A; EXT-1, SEM-2).
--
--  A kind names the fault and the unit that detected it. Each report carries a
--  word of detail, described below; without a description it is 0.
--  docs/error-log.md has the report's sections for each kind.

with URVOS.Error_Logs;

package URV.Errors with Pure, SPARK_Mode is

   type Error_Kind is

      --  Tasks. Detail of the first: the number of channels converted; of the
      --  second: the converter's word.
     (AD_No_Scan,              --  no complete scan for this frame
      AD_Unexpected_Interrupt, --  the board interrupted outside a scan
      Scan_Not_Consumed,       --  ADINT_variable was overwritten
      Image_Not_Consumed,      --  AD_variable was overwritten
      TELIN_No_Block,          --  nothing new from the telemetry board
      Input_Not_Consumed,      --  TELIN_variable was overwritten
      No_Input,                --  nothing new in TELIN_variable

      --  A word beyond 12 bits (D-11). Detail: the place of the first such
      --  word in the buffer, from 1; of the aircraft's own sensors its type
      --  code.
      Input_Out_Of_Range,

      --  Detail: 0, or No_Image_For_Laws, below.
      No_Image,                --  nothing new in AD_, sensors_variable
      Uplink_Not_Consumed,     --  uplink_variable was overwritten
      Downlink_Not_Consumed,   --  downlink_variable was overwritten
      Output_Not_Consumed,     --  TELOUT_variable was overwritten
      No_Output,               --  nothing new in TELOUT_variable
      TELOUT_Overwrote_Block,  --  no transmit buffer was available
      Commands_Not_Consumed,   --  commands_, PWM_variable was overwritten
      No_Commands,             --  nothing new in PWM_, commands_variable
      CORE_No_Uplink,          --  nothing new in uplink_variable
      CORE_No_Downlink,        --  nothing new in downlink_variable

      --  Telemetry board; the log task looks once a frame. Detail: the number
      --  of events since its last look.
      Link_Block_Bad,          --  wrong checksum, or cut short
      Link_Block_Not_Taken,    --  both receive buffers were full
      Link_Block_Scrapped,     --  not confirmed in two transmissions
      Link_Block_Cleared,      --  both transmit buffers were full
      Link_Reset,              --  dead space: the other side was silent

      --  Kernel. Detail: the identification of the task.
      Task_Overrun,            --  released late, or still running
      Semaphore_Not_Claimed,   --  P went on without it after two ticks
      Semaphore_Not_Owned,     --  V of another task's claim

      --  Starts. Detail of the third: the result word; of the last: the number
      --  of checks that have found a difference.
      Warm_Reset,              --  the reset switch
      Processor_Restart,       --  an unexpected exception
      Self_Test_Failed,        --  before the start, or RAM in flight
      ROM_Check_Failed,        --  in flight

      --  Control laws. Detail of the first: the place of the state in
      --  URV.Link_Loss.Link_State, from 0; of the second: the sensor's place
      --  in the downlink, from 1.
      Link_Loss_State,         --  the link was lost, or is back
      Sensor_Not_Valid,        --  range, rate or stuck

      --  Sealed link. Detail: the reason, by its place in URV.Seals.Refused,
      --  from 1.
      Block_Refused,           --  a block that is not the peer's

      --  Detail: the surface's place in the downlink, from 1; for the
      --  throttle, that of the engine's speed.
      Surface_Failed,          --  it does not follow its servo's words

      --  Type codes (EXT-2). Detail of the first: the code; of the second: the
      --  reason, by its place in URV.Configurations.Refused, from 1.
      Unknown_Code,            --  an unknown code; its word is discarded
      Configuration_Refused,   --  a configuration from the ground

      --  Test cards (FTI-2, FTI-4). Detail of the first: the reason, by its
      --  place in URV.Test_Runs.Refused, from 1; of the second: the slot * 16
      --  + the place in URV.Test_Runs.Verdict, from 0.
      Card_Refused,            --  a test card from the ground
      Card_Ended);             --  a test card has ended, or did not start

   --  The detail of a No_Image of the laws.
   No_Image_For_Laws : constant := 1;

   package Logs is new URVOS.Error_Logs (Error_Kind);

   subtype Error_Log is Logs.Error_Log;

end URV.Errors;
