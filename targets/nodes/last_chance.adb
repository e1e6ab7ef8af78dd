--  SPDX-License-Identifier: Apache-2.0

with Interfaces; use Interfaces;
with Targets;

package body Last_Chance is

   --  A reason of 256 or more contains a line number. Lower ones are numbers
   --  of exceptions.
   procedure Handle (File : System.Address; Line : Integer) is
      pragma Unreferenced (File);
   begin
      Targets.Restart_Processor (256 + Unsigned_32'Mod (Line));
   end Handle;

end Last_Chance;
