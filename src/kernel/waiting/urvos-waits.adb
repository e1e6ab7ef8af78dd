--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Waits with SPARK_Mode is

   procedure Note_Look (This : in out Wait; Now : Clock_Tick) is
   begin
      if Now > This.Seen then
         This :=
           (Left => This.Left - Wait_Ticks (Now - This.Seen),
            Seen => Now,
            Done => 1);
      else
         This.Done := This.Done + 1;
      end if;
   end Note_Look;

end URVOS.Waits;
