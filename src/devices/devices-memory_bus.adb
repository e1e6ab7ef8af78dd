--  SPDX-License-Identifier: Apache-2.0

--  Nothing of the memories is kept here.

package body Devices.Memory_Bus
  with
    SPARK_Mode,
    Refined_State => (Cells => null)
is
end Devices.Memory_Bus;
