--  SPDX-License-Identifier: Apache-2.0

--  The registers of an MC68681, dual asynchronous receiver and transmitter
--  with a timer, at the odd bytes of its place in memory (BRD-4). Some
--  addresses have one register to read and another to write.

with Interfaces;              use Interfaces;
with System.Storage_Elements; use System.Storage_Elements;

package MC68681 is

   type Register is new Unsigned_8 with Volatile;

   type Chip is limited record
      Mode_A          : Register;   --  first mode register 1, then 2
      Status_A        : Register;   --  write: the clock of channel A
      Command_A       : Register;
      Data_A          : Register;
      Auxiliary       : Register;   --  write only
      Interrupts      : Register;   --  write: the interrupts in use
      Count_High      : Register;
      Count_Low       : Register;
      Mode_B          : Register;
      Status_B        : Register;
      Command_B       : Register;
      Data_B          : Register;
      Vector          : Register;
      Inputs          : Register;
      Start_Counter   : Register;   --  read only
      Stop_Counter    : Register;   --  read only
   end record
   with Volatile, Alignment => 2;

   for Chip use record
      Mode_A        at  1 range 0 .. 7;
      Status_A      at  3 range 0 .. 7;
      Command_A     at  5 range 0 .. 7;
      Data_A        at  7 range 0 .. 7;
      Auxiliary     at  9 range 0 .. 7;
      Interrupts    at 11 range 0 .. 7;
      Count_High    at 13 range 0 .. 7;
      Count_Low     at 15 range 0 .. 7;
      Mode_B        at 17 range 0 .. 7;
      Status_B      at 19 range 0 .. 7;
      Command_B     at 21 range 0 .. 7;
      Data_B        at 23 range 0 .. 7;
      Vector        at 25 range 0 .. 7;
      Inputs        at 27 range 0 .. 7;
      Start_Counter at 29 range 0 .. 7;
      Stop_Counter  at 31 range 0 .. 7;
   end record;

   --  Status
   Received        : constant Register := 2#0000_0001#;
   Takes_Character : constant Register := 2#0000_0100#;
   Overrun         : constant Register := 2#0001_0000#;
   Wrong_Parity    : constant Register := 2#0010_0000#;
   Wrong_Framing   : constant Register := 2#0100_0000#;
   Errors          : constant Register := 2#1111_0000#;

   --  Commands
   Receiver_On    : constant Register := 2#0000_0001#;
   Sender_On      : constant Register := 2#0000_0100#;
   Reset_Mode     : constant Register := 16#10#;
   Reset_Receiver : constant Register := 16#20#;
   Reset_Sender   : constant Register := 16#30#;
   Reset_Errors   : constant Register := 16#40#;

   --  Even parity, 8 bits; 2 stop bits
   Even_Parity_8_Bits : constant Register := 2#0000_0011#;
   Two_Stop_Bits      : constant Register := 2#0000_1111#;

   --  Sixteen times the bit rate comes from outside, through inputs 3 and 4.
   Outside_Clock : constant Register := 16#EE#;

   --  The timer counts the chip's own clock. A period is twice its count.
   Timer_On_Clock : constant Register := 16#60#;

   --  Interrupts
   Timer_Interrupt    : constant Register := 2#0000_1000#;
   Receiver_Interrupt : constant Register := 2#0000_0010#;

   --  The board has two of them.

   Line_Chip : Chip
   with Import, Volatile, Address => To_Address (16#F0_0000#);
   Clock_Chip : Chip
   with Import, Volatile, Address => To_Address (16#F0_0020#);

end MC68681;
