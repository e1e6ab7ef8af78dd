--  SPDX-License-Identifier: Apache-2.0

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Interfaces.C; use Interfaces.C;
with System;

with Partitions.Signal_Masks;
with Partitions.System_Calls; use Partitions.System_Calls;

package body Partitions.Signals is

   Gate : Suspension_Object;

   task Listener with Priority => System.Priority'Last - 1;

   task body Listener is
      Came : int;
   begin
      Suspend_Until_True (Gate);
      loop
         if Wait_For (Signal_Masks.Ours, Came) = 0 then
            case Came is
               when User_1 => Raise_Processor_Exception;
               when User_2 => Press_Reset_Switch;
               when others => Switch_Off;
            end case;
         end if;
      end loop;
   end Listener;

   procedure Listen is
   begin
      Set_True (Gate);
   end Listen;

end Partitions.Signals;
