--  SPDX-License-Identifier: Apache-2.0

--  The registers themselves, at their addresses.

with System.Storage_Elements; use System.Storage_Elements;

package body STM32_Watchdog.Registers with SPARK_Mode => Off is

   type Register is new Unsigned_32 with Volatile_Full_Access;

   type Watchdog is limited record
      Key     : Register;
      Divider : Register;
      Reload  : Register;
   end record;

   IWDG : Watchdog
   with Import, Volatile, Address => To_Address (16#4000_3000#);

   --  Only contracts call this function. It is not executed here.
   function State return Watchdog_Model is (raise Program_Error);

   procedure Write_Key (Item : Key) is
   begin
      IWDG.Key :=
        (case Item is
            when Unlock => 16#5555#,
            when Feed   => 16#AAAA#,
            when Start  => 16#CCCC#);
   end Write_Key;

   procedure Write_Divider (Value : Clock_Divider) is
   begin
      IWDG.Divider := Clock_Divider'Pos (Value);
   end Write_Divider;

   procedure Write_Reload (Value : Reload_Value) is
   begin
      IWDG.Reload := Register (Value);
   end Write_Reload;

end STM32_Watchdog.Registers;
