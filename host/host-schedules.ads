--  SPDX-License-Identifier: Apache-2.0

--  What --schedule says (FRM-5), for every program that has the option.

package Host.Schedules is

   --  For texts that explain it.
   Names : constant String := "report or fast";

   --  Raises Bad_Input.
   function Schedule_Of (Value : String) return Schedule_Name;

end Host.Schedules;
