--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Start_Phases with SPARK_Mode is

   procedure Run
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean)
   is
      Result : Test_Result;
   begin
      Set_Time (Now);
      Test (Condition, Result);
      Passed := Result.Passed;
      if Passed then
         case Condition is
            when Starts.Cold_Start        => Cold_Start;
            when Starts.Warm_Reset        => Warm_Reset;
            when Starts.Processor_Restart => Processor_Restart;
         end case;
      end if;

      --  Recorded after a cold start, which clears CORE memory and the log.
      Record_Start (Condition, Result);
      if not Passed then
         Refuse;
      end if;
   end Run;

end URVOS.Start_Phases;
