--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Receive_Calls with SPARK_Mode is

   procedure Receive_Step
     (Now        : Clock_Tick;
      Timeout    : in out Wait;
      Item       : out Messages.Message;
      Fresh      : out Boolean;
      Look_Again : out Boolean) is
   begin
      if Is_Over (Timeout, Now) then
         Variable.Receive (Item, Fresh);
         Look_Again := False;
      else
         Variable.Look (Item, Fresh);
         Look_Again := not Fresh;
         if Look_Again then
            Note_Look (Timeout, Now);
         end if;
      end if;
   end Receive_Step;

end URVOS.Receive_Calls;
