--  SPDX-License-Identifier: Apache-2.0

--  This body keeps no copy of the memories.

package body Devices.Memory_Bus
  with
    SPARK_Mode,
    Refined_State => (Cells => null)
is
end Devices.Memory_Bus;
