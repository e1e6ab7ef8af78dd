--  SPDX-License-Identifier: Apache-2.0

--  A script of what goes wrong in a flight, read from a file (--faults)
--  and checked before the flight begins (SIM-2, SIM-5).

with Host.Memory_Hardware; use Host.Memory_Hardware;
with Host.Surface_Faults;
with URV.Buffers;          use URV.Buffers;
with URVOS;                use URVOS;

private with Ada.Containers.Vectors;

package Sim.Faults is

   type Fault_Kind is
     (Cut, Bit_Errors, Flip, Drop, Duplicate, Insert, Stall, Reset,
      ROM_Harm,      --  bits of a byte of the program memory change
      RAM_Harm,      --  bits of a RAM word read as 0
      Bus_Error,     --  the next read of the program memory fails
      Stuck,         --  a servo stays where it is, or at a place
      Float,         --  its linkage is broken
      Slow);         --  it moves at a part of its speed

   --  How a line with such a fault is written, for help.
   function Form_Of (Kind : Fault_Kind) return String;

   --  Of a node's hardware, not of the line.
   subtype Node_Fault is Fault_Kind range Stall .. Bus_Error;

   --  Of a servo of the aircraft.
   subtype Servo_Fault is Fault_Kind range Stuck .. Slow;

   type Board is (ADC, Telemetry);

   --  Of the whole node by its switch, of its processor, or of its telemetry
   --  board alone.
   type Restart is (Warm, Processor, Telemetry_Board);

   --  Which byte of a direction, counted from those whose sending begins
   --  at the fault's time or later.
   type Byte_Ordinal is range 1 .. 2 ** 31 - 1;

   --  The nine bits of a character: eight of data, then parity.
   Bits_Of_Character : constant := 9;
   type Character_Bits is mod 2 ** Bits_Of_Character;
   subtype Flip_Mask is Character_Bits range 1 .. Character_Bits'Last;

   type Probability is new Long_Float range 0.0 .. 1.0;

   --  One line of the script. Only what the kind of fault needs has a
   --  meaning.
   type Fault is record
      Kind     : Fault_Kind;
      Line     : Positive;
      Time     : Microseconds;
      Way      : Direction    := Up;
      Where    : Node         := Aircraft;
      Duration : Microseconds := 0;
      Ordinal  : Byte_Ordinal := 1;
      Mask     : Flip_Mask    := 1;
      Inserted : Byte         := 0;
      Rate     : Probability  := 0.0;
      Stalled  : Board        := ADC;
      How      : Restart      := Warm;
      Byte_At  : ROM_Address  := 0;
      Flips    : Byte         := 0;
      Word_At  : RAM_Address  := 0;
      Zeros    : Word         := 0;
      Servo    : Servo_Item   := Left_Aileron;
      Stays    : Boolean      := True;    --  stuck where it is
      Place    : Converter_Value := Neutral_Value;
      Speed    : Surface_Faults.Percentage := 1;
   end record;

   type Script is limited private;

   --  Reads and checks the file; refuses it at its first wrong line.
   procedure Load (Loaded : in out Script; File : String);

   --  The faults in the order of their lines. Their times may come in any
   --  order.
   function Length (From : Script) return Natural;
   function Element (From : Script; Index : Positive) return Fault
     with Pre => Index <= Length (From);

   --  Those of servos, in the order of their times, for a plant whose first
   --  step begins at that time.
   function For_Plant
     (From : Script; Begins : Microseconds) return Surface_Faults.List;

private

   package Fault_Vectors is new Ada.Containers.Vectors (Positive, Fault);

   type Script is limited record
      Faults : Fault_Vectors.Vector;
   end record;

   function Length (From : Script) return Natural is
     (Natural (From.Faults.Length));

   function Element (From : Script; Index : Positive) return Fault is
     (From.Faults (Index));

end Sim.Faults;
