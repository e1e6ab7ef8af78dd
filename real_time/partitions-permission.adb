--  SPDX-License-Identifier: Apache-2.0

with GNAT.OS_Lib;
with Interfaces.C;            use Interfaces.C;

with Host.Complaints;
with Partitions.System_Calls; use Partitions.System_Calls;

package body Partitions.Permission is

   --  The priority of the highest task.
   Highest_Priority : constant := 99;

   --  Tries it with the environment task, whose priority is lower, and
   --  restores that.
   function May_Have_Highest return Boolean;

   function May_Have_Highest return Boolean is
      Policy   : constant int := Policy_Of (This_Thread);
      Former   : int;
      Wanted   : int := Highest_Priority;
      Is_Found : constant Boolean := Read_Priority (This_Thread, Former) = 0;
      Done     : constant Boolean :=
        Is_Found
        and then Set_Policy (This_Thread, First_In_First, Wanted) = 0;
   begin
      return
        Done and then Set_Policy (This_Thread, Policy, Former) = 0;
   end May_Have_Highest;

   Granted : constant Boolean := May_Have_Highest;

   function Is_Granted return Boolean is (Granted);

begin
   --  The environment task has its priority by now, if it was permitted.
   if Effective_User = Root and then Policy_Of (This_Thread) /= First_In_First
   then
      Host.Complaints.Report
        ("root may not give threads real-time priorities here: start the"
         & " container with --cap-add=SYS_NICE, or be another user");
      GNAT.OS_Lib.OS_Exit (Host.Complaints.Exit_Status);
   end if;
end Partitions.Permission;
