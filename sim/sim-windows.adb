--  SPDX-License-Identifier: Apache-2.0

package body Sim.Windows is

   procedure Set_Current (Item : in out List);

   procedure Set_Current (Item : in out List) is
   begin
      Item.Current :=
        (if Item.Index <= Item.Windows.Last_Index
         then Item.Windows (Item.Index)
         else Never);
   end Set_Current;

   procedure Add (To : in out List; Added : Window) is
      Whole : Window   := Added;
      Place : Positive := To.Windows.Last_Index + 1;
   begin
      if Added.First >= Added.Stop then
         return;
      end if;

      --  Later spans stay after it, spans that touch it are merged.
      while Place > 1
        and then To.Windows (Place - 1).Stop >= Whole.First
      loop
         Place := Place - 1;
         if To.Windows (Place).First <= Whole.Stop then
            Whole.First :=
              Microseconds'Min (Whole.First, To.Windows (Place).First);
            Whole.Stop :=
              Microseconds'Max (Whole.Stop, To.Windows (Place).Stop);
            To.Windows.Delete (Place);
         end if;
      end loop;
      To.Windows.Insert (Place, Whole);
      Set_Current (To);
   end Add;

   procedure Skip (Over : in out List) is
   begin
      Over.Index := Over.Index + 1;
      Set_Current (Over);
   end Skip;

end Sim.Windows;
