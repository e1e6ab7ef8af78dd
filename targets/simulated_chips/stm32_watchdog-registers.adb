--  SPDX-License-Identifier: Apache-2.0

--  A simulated watchdog. Before each access the events of Simulated_Line take
--  the values that wait.

with Simulated_Line;

package body STM32_Watchdog.Registers with SPARK_Mode => Off is

   Present : Watchdog_Model :=
     (Runs | Is_Unlocked => False,
      Divider            => By_4,
      Reload             => Reload_Value'Last,
      Waiting            => (others => False),
      Feeds              => 0);

   procedure Advance;

   procedure Advance is
      Events : Simulated_Line.Event_Count;
      Item   : Simulated_Line.Sent_Character;
   begin
      Simulated_Line.Begin_Access (Events);
      for Number in 1 .. Events loop
         Simulated_Line.Arrive (Item);
         if Present.Runs then
            Present.Waiting := (others => False);
         end if;
      end loop;
   end Advance;

   function State return Watchdog_Model is (Present);

   procedure Write_Key (Item : Key) is
   begin
      Advance;
      Present := With_Key (Present, Item);
   end Write_Key;

   procedure Write_Divider (Value : Clock_Divider) is
   begin
      Advance;
      Present.Divider := Value;
      Present.Waiting.Divider_Waits := True;
   end Write_Divider;

   procedure Write_Reload (Value : Reload_Value) is
   begin
      Advance;
      Present.Reload := Value;
      Present.Waiting.Reload_Waits := True;
   end Write_Reload;

end STM32_Watchdog.Registers;
