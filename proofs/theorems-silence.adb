--  SPDX-License-Identifier: Apache-2.0

with URVOS; use URVOS;

package body Theorems.Silence with SPARK_Mode is

   procedure No_State_Is_Far (Item : Board) is null;

   procedure Live_On (Item : in out Board) is
      Send : Boolean;
      Data : Byte;
   begin
      Next_Character (Item, Send, Data);
      if not Send then
         Elapse (Item, 1);
      end if;
      pragma Unreferenced (Data);
   end Live_On;

   procedure Comes_To_Rest (Item : in out Board; Times : out Natural) is
   begin
      if At_Rest (Item) then
         Times := 0;
      else
         Live_On (Item);
         Comes_To_Rest (Item, Times);
         Times := Times + 1;
      end if;
   end Comes_To_Rest;

   procedure Ground_Outwaits_Aircraft (Item : in out Board) is
   begin
      Elapse (Item, Idle_Time);
   end Ground_Outwaits_Aircraft;

end Theorems.Silence;
