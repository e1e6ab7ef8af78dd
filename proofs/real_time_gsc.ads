--  SPDX-License-Identifier: Apache-2.0

--  The ground's node in real time, for the proof. It has the steps of the
--  partition, without the code that catches their exceptions and measures them
--  (D-9). Its processors share data only through protected objects, whichever
--  processor runs a task (EXT-4).

with URVOS.Task_Trees; use URVOS.Task_Trees;

package Real_Time_GSC with SPARK_Mode is

   --  Switches the node on.
   procedure Switch_On (Processors : Processor_Number);

end Real_Time_GSC;
