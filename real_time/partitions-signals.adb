with Interfaces.C; use Interfaces.C;
with System;

with Partitions.Signal_Masks;
with Partitions.System_Calls; use Partitions.System_Calls;

package body Partitions.Signals is

   task Listener with Priority => System.Priority'Last - 1;

   task body Listener is
      Came : int;
   begin
      loop
         if Wait_For (Signal_Masks.Ours, Came) = 0 then
            if Came = Restart then
               Raise_Processor_Exception;
            else
               Switch_Off;
            end if;
         end if;
      end loop;
   end Listener;

end Partitions.Signals;
