--  SPDX-License-Identifier: Apache-2.0

--  The registers themselves, at their addresses.

with Ada.Unchecked_Conversion;
with System.Storage_Elements; use System.Storage_Elements;

package body STM32_USART.Registers with SPARK_Mode => Off is

   type Register is new Unsigned_32 with Volatile_Full_Access;

   type Serial_Port is limited record
      Status    : Register;
      Data      : Register;
      Bit_Time  : Register;
      Control_1 : Register;
      Control_2 : Register;
   end record;

   USART_1 : Serial_Port
   with Import, Volatile, Address => To_Address (16#4001_1000#);
   USART_2 : Serial_Port
   with Import, Volatile, Address => To_Address (16#4000_4400#);

   function To_Register is
     new Ada.Unchecked_Conversion (Control_1, Unsigned_32);
   function To_Register is
     new Ada.Unchecked_Conversion (Control_2, Unsigned_32);
   function To_Status is
     new Ada.Unchecked_Conversion (Unsigned_32, Port_Status);

   --  The bits of a control register that its type has; the others stay 0.

   Used_Bits_1 : constant := 2#0011_0110_0010_1100#;
   Used_Bits_2 : constant := 2#0011_0000_0000_0000#;

   --  Only contracts call these functions. They are not executed here.

   function State (Port : Port_Name) return Port_Model is
     (raise Program_Error);

   function Received_Character
     (Port   : Port_Name;
      Number : Event_Number) return Heard_Character is
     (raise Program_Error);

   procedure Write_Control_1 (Port : Port_Name; Value : Control_1) is
      Word : constant Register :=
        Register (To_Register (Value) and Used_Bits_1);
   begin
      case Port is
         when Console => USART_1.Control_1 := Word;
         when Line    => USART_2.Control_1 := Word;
      end case;
   end Write_Control_1;

   procedure Write_Control_2 (Port : Port_Name; Value : Control_2) is
      Word : constant Register :=
        Register (To_Register (Value) and Used_Bits_2);
   begin
      case Port is
         when Console => USART_1.Control_2 := Word;
         when Line    => USART_2.Control_2 := Word;
      end case;
   end Write_Control_2;

   procedure Write_Divider (Port : Port_Name; Value : Divider) is
   begin
      case Port is
         when Console => USART_1.Bit_Time := Register (Value);
         when Line    => USART_2.Bit_Time := Register (Value);
      end case;
   end Write_Divider;

   procedure Read_Status (Port : Port_Name; Status : out Port_Status) is
   begin
      case Port is
         when Console => Status := To_Status (Unsigned_32 (USART_1.Status));
         when Line    => Status := To_Status (Unsigned_32 (USART_2.Status));
      end case;
   end Read_Status;

   procedure Read_Data (Port : Port_Name; Data : out Byte) is
   begin
      case Port is
         when Console => Data := Byte (USART_1.Data and 16#FF#);
         when Line    => Data := Byte (USART_2.Data and 16#FF#);
      end case;
   end Read_Data;

   procedure Write_Data (Port : Port_Name; Data : Byte) is
   begin
      case Port is
         when Console => USART_1.Data := Register (Data);
         when Line    => USART_2.Data := Register (Data);
      end case;
   end Write_Data;

end STM32_USART.Registers;
