--  SPDX-License-Identifier: Apache-2.0

with GNAT.OS_Lib; use GNAT.OS_Lib;

package body Thermostat.Task_Ends is

   procedure Give_Up (What : String; Status : Integer) is
      Line   : constant String := "run_thermostat: " & What & ASCII.LF;
      Unused : Integer;
   begin
      Unused := Write (Standerr, Line'Address, Line'Length);
      OS_Exit (Status);   --  Ravenscar tasks do not end
   end Give_Up;

   protected body Watch is

      procedure Report
        (Cause      : Cause_Of_Termination;
         Ended_Task : Ada.Task_Identification.Task_Id;
         Error      : Exception_Occurrence)
      is
         pragma Unreferenced (Cause);
      begin
         Give_Up
           ("task " & Ada.Task_Identification.Image (Ended_Task)
            & " has ended: " & Exception_Name (Error) & ": "
            & Exception_Message (Error),
            1);
      end Report;

   end Watch;

begin
   Set_Dependents_Fallback_Handler (Watch.Report'Access);
end Thermostat.Task_Ends;
