--  SPDX-License-Identifier: Apache-2.0

--  The analog-to-digital board (report, 2.3.3, 4.1, 4.2).
--
--  The controller writes a channel number. 16 us later the board has the
--  channel's value in its data register and, if the interrupt is enabled,
--  interrupts the controller. A channel number written earlier abandons the
--  conversion.

with URVOS; use URVOS;

package Devices.AD_Board with Pure, SPARK_Mode is

   Microseconds_Per_Conversion : constant := 16;

   type Channel_Number is range 0 .. 31;

   --  The interrupt vector that the controller gives the board. The simulated
   --  hardware calls the handler instead (D-42).
   Interrupt_Vector : constant Byte := 16#40#;

   --  Start_Wanted: a channel number was written; the hardware has not yet
   --  seen it.
   type Activity is (Idle, Start_Wanted, Converting);

   type Registers is record
      Vector            : Byte           := 0;
      Interrupt_Enabled : Boolean        := False;
      Doing             : Activity       := Idle;
      Channel           : Channel_Number := 0;
      Data              : Word           := 0;
   end record;

   --  The controller prepares the board (INI-5).
   function Initialised (Board : Registers) return Registers is
     ((Board with delta
         Vector            => Interrupt_Vector,
         Interrupt_Enabled => True,
         Doing             => Idle));

   --  The controller starts the conversion of a channel.
   function Started
     (Board   : Registers;
      Channel : Channel_Number) return Registers
   is
     ((Board with delta Channel => Channel, Doing => Start_Wanted));

   --  The hardware has seen a start.
   function Begun (Board : Registers) return Registers is
     ((Board with delta
         Doing => (if Board.Doing = Start_Wanted
                   then Converting else Board.Doing)));

   --  The hardware has converted the channel that it saw, unless the
   --  controller has abandoned this conversion.
   function Finished (Board : Registers; Value : Word) return Registers is
     (if Board.Doing = Converting
      then (Board with delta Data => Value, Doing => Idle)
      else Board);

   --  The last three in place

   procedure Start (Board : in out Registers; Channel : Channel_Number)
   with
     Inline,
     Global => null,
     Post   => Board = Started (Board'Old, Channel);

   procedure Begin_Conversion (Board : in out Registers)
   with
     Inline,
     Global => null,
     Post   => Board = Begun (Board'Old);

   procedure Finish (Board : in out Registers; Value : Word)
   with
     Inline,
     Global => null,
     Post   => Board = Finished (Board'Old, Value);

end Devices.AD_Board;
