--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Node_Software with SPARK_Mode is

   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call) is
   begin
      if Tasks.Is_Task (Who) then
         Run_Step (Tasks.Task_Of (Who), First_Run, Now, Call);
      else
         Call := (Name => Terminate_Call, others => <>);
      end if;
   end Step;

end URVOS.Node_Software;
