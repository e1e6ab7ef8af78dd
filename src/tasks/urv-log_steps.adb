--  SPDX-License-Identifier: Apache-2.0

package body URV.LOG_Steps with SPARK_Mode is

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

end URV.LOG_Steps;
