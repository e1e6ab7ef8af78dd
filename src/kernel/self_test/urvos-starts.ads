--  SPDX-License-Identifier: Apache-2.0

--  The conditions under which a node starts (report, sections 2.3 and 3.1;
--  INI-1).

package URVOS.Starts with Pure, SPARK_Mode is

   type Start_Condition is
     (Cold_Start,           --  power up
      Warm_Reset,           --  the reset switch: every board is reset
      Processor_Restart);   --  an unexpected interrupt or exception

end URVOS.Starts;
