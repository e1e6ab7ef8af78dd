--  SPDX-License-Identifier: Apache-2.0

--  A serial device as the link: 125 kbaud, 8 data bits, even parity, 2 stop
--  bits (D-4). A pseudo-terminal is one too.

with Partitions.System_Calls;

package Partitions.Serial_Lines is

   --  The device, set, empty and locked for this process. Raises
   --  Host.Bad_Input.
   function Opened (Device : String) return System_Calls.File;

end Partitions.Serial_Lines;
