--  SPDX-License-Identifier: Apache-2.0

with Host.Complaints; use Host.Complaints;

package body Host.Schedules is

   function Schedule_Of (Value : String) return Schedule_Name is
   begin
      if Value = "report" then
         return URVOS.Task_Trees.Report;
      elsif Value = "fast" then
         return URVOS.Task_Trees.Fast;
      else
         Refuse
           ("--schedule: " & Quoted (Value)
            & " is neither ""report"" nor ""fast""");
      end if;
   end Schedule_Of;

end Host.Schedules;
