--  SPDX-License-Identifier: Apache-2.0

--  The laws' memory from frame to frame, their settings, and the ground's
--  later configuration (EXT-2, EXT-3, EXT-5). A warm start keeps them.

pragma SPARK_Mode;

with URVOS.Shared_Data;
with URV.Configurations;
with URV.Laws;

package URV.Shared_Laws is

   package Memories is new URVOS.Shared_Data
     (URV.Laws.Memory, Initial => URV.Laws.At_Start);

   package Settings is new URVOS.Shared_Data
     (URV.Laws.Settings, Initial => URV.Laws.Laws_Off);

   package Configured is new URVOS.Shared_Data
     (URV.Configurations.Setting,
      Initial => URV.Configurations.Nothing_Set);

end URV.Shared_Laws;
