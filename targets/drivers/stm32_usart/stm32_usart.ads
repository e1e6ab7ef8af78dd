--  SPDX-License-Identifier: Apache-2.0

--  The contents of the registers of an STM32F4's serial port (USART), as the
--  reference manual RM0090 defines them in section 30.6 (BRD-6).

with Interfaces; use Interfaces;
with URVOS;      use URVOS;

package STM32_USART with Pure, SPARK_Mode is

   --  Port 1 is the console, port 2 the telemetry line.
   type Port_Name is (Console, Line);

   --  The status register. Parity, framing and noise are those of the
   --  character in the data register. Overrun: a character was lost.

   type Port_Status is record
      Wrong_Parity    : Boolean;
      Wrong_Framing   : Boolean;
      Noise           : Boolean;
      Overrun         : Boolean;
      Is_Silent       : Boolean;
      Received        : Boolean;
      Is_Complete     : Boolean;
      Takes_Character : Boolean;
   end record
   with Size => 32;

   for Port_Status use record
      Wrong_Parity    at 0 range 0 .. 0;
      Wrong_Framing   at 0 range 1 .. 1;
      Noise           at 0 range 2 .. 2;
      Overrun         at 0 range 3 .. 3;
      Is_Silent       at 0 range 4 .. 4;
      Received        at 0 range 5 .. 5;
      Is_Complete     at 0 range 6 .. 6;
      Takes_Character at 0 range 7 .. 7;
   end record;

   --  Control register 1. A character of nine bits has eight bits of data and
   --  the parity.

   type Control_1 is record
      Receiver_On        : Boolean;
      Sender_On          : Boolean;
      Receiver_Interrupt : Boolean;   --  a character, or an overrun
      Is_Odd             : Boolean;
      With_Parity        : Boolean;
      Nine_Bits          : Boolean;
      Port_On            : Boolean;
   end record
   with Size => 32;

   for Control_1 use record
      Receiver_On        at 0 range 2 .. 2;
      Sender_On          at 0 range 3 .. 3;
      Receiver_Interrupt at 0 range 5 .. 5;
      Is_Odd             at 0 range 9 .. 9;
      With_Parity        at 0 range 10 .. 10;
      Nine_Bits          at 0 range 12 .. 12;
      Port_On            at 0 range 13 .. 13;
   end record;

   --  The stop bits, in control register 2

   type Stop_Bits is (One, Half, Two, One_And_A_Half);

   type Control_2 is record
      Stop : Stop_Bits;
   end record
   with Size => 32;

   for Control_2 use record
      Stop at 0 range 12 .. 13;
   end record;

   --  The bus clock's cycles in a bit.
   subtype Divider is Positive range 16 .. 16#FFFF#;

   --  A received character with its errors

   type Heard_Character is record
      Data          : Byte    := 0;
      Wrong_Parity  : Boolean := False;
      Wrong_Framing : Boolean := False;
      Noise         : Boolean := False;
   end record;

   --  Numbers of events; they wrap around, and are only compared.
   type Event_Number is new Unsigned_32;

end STM32_USART;
