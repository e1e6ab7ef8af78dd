--  SPDX-License-Identifier: Apache-2.0

--  A node's error log, shared by all units that report and read (EXT-1,
--  SEM-2). URV.Errors has the kinds of errors and their details.

pragma SPARK_Mode;

with URVOS.Shared_Error_Logs;
with URV.Errors;

package URV.Shared_Errors is
  new URVOS.Shared_Error_Logs (URV.Errors.Logs);
