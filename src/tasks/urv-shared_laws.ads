--  SPDX-License-Identifier: Apache-2.0

--  What the laws remember from frame to frame, and what they are set to
--  (EXT-3, EXT-5): kept over a warm start.

pragma SPARK_Mode;

with URVOS.Shared_Data;
with URV.Laws;

package URV.Shared_Laws is

   package Memories is new URVOS.Shared_Data
     (URV.Laws.Memory, Initial => URV.Laws.At_Start);

   package Settings is new URVOS.Shared_Data
     (URV.Laws.Settings, Initial => URV.Laws.Laws_Off);

end URV.Shared_Laws;
