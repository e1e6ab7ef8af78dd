--  SPDX-License-Identifier: Apache-2.0

--  The kernel's tasks never end. One that does has met an exception that
--  nobody expected: the program says so and ends with exit status 1.

with Ada.Task_Identification;
with Ada.Task_Termination; use Ada.Task_Termination;
with Ada.Exceptions;       use Ada.Exceptions;

package Thermostat.Task_Ends is

   --  Writes "run_thermostat: WHAT" to standard error and ends the program.
   procedure Give_Up (What : String; Status : Integer) with No_Return;

   protected Watch is
      procedure Report
        (Cause      : Cause_Of_Termination;
         Ended_Task : Ada.Task_Identification.Task_Id;
         Error      : Exception_Occurrence);
   end Watch;

end Thermostat.Task_Ends;
