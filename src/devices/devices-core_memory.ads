--  CORE memory, where the ground station's displays and recorders find the
--  latest data (report, 2.3.4, 2.5, 4.3; BUF-4).
--
--  Each item is a word and the type code that says what it is. A status
--  area is left for what a warm restart has to say.

with URVOS; use URVOS;

package Devices.CORE_Memory with Pure, SPARK_Mode is

   type Item_Number is range 1 .. 28;
   type Word_Array is array (Item_Number range <>) of Word;

   subtype Uplink_Words is Word_Array (1 .. 14);
   subtype Downlink_Words is Word_Array (1 .. 28);
   subtype Status_Words is Word_Array (1 .. 8);

   type Memory is record
      Uplink_Codes   : Uplink_Words   := (others => 0);
      Uplink         : Uplink_Words   := (others => 0);
      Downlink_Codes : Downlink_Words := (others => 0);
      Downlink       : Downlink_Words := (others => 0);
      Status         : Status_Words   := (others => 0);
   end record;

   --  What a cold start leaves (INI-6).
   Cleared : constant Memory := (others => <>);

end Devices.CORE_Memory;
