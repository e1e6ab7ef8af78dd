--  SPDX-License-Identifier: Apache-2.0

--  The registers themselves, at the odd bytes of each chip's place in memory
--  (BRD-4). Some addresses have one register to read and another to write.

with Ada.Unchecked_Conversion;
with System.Storage_Elements; use System.Storage_Elements;

package body MC68681.Registers with SPARK_Mode => Off is

   type Register is new Byte with Volatile;

   --  Mode: register 1, then 2. Status, write: the clocks. Interrupts, write:
   --  those in use. Start and Stop are read only.
   type Chip is limited record
      Mode_A     : Register;
      Status_A   : Register;
      Command_A  : Register;
      Data_A     : Register;
      Auxiliary  : Register;
      Interrupts : Register;
      Count_High : Register;
      Count_Low  : Register;
      Mode_B     : Register;
      Status_B   : Register;
      Command_B  : Register;
      Data_B     : Register;
      Vector     : Register;
      Inputs     : Register;
      Start      : Register;
      Stop       : Register;
   end record
   with Volatile, Alignment => 2;

   for Chip use record
      Mode_A     at  1 range 0 .. 7;
      Status_A   at  3 range 0 .. 7;
      Command_A  at  5 range 0 .. 7;
      Data_A     at  7 range 0 .. 7;
      Auxiliary  at  9 range 0 .. 7;
      Interrupts at 11 range 0 .. 7;
      Count_High at 13 range 0 .. 7;
      Count_Low  at 15 range 0 .. 7;
      Mode_B     at 17 range 0 .. 7;
      Status_B   at 19 range 0 .. 7;
      Command_B  at 21 range 0 .. 7;
      Data_B     at 23 range 0 .. 7;
      Vector     at 25 range 0 .. 7;
      Inputs     at 27 range 0 .. 7;
      Start      at 29 range 0 .. 7;
      Stop       at 31 range 0 .. 7;
   end record;

   First : Chip
   with Import, Volatile, Address => To_Address (16#F0_0000#);
   Second : Chip
   with Import, Volatile, Address => To_Address (16#F0_0020#);

   function To_Register is new Ada.Unchecked_Conversion (Mode_1, Register);
   function To_Register is new Ada.Unchecked_Conversion (Mode_2, Register);
   function To_Register is new Ada.Unchecked_Conversion (Command, Register);
   function To_Register is
     new Ada.Unchecked_Conversion (Interrupt_Set, Register);
   function To_Set is
     new Ada.Unchecked_Conversion (Register, Interrupt_Set);
   function To_Status is
     new Ada.Unchecked_Conversion (Register, Channel_Status);

   --  Some registers act when they are read.
   procedure Touch (Item : Register)
   with Inline;

   procedure Touch (Item : Register) is null;

   --  Only contracts call these functions. They are not executed here.

   function State (Port : Port_Name) return Port_Model is
     (raise Program_Error);

   function State (Chip : Chip_Name) return Chip_Model is
     (raise Program_Error);

   function Received_Character
     (Port   : Port_Name;
      Number : Event_Number) return Heard_Character is
     (raise Program_Error);

   procedure Write_Mode (Port : Port_Name; Mode : Mode_1) is
   begin
      case Port is
         when Line    => First.Mode_A := To_Register (Mode);
         when Console => First.Mode_B := To_Register (Mode);
      end case;
   end Write_Mode;

   procedure Write_Mode (Port : Port_Name; Mode : Mode_2) is
   begin
      case Port is
         when Line    => First.Mode_A := To_Register (Mode);
         when Console => First.Mode_B := To_Register (Mode);
      end case;
   end Write_Mode;

   procedure Write_Clocks (Port : Port_Name; Clocks : Byte) is
   begin
      case Port is
         when Line    => First.Status_A := Register (Clocks);
         when Console => First.Status_B := Register (Clocks);
      end case;
   end Write_Clocks;

   procedure Write_Command (Port : Port_Name; Order : Command) is
   begin
      case Port is
         when Line    => First.Command_A := To_Register (Order);
         when Console => First.Command_B := To_Register (Order);
      end case;
   end Write_Command;

   procedure Read_Status (Port : Port_Name; Status : out Channel_Status) is
   begin
      case Port is
         when Line    => Status := To_Status (First.Status_A);
         when Console => Status := To_Status (First.Status_B);
      end case;
   end Read_Status;

   procedure Read_Data (Port : Port_Name; Data : out Byte) is
   begin
      case Port is
         when Line    => Data := Byte (First.Data_A);
         when Console => Data := Byte (First.Data_B);
      end case;
   end Read_Data;

   procedure Write_Data (Port : Port_Name; Data : Byte) is
   begin
      case Port is
         when Line    => First.Data_A := Register (Data);
         when Console => First.Data_B := Register (Data);
      end case;
   end Write_Data;

   procedure Write_Auxiliary (Chip : Chip_Name; Value : Byte) is
   begin
      case Chip is
         when Line_Chip  => First.Auxiliary := Register (Value);
         when Clock_Chip => Second.Auxiliary := Register (Value);
      end case;
   end Write_Auxiliary;

   procedure Write_Count_High (Chip : Chip_Name; Value : Count_Half) is
   begin
      case Chip is
         when Line_Chip  => First.Count_High := Register (Value);
         when Clock_Chip => Second.Count_High := Register (Value);
      end case;
   end Write_Count_High;

   procedure Write_Count_Low (Chip : Chip_Name; Value : Count_Half) is
   begin
      case Chip is
         when Line_Chip  => First.Count_Low := Register (Value);
         when Clock_Chip => Second.Count_Low := Register (Value);
      end case;
   end Write_Count_Low;

   procedure Start_Timer (Chip : Chip_Name) is
   begin
      case Chip is
         when Line_Chip  => Touch (First.Start);
         when Clock_Chip => Touch (Second.Start);
      end case;
   end Start_Timer;

   procedure Answer_Timer (Chip : Chip_Name) is
   begin
      case Chip is
         when Line_Chip  => Touch (First.Stop);
         when Clock_Chip => Touch (Second.Stop);
      end case;
   end Answer_Timer;

   procedure Read_Interrupts (Chip : Chip_Name; Pending : out Interrupt_Set)
   is
   begin
      case Chip is
         when Line_Chip  => Pending := To_Set (First.Interrupts);
         when Clock_Chip => Pending := To_Set (Second.Interrupts);
      end case;
   end Read_Interrupts;

   procedure Write_Interrupts (Chip : Chip_Name; Used : Interrupt_Set) is
   begin
      case Chip is
         when Line_Chip  => First.Interrupts := To_Register (Used);
         when Clock_Chip => Second.Interrupts := To_Register (Used);
      end case;
   end Write_Interrupts;

   procedure Write_Vector (Chip : Chip_Name; Vector : Byte) is
   begin
      case Chip is
         when Line_Chip  => First.Vector := Register (Vector);
         when Clock_Chip => Second.Vector := Register (Vector);
      end case;
   end Write_Vector;

end MC68681.Registers;
