--  SPDX-License-Identifier: Apache-2.0

--  The error log of a node between all who report to it and those who read
--  it (EXT-1, SEM-2): see URV.Errors for the kinds and their details.

pragma SPARK_Mode;

with URVOS.Shared_Error_Logs;
with URV.Errors;

package URV.Shared_Errors is
  new URVOS.Shared_Error_Logs (URV.Errors.Logs);
