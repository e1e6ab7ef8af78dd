--  SPDX-License-Identifier: Apache-2.0

--  The boards on the VMEbus, as the controller sees them (report, figure 1).
--
--  Each board has a package with its registers or memory and their operations.
--  A second package, the shell, holds one such board in a protected object,
--  shared by the controller and the board's own hardware.

package Devices with Pure, SPARK_Mode is
end Devices;
