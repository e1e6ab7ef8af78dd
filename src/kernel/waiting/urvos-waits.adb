--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Waits with SPARK_Mode is

   procedure Note_Look (Item : in out Wait; Now : Clock_Tick) is
   begin
      if Now > Item.Seen then
         Item :=
           (Left => Item.Left - Wait_Ticks (Now - Item.Seen),
            Seen => Now,
            Done => 1);
      else
         Item.Done := Item.Done + 1;
      end if;
   end Note_Look;

end URVOS.Waits;
