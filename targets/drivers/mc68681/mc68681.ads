--  SPDX-License-Identifier: Apache-2.0

--  The contents of the registers of an MC68681, dual asynchronous receiver and
--  transmitter with a timer, as its data sheet defines them (BRD-4, BRD-6).

with Interfaces; use Interfaces;
with System;
with URVOS;      use URVOS;

package MC68681 with Pure, SPARK_Mode is

   --  The board has two chips. The first one's channel A is the telemetry
   --  line, its channel B the console.

   type Chip_Name is (Line_Chip, Clock_Chip);
   type Port_Name is (Line, Console);

   --  Mode registers 1 and 2 of a channel

   type Character_Size is (Five_Bits, Six_Bits, Seven_Bits, Eight_Bits);
   type Parity_Mode is (With_Parity, Forced_Parity, No_Parity, Multidrop);

   type Mode_1 is record
      Size                : Character_Size;
      Is_Odd              : Boolean;
      Parity              : Parity_Mode;
      Errors_By_Block     : Boolean;   --  else by character
      Interrupt_When_Full : Boolean;   --  else with each character
      Controls_RTS        : Boolean;
   end record
   with Size => 8, Bit_Order => System.Low_Order_First;

   for Mode_1 use record
      Size                at 0 range 0 .. 1;
      Is_Odd              at 0 range 2 .. 2;
      Parity              at 0 range 3 .. 4;
      Errors_By_Block     at 0 range 5 .. 5;
      Interrupt_When_Full at 0 range 6 .. 6;
      Controls_RTS        at 0 range 7 .. 7;
   end record;

   type Stop_Length is mod 16;
   type Channel_Mode is (Normal, Echo, Local_Loop, Remote_Loop);

   type Mode_2 is record
      Stop         : Stop_Length;
      Obeys_CTS    : Boolean;
      Controls_RTS : Boolean;
      Channel      : Channel_Mode;
   end record
   with Size => 8, Bit_Order => System.Low_Order_First;

   for Mode_2 use record
      Stop         at 0 range 0 .. 3;
      Obeys_CTS    at 0 range 4 .. 4;
      Controls_RTS at 0 range 5 .. 5;
      Channel      at 0 range 6 .. 7;
   end record;

   --  With 8 bits this length is 2 stop bits.
   Two_Stop_Bits : constant Stop_Length := 15;

   --  The clocks of receiver (high half) and transmitter (low half): both come
   --  from outside, 16 times the bit rate.
   Outside_Clocks : constant Byte := 16#EE#;

   --  The status of a channel. Parity, framing and break are those of the
   --  oldest character. Overrun stays until it is reset.

   type Error_Bits is mod 16;

   No_Errors     : constant Error_Bits := 0;
   Overrun       : constant Error_Bits := 1;
   Wrong_Parity  : constant Error_Bits := 2;
   Wrong_Framing : constant Error_Bits := 4;
   Is_Break      : constant Error_Bits := 8;

   function Has (Errors, Which : Error_Bits) return Boolean is
     ((Errors and Which) /= 0);

   type Channel_Status is record
      Received        : Boolean;
      Is_Full         : Boolean;
      Takes_Character : Boolean;
      Is_Empty        : Boolean;
      Errors          : Error_Bits;
   end record
   with Size => 8, Bit_Order => System.Low_Order_First;

   for Channel_Status use record
      Received        at 0 range 0 .. 0;
      Is_Full         at 0 range 1 .. 1;
      Takes_Character at 0 range 2 .. 2;
      Is_Empty        at 0 range 3 .. 3;
      Errors          at 0 range 4 .. 7;
   end record;

   --  Commands to a channel

   type Command is
     (Switch_On_Sender,
      Switch_On_Both,
      Reset_Mode_Pointer,
      Reset_Receiver,
      Reset_Sender,
      Reset_Errors)
   with Size => 8;

   for Command use
     (Switch_On_Sender   => 16#04#,
      Switch_On_Both     => 16#05#,
      Reset_Mode_Pointer => 16#10#,
      Reset_Receiver     => 16#20#,
      Reset_Sender       => 16#30#,
      Reset_Errors       => 16#40#);

   --  Interrupts of a chip: those in use, or those that are pending

   type Interrupt_Set is record
      Sender_A   : Boolean;
      Receiver_A : Boolean;
      Break_A    : Boolean;
      Timer      : Boolean;
      Sender_B   : Boolean;
      Receiver_B : Boolean;
      Break_B    : Boolean;
      Inputs     : Boolean;
   end record
   with Size => 8, Bit_Order => System.Low_Order_First;

   for Interrupt_Set use record
      Sender_A   at 0 range 0 .. 0;
      Receiver_A at 0 range 1 .. 1;
      Break_A    at 0 range 2 .. 2;
      Timer      at 0 range 3 .. 3;
      Sender_B   at 0 range 4 .. 4;
      Receiver_B at 0 range 5 .. 5;
      Break_B    at 0 range 6 .. 6;
      Inputs     at 0 range 7 .. 7;
   end record;

   --  The auxiliary register: the timer counts the chip's own clock.
   Timer_On_Own_Clock : constant Byte := 16#60#;

   --  The timer's count, in two registers. A period has twice the count. The
   --  chip needs a count of at least 2.

   subtype Timer_Count is Positive range 2 .. 16#FFFF#;

   type Count_Half is range 0 .. 255 with Size => 8;

   --  A received character with its errors

   type Heard_Character is record
      Data          : Byte    := 0;
      Wrong_Parity  : Boolean := False;
      Wrong_Framing : Boolean := False;
      Is_Break      : Boolean := False;
   end record
   with Alignment => 2;

   --  Numbers of events; they wrap around, and are only compared.
   type Event_Number is new Unsigned_32;

end MC68681;
