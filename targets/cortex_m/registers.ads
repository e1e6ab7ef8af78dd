--  SPDX-License-Identifier: Apache-2.0

--  The registers of the STM32F405 (reference manual RM0090) and its Cortex-M4
--  (ARMv7-M) that this program uses, at their addresses (BRD-3).

with Interfaces;              use Interfaces;
with System.Storage_Elements; use System.Storage_Elements;

package Registers is

   type Register is new Unsigned_32 with Volatile_Full_Access;

   --  Interrupt control. Bit 26 is set while SysTick's interrupt is pending.
   Interrupt_State : Register
   with Import, Address => To_Address (16#E000_ED04#);

   SysTick_Pending : constant Register := 2 ** 26;

   --  Interrupts by number, one bit each. Enable 0 to 31 and 32 to 63; disable
   --  or clear 32 to 63; make any number pending

   Interrupt_Enable_1 : Register
   with Import, Address => To_Address (16#E000_E100#);
   Interrupt_Enable_2 : Register
   with Import, Address => To_Address (16#E000_E104#);
   Interrupt_Disable_2 : Register
   with Import, Address => To_Address (16#E000_E184#);
   Interrupt_Clear_2  : Register
   with Import, Address => To_Address (16#E000_E284#);
   Interrupt_Trigger  : Register
   with Import, Address => To_Address (16#E000_EF00#);

   USART_2_Bit : constant Register := 2 ** (38 - 32);

   --  The priorities of the processor's own interrupts.
   System_Priorities : Register
   with Import, Address => To_Address (16#E000_ED20#);

   SysTick_Last : constant Register := 16#F000_0000#;

end Registers;
