--  The analog-to-digital board (report, 2.3.3, 4.1, 4.2).
--
--  The controller writes a channel number; 16 us later the board has the
--  channel's value in its data register and interrupts the controller, if
--  the interrupt is enabled. Another channel number written meanwhile
--  abandons the conversion.

with URVOS; use URVOS;

package Devices.AD_Board with Pure, SPARK_Mode is

   Microseconds_Per_Conversion : constant := 16;

   type Channel_Number is range 0 .. 31;

   --  The interrupt vector that the controller gives the board.
   Interrupt_Vector : constant Byte := 16#40#;

   type Registers is record
      Vector            : Byte           := 0;
      Interrupt_Enabled : Boolean        := False;
      Converting        : Boolean        := False;
      Channel           : Channel_Number := 0;
      Data              : Word           := 0;
   end record;

   --  The controller prepares the board (INI-5).
   function Initialised (Board : Registers) return Registers is
     ((Board with delta
         Vector            => Interrupt_Vector,
         Interrupt_Enabled => True,
         Converting        => False));

   --  The controller has a channel converted.
   function Started
     (Board   : Registers;
      Channel : Channel_Number) return Registers
   is
     ((Board with delta Channel => Channel, Converting => True));

   --  The board has converted the channel.
   function Finished (Board : Registers; Value : Word) return Registers is
     ((Board with delta Data => Value, Converting => False));

end Devices.AD_Board;
