--  SPDX-License-Identifier: Apache-2.0

--  The boards on the VMEbus, as the controller sees them (report, figure 1).
--
--  Each board has a package with its registers or memory and the operations
--  on them, and beside it a shell that guards one such board, shared by the
--  controller and the board's own hardware.

package Devices with Pure, SPARK_Mode is
end Devices;
