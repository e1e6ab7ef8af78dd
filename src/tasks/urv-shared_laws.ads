--  SPDX-License-Identifier: Apache-2.0

--  LAW's memory from frame to frame (the laws' memory, the ground's settings,
--  the monitor of surfaces), and the laws' settings (EXT-2, EXT-3, EXT-5,
--  EXT-6). A warm start keeps them.

pragma SPARK_Mode;

with URVOS.Shared_Data;
with URV.LAW_Steps;
with URV.Laws;

package URV.Shared_Laws is

   package Memories is new URVOS.Shared_Data
     (URV.LAW_Steps.Kept, Initial => URV.LAW_Steps.At_Start);

   package Settings is new URVOS.Shared_Data
     (URV.Laws.Settings, Initial => URV.Laws.Laws_Off);

end URV.Shared_Laws;
