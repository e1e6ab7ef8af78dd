--  SPDX-License-Identifier: Apache-2.0

--  The error cases of a node and the log of them (report, the sections
--  "Error handling" of 4 and 5, 3.5, appendix A; EXT-1, SEM-2).
--
--  A kind says what went wrong and who saw it. Each report brings a word of
--  detail; what it holds stands below, and where nothing is said it is 0.
--  docs/error-log.md has the report's sections for each kind.

with URVOS.Error_Logs;

package URV.Errors with Pure, SPARK_Mode is

   type Error_Kind is

      --  Tasks. Detail of the first: how many channels the converter had
      --  done; of the second: the word it gave.
     (AD_No_Scan,              --  no complete scan for this frame
      AD_Unexpected_Interrupt, --  the board interrupted outside a scan
      Scan_Not_Consumed,       --  ADINT_variable was overwritten
      Image_Not_Consumed,      --  AD_variable was overwritten
      TELIN_No_Block,          --  nothing new from the telemetry board
      Input_Not_Consumed,      --  TELIN_variable was overwritten
      No_Input,                --  nothing new in TELIN_variable

      --  A word that exceeds 12 bits (D-11). Detail: its place in the
      --  buffer, from 1; of several the first.
      Input_Out_Of_Range,

      --  Detail: 0, or that of the laws, below.
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

      --  Telemetry board; the log task looks once a frame. Detail: how many
      --  there were since it last did.
      Link_Block_Bad,          --  wrong checksum, or cut short
      Link_Block_Not_Taken,    --  both receive buffers were full
      Link_Block_Scrapped,     --  not confirmed in two transmissions
      Link_Block_Cleared,      --  both transmit buffers were full
      Link_Reset,              --  dead space: the other side was silent

      --  Kernel. Detail: the identification of the task.
      Task_Overrun,            --  released late, or still running
      Semaphore_Not_Claimed,   --  P went on without it after two ticks
      Semaphore_Not_Owned,     --  V of what someone else has claimed

      --  Starts. Detail of the third: the result word; of the last: how
      --  many checks have found a difference.
      Warm_Reset,              --  the reset switch
      Processor_Restart,       --  an unexpected exception
      Self_Test_Failed,        --  before the start
      ROM_Check_Failed,        --  in flight

      --  Control laws. Detail of the first: the place of the state in
      --  URV.Link_Loss.Link_State, from 0; of the second: the sensor's place
      --  in the downlink, from 1.
      Link_Loss_State,         --  the link was lost for so long, or is back
      Sensor_Not_Valid,        --  range, rate or stuck

      --  Sealed link. Detail: why, as URV.Seals.Refused has it, from 1.
      Block_Refused,           --  a block came that is not the peer's

      --  Detail: the surface's place in the downlink, from 1; of the throttle
      --  that of the engine's speed.
      Surface_Failed,          --  it does not follow its servo's words

      --  Type codes (EXT-2). Detail of the first: the code; of the second:
      --  why, as URV.Configurations.Refused has it, from 1.
      Unknown_Code,            --  nobody knows what it is: it goes nowhere
      Configuration_Refused);  --  one that the ground sent

   --  The detail of a No_Image of the laws.
   No_Image_For_Laws : constant := 1;

   package Logs is new URVOS.Error_Logs (Error_Kind);

   subtype Error_Log is Logs.Error_Log;

end URV.Errors;
