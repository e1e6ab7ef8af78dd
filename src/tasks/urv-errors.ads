--  The error cases of the tasks (report, the sections "Error handling" of
--  4 and 5), counted.

with URVOS; use URVOS;

package URV.Errors with Pure, SPARK_Mode is

   type Error_Kind is
     (AD_No_Scan,              --  no complete scan for this frame
      AD_Unexpected_Interrupt, --  the board interrupted outside a scan
      Scan_Not_Consumed,       --  ADINT_variable was overwritten
      Image_Not_Consumed,      --  AD_variable was overwritten
      TELIN_No_Block,          --  nothing new from the telemetry board
      Input_Not_Consumed,      --  TELIN_variable was overwritten
      No_Input,                --  nothing new in TELIN_variable
      Input_Out_Of_Range,      --  a word that exceeds 12 bits (D-11)
      No_Image,                --  nothing new in AD_variable
      Uplink_Not_Consumed,     --  uplink_variable was overwritten
      Downlink_Not_Consumed,   --  downlink_variable was overwritten
      Output_Not_Consumed,     --  TELOUT_variable was overwritten
      No_Output,               --  nothing new in TELOUT_variable
      TELOUT_Overwrote_Block,  --  no transmit buffer was available
      Commands_Not_Consumed,   --  PWM_variable was overwritten
      No_Commands,             --  nothing new in PWM_variable
      CORE_No_Uplink,          --  nothing new in uplink_variable
      CORE_No_Downlink);       --  nothing new in downlink_variable

   type Error_Counts is array (Error_Kind) of Count;

   No_Errors : constant Error_Counts := (others => 0);

   --  One more error of a kind; the others' counts stay.
   procedure Count_Error (Counts : in out Error_Counts; Kind : Error_Kind)
   with
     Global => null,
     Post   =>
       Counts =
         (Counts'Old with delta Kind => Incremented (Counts'Old (Kind)));

end URV.Errors;
