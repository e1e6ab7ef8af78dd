--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Frame_Locks with SPARK_Mode is

   procedure Take_Tick (This : in out Lock_State; Available : Boolean) is
   begin
      if not (Available and then This.Is_Waiting) then
         This.Waited := 0;
      elsif This.Waited < Wait_Count'Last then
         This.Waited := This.Waited + 1;
      end if;
      This.Is_Waiting := Available;
   end Take_Tick;

end URVOS.Frame_Locks;
