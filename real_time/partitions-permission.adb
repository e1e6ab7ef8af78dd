--  SPDX-License-Identifier: Apache-2.0

with GNAT.OS_Lib;
with Interfaces.C;            use Interfaces.C;

with Host.Complaints;
with Partitions.Notes;
with Partitions.System_Calls; use Partitions.System_Calls;

package body Partitions.Permission is
begin
   --  The environment task has its priority by now, if it was permitted.
   if Effective_User = Root and then Policy_Of (This_Thread) /= First_In_First
   then
      Notes.Print
        ("root may not give threads real-time priorities here: start the"
         & " container with --cap-add=SYS_NICE, or be another user");
      GNAT.OS_Lib.OS_Exit (Host.Complaints.Exit_Status);
   end if;
end Partitions.Permission;
