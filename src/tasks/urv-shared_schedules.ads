--  SPDX-License-Identifier: Apache-2.0

--  The node's schedule (FRM-2, FRM-5), set before it is switched on.

pragma SPARK_Mode;

with URVOS.Shared_Data;
with URVOS.Task_Trees; use URVOS.Task_Trees;

package URV.Shared_Schedules is

   package Stores is new URVOS.Shared_Data (Schedule_Name, Initial => Report);

   subtype Store is Stores.Store;

end URV.Shared_Schedules;
