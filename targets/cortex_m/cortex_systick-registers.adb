--  SPDX-License-Identifier: Apache-2.0

--  The registers themselves, at their addresses.

with Ada.Unchecked_Conversion;
with System.Storage_Elements; use System.Storage_Elements;

package body Cortex_SysTick.Registers with SPARK_Mode => Off is

   type Register is new Unsigned_32 with Volatile_Full_Access;

   type Timer is limited record
      Control : Register;
      Reload  : Register;
      Current : Register;
   end record;

   SysTick : Timer
   with Import, Volatile, Address => To_Address (16#E000_E010#);

   function To_Register is
     new Ada.Unchecked_Conversion (Control, Unsigned_32);
   function To_Control is new Ada.Unchecked_Conversion (Unsigned_32, Control);

   --  The bits of the control register that a program writes.
   Written_Bits : constant := 2#111#;

   --  Only contracts call this function. It is not executed here.
   function State return Timer_Model is (raise Program_Error);

   procedure Write_Control (Value : Control) is
   begin
      SysTick.Control := Register (To_Register (Value) and Written_Bits);
   end Write_Control;

   procedure Read_Control (Value : out Control) is
   begin
      Value := To_Control (Unsigned_32 (SysTick.Control));
   end Read_Control;

   procedure Write_Reload (Value : Reload_Value) is
   begin
      SysTick.Reload := Register (Value);
   end Write_Reload;

   procedure Clear_Current is
   begin
      SysTick.Current := 0;
   end Clear_Current;

   procedure Read_Current (Left : out Natural) is
   begin
      Left := Natural (SysTick.Current);
   end Read_Current;

end Cortex_SysTick.Registers;
