--  SPDX-License-Identifier: Apache-2.0

--  The ground's node in real time, as it is proved: with the steps of the
--  partition, except for what catches their exceptions and measures them
--  (D-9). Its processors share no data but by protected objects, whichever
--  of them runs a task (EXT-4).

with URVOS.Task_Trees; use URVOS.Task_Trees;

package Real_Time_GSC with SPARK_Mode is

   --  Power up.
   procedure Switch_On (Processors : Processor_Number);

end Real_Time_GSC;
