--  SPDX-License-Identifier: Apache-2.0

with Ada.Characters.Handling;

package body Host.Truth_Columns is

   --  A hundredth of a foot or a knot, a thousandth of a degree.
   function Decimals_Of (Item : Shown_Item) return Positive is
     (case Item is
         when Altitude_Ft | North_Ft | East_Ft | Airspeed_Kt => 2,
         when Bank_Deg .. Beta_Deg                           => 3);

   function Name (Item : Shown_Item) return String is
     (Ada.Characters.Handling.To_Lower (Item'Image));

   procedure Put_Names (To : in out Writer) is
   begin
      for Item in Shown_Item loop
         Put (To, ",truth." & Name (Item));
      end loop;
   end Put_Names;

   procedure Put_Values (To : in out Writer; Shown : Shown_State) is
   begin
      for Item in Shown_Item loop
         Put (To, ',');
         Put (To, Shown (Item), Decimals_Of (Item));
      end loop;
   end Put_Values;

end Host.Truth_Columns;
