--  SPDX-License-Identifier: Apache-2.0

--  The test inputs with which the servos' words are made (FTI-3). A warm start
--  keeps them.

pragma SPARK_Mode;

with URVOS.Shared_Data;
with URV.Test_Inputs;

package URV.Shared_Inputs is new URVOS.Shared_Data
  (URV.Test_Inputs.Increments, Initial => URV.Test_Inputs.Nothing_Added);
