--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Shared_Error_Logs with SPARK_Mode is

   protected body Shared_Log is

      procedure Set_Time (Tick_Now : Clock_Tick) is
      begin
         Now := Tick_Now;
      end Set_Time;

      procedure Report (Error : Logs.Error_Kind; Detail : Word) is
      begin
         Logs.Add (Present, Error, Now, Detail);
      end Report;

      procedure Report_Several
        (Error     : Logs.Error_Kind;
         How_Often : Logs.Positive_Count;
         Detail    : Word)
      is
      begin
         Logs.Add (Present, Error, Now, Detail, How_Often);
      end Report_Several;

      procedure Start (Condition : Start_Condition; Passed : Boolean) is
      begin
         Present := Logs.After_Start (Present, Condition, Passed);
      end Start;

      procedure Clear is
      begin
         Present := Logs.Empty_Log;
      end Clear;

      function Contents return Logs.Error_Log is (Present);

      function Summary return Logs.Summary is (Logs.Summary_Of (Present));

      function History_Of (Kind : Logs.Error_Kind) return Logs.History is
        (Logs.History_Of (Present, Kind));

      function Next_Occurred (Kind : Logs.Error_Kind) return Logs.Error_Kind
      is
        (if Logs.Total (Present) = 0 then Kind
         else Logs.Next_Occurred (Present, Kind));

      function Time return Clock_Tick is (Now);

   end Shared_Log;

end URVOS.Shared_Error_Logs;
