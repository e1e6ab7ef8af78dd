--  SPDX-License-Identifier: Apache-2.0

--  The registers of the timers 2 to 5 themselves, at their addresses.

with Ada.Unchecked_Conversion;
with System.Storage_Elements; use System.Storage_Elements;

package body STM32_PWM.Registers with SPARK_Mode => Off is

   type Register is new Unsigned_32 with Volatile_Full_Access;

   type Compare_Registers is array (Output_Number) of Register;
   type Mode_Registers is array (Output_Pair) of Register;
   type Unused_Registers is array (Positive range <>) of Register;

   type Timer_Registers is limited record
      Control   : Register;
      Control_2 : Register;
      Slave     : Register;
      DMA       : Register;
      Status    : Register;
      Events    : Register;
      Modes     : Mode_Registers;
      Outputs   : Register;
      Counter   : Register;
      Prescaler : Register;
      Reload    : Register;
      Unused    : Register;
      Compare   : Compare_Registers;
      Rest      : Unused_Registers (1 .. 239);
   end record
   with Size => 16#400# * 8;

   --  Timer 2 is at 4000_0000, and each other one 400 after it.

   Timers : array (Timer_Name) of Timer_Registers
   with Import, Volatile, Address => To_Address (16#4000_0000#);

   function To_Register is
     new Ada.Unchecked_Conversion (Control, Unsigned_32);
   function To_Register is new Ada.Unchecked_Conversion (Modes, Unsigned_32);
   function To_Register is
     new Ada.Unchecked_Conversion (Outputs, Unsigned_32);

   --  The bits that the types have.

   Control_Bits : constant := 2#1000_0001#;
   Mode_Bits    : constant := 2#0111_1000_0111_1000#;
   Output_Bits  : constant := 2#0001_0001_0001_0001#;

   --  Only contracts call this function. It is not executed here.
   function State (Timer : Timer_Name) return Timer_Model is
     (raise Program_Error);

   procedure Write_Control (Timer : Timer_Name; Value : Control) is
   begin
      Timers (Timer).Control :=
        Register (To_Register (Value) and Control_Bits);
   end Write_Control;

   procedure Write_Modes
     (Timer : Timer_Name;
      Pair  : Output_Pair;
      Value : Modes) is
   begin
      Timers (Timer).Modes (Pair) :=
        Register (To_Register (Value) and Mode_Bits);
   end Write_Modes;

   procedure Write_Outputs (Timer : Timer_Name; Value : Outputs) is
   begin
      Timers (Timer).Outputs :=
        Register (To_Register (Value) and Output_Bits);
   end Write_Outputs;

   procedure Write_Prescaler (Timer : Timer_Name; Value : Register_16) is
   begin
      Timers (Timer).Prescaler := Register (Value);
   end Write_Prescaler;

   procedure Write_Reload (Timer : Timer_Name; Value : Register_16) is
   begin
      Timers (Timer).Reload := Register (Value);
   end Write_Reload;

   procedure Write_Compare
     (Timer  : Timer_Name;
      Output : Output_Number;
      Value  : Register_16) is
   begin
      Timers (Timer).Compare (Output) := Register (Value);
   end Write_Compare;

   procedure Generate_Update (Timer : Timer_Name) is
   begin
      Timers (Timer).Events := 1;
   end Generate_Update;

end STM32_PWM.Registers;
