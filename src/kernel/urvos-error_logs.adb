--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Error_Logs with SPARK_Mode is

   procedure Add
     (Log       : in out Error_Log;
      Kind      : Error_Kind;
      Now       : Clock_Tick;
      Detail    : Word;
      How_Often : Positive_Count := 1)
   is
   begin
      Log.Histories (Kind) :=
        Extended (Log.Histories (Kind), Now, Detail, How_Often);
      Log.Sum_Of_All := Sum (Log.Sum_Of_All, How_Often);
      Log.Last_Kind := Kind;
   end Add;

end URVOS.Error_Logs;
