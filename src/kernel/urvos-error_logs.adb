--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Error_Logs with SPARK_Mode is

   function Next_Occurred (Log : Error_Log; Kind : Error_Kind)
                           return Error_Kind
   is
      Result : Error_Kind := Kind;
   begin
      for Step in Error_Kind loop
         Result := Following (Result);
         if Has_Occurred (Log, Result) then
            return Result;
         end if;
         pragma Loop_Invariant
           (not Has_Occurred (Log, Following (Kind)));
      end loop;
      return Kind;
   end Next_Occurred;

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
