--  SPDX-License-Identifier: Apache-2.0

--  The registers of converter 1 themselves, at their addresses.

with Ada.Unchecked_Conversion;
with System.Storage_Elements; use System.Storage_Elements;

package body STM32_ADC.Registers with SPARK_Mode => Off is

   type Register is new Unsigned_32 with Volatile_Full_Access;

   type Converter is limited record
      Status     : Register;
      Control_1  : Register;
      Control_2  : Register;
      Sampling_1 : Register;   --  channels 10 to 15, three bits each
      Sampling_2 : Register;   --  channels 0 to 9
   end record;

   ADC_1 : Converter
   with Import, Volatile, Address => To_Address (16#4001_2000#);

   --  The sequence: its length - 1 in bits 20 to 23, and its first channel

   Sequence_1 : Register
   with Import, Address => To_Address (16#4001_202C#);
   Sequence_3 : Register
   with Import, Address => To_Address (16#4001_2034#);

   Data_Register : Register
   with Import, Address => To_Address (16#4001_204C#);

   function To_Register is new Ada.Unchecked_Conversion (Status, Unsigned_32);
   function To_Register is
     new Ada.Unchecked_Conversion (Control_1, Unsigned_32);
   function To_Register is
     new Ada.Unchecked_Conversion (Control_2, Unsigned_32);
   function To_Status is new Ada.Unchecked_Conversion (Unsigned_32, Status);

   --  The bits that the types have.

   Status_Bits : constant := 2#0011_0010#;
   Used_Bits_1 : constant := 16#0400_0020#;
   Used_Bits_2 : constant := 16#0000_0401#;

   --  A 1 changes nothing in the status register.
   All_Flags : constant := 2#0011_1111#;

   Start_Bit : constant := 2 ** 30;

   --  Only contracts call these functions. They are not executed here.

   function State return Converter_Model is (raise Program_Error);

   function Value_Of (Number : Event_Number) return Converted_Value is
     (raise Program_Error);

   procedure Write_Status (Value : Status) is
   begin
      ADC_1.Status := Register
        ((All_Flags and not Status_Bits)
         or (To_Register (Value) and Status_Bits));
   end Write_Status;

   procedure Read_Status (Item : out Status) is
   begin
      Item := To_Status (Unsigned_32 (ADC_1.Status));
   end Read_Status;

   procedure Write_Control_1 (Value : Control_1) is
   begin
      ADC_1.Control_1 := Register (To_Register (Value) and Used_Bits_1);
   end Write_Control_1;

   procedure Write_Control_2 (Value : Control_2) is
   begin
      ADC_1.Control_2 := Register (To_Register (Value) and Used_Bits_2);
   end Write_Control_2;

   procedure Write_Sampling (Value : Sampling_Time) is
      Bits : constant Register := Sampling_Time'Pos (Value);
   begin
      ADC_1.Sampling_1 := Bits * 2#001_001_001_001_001_001#;
      ADC_1.Sampling_2 :=
        Bits * 2#001_001_001_001_001_001_001_001_001_001#;
   end Write_Sampling;

   procedure Write_Channel (Value : Channel_Number) is
   begin
      Sequence_1 := 0;
      Sequence_3 := Register (Value);
   end Write_Channel;

   procedure Write_Start is
   begin
      ADC_1.Control_2 := ADC_1.Control_2 or Start_Bit;
   end Write_Start;

   procedure Read_Data (Data : out Converted_Value) is
   begin
      Data := Word (Data_Register and 16#FFF#);
   end Read_Data;

end STM32_ADC.Registers;
