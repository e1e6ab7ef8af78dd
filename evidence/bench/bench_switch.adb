--  SPDX-License-Identifier: Apache-2.0

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;

package body Bench_Switch is

   There, Back : Suspension_Object;

   task Other;

   task body Other is
   begin
      loop
         Suspend_Until_True (There);
         Set_True (Back);
      end loop;
   end Other;

   procedure There_And_Back (Turn : Positive) is
      pragma Unreferenced (Turn);
   begin
      Set_True (There);
      Suspend_Until_True (Back);
   end There_And_Back;

end Bench_Switch;
