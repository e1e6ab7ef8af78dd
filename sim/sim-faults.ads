--  SPDX-License-Identifier: Apache-2.0

--  A script of the faults of a flight, read from a file (--faults) and checked
--  before the flight begins (SIM-2, SIM-5).

with Ada.Containers.Vectors;

with Host.Memory_Hardware; use Host.Memory_Hardware;
with Host.Surface_Faults;
with Sim.Windows;
with URV.Buffers;          use URV.Buffers;
with URVOS;                use URVOS;

package Sim.Faults is

   type Fault_Kind is
     (Cut, Bit_Errors,
      Replay,        --  an earlier block replaces a sent one
      Flip, Drop, Duplicate, Insert, Stall, Reset,
      ROM_Harm,      --  bits of a byte of the program memory change
      RAM_Harm,      --  bits of a RAM word read as 0
      Halt,          --  the processor halts until a reset
      Bus_Error,     --  the next read of the program memory fails
      Lost_Console,  --  no packet of the pilot's console arrives
      Stuck,         --  a servo stays where it is, or at a place
      Float,         --  its linkage is broken
      Slow);         --  it moves at a fraction of its speed

   --  The form of a line with such a fault, for help.
   function Form_Of (Kind : Fault_Kind) return String;

   --  A fault of one character in one direction.
   subtype Character_Fault is Fault_Kind range Flip .. Insert;

   --  A fault of a node at an instant.
   subtype Hardware_Fault is Fault_Kind range Reset .. Bus_Error;

   --  A fault of a servo of the aircraft.
   subtype Servo_Fault is Fault_Kind range Stuck .. Slow;

   type Board is (ADC, Telemetry);

   --  The whole node by its power or its switch, its processor, or only its
   --  telemetry board.
   type Restart is (Cold, Warm, Processor, Telemetry_Board);

   --  The number of a byte in a direction, counted from those whose sending
   --  begins at the fault's time or later.
   type Byte_Ordinal is range 1 .. 2 ** 31 - 1;

   --  The nine bits of a character: eight of data, then parity.
   Bits_Of_Character : constant := 9;
   type Character_Bits is mod 2 ** Bits_Of_Character;
   subtype Flip_Mask is Character_Bits range 1 .. Character_Bits'Last;

   type Probability is new Long_Float range 0.0 .. 1.0;

   --  One line of the script.
   type Fault (Kind : Fault_Kind := Bus_Error) is record
      Line : Positive;
      Time : Microseconds;

      --  0 for an instant or permanent fault.
      Duration : Microseconds := 0;

      case Kind is
         when Cut | Lost_Console =>
            null;

         when Bit_Errors | Replay | Character_Fault =>
            Path : Direction := Up;
            case Kind is
               when Bit_Errors =>
                  Rate : Probability := 0.0;
               when others =>
                  Ordinal  : Byte_Ordinal := 1;    --  or number of blocks back
                  Mask     : Flip_Mask    := 1;    --  bits to flip
                  Inserted : Byte         := 0;
            end case;

         when Stall | Hardware_Fault =>
            Where : Node := Aircraft;
            case Kind is
               when Stall =>
                  Stalled : Board := ADC;
               when Reset =>
                  How : Restart := Warm;
               when ROM_Harm =>
                  Byte_At : ROM_Address := 0;
                  Flips   : Byte        := 0;
               when RAM_Harm =>
                  Word_At : RAM_Address := 0;
                  Zeros   : Word        := 0;
               when others =>
                  null;
            end case;

         when Servo_Fault =>
            Servo : Servo_Item                := Left_Aileron;
            Stays : Boolean                   := True;  --  stuck where it is
            Place : Converter_Value           := Neutral_Value;
            Speed : Surface_Faults.Percentage := 1;
      end case;
   end record;

   package Fault_Vectors is new Ada.Containers.Vectors (Positive, Fault);
   subtype Fault_List is Fault_Vectors.Vector;

   type Script is private;

   --  Reads and checks the file; refuses it at its first wrong line.
   procedure Load (Loaded : out Script; File : String);

   --  The number of faults that begin at that time or later.
   function Number_From
     (From : Script; Time : Microseconds) return Natural;

   --  The faults of each subject, in the order of time; at the same time, in
   --  the order of the lines.

   --  The times when both directions of the line are cut.
   function Cuts (From : Script) return Windows.List;

   --  The times when no packet of the console reaches the ground.
   function Lost_Consoles (From : Script) return Windows.List;

   --  Bit errors of a direction.
   function Noises (From : Script; Path : Direction) return Fault_List;

   --  Replayed blocks of a direction.
   function Replays (From : Script; Path : Direction) return Fault_List;

   --  Faults of single characters, each a Character_Fault.
   function Of_Characters (From : Script; Path : Direction) return Fault_List;

   --  The stalls of a board of a node.
   function Stalls
     (From : Script; Where : Node; Stalled : Board) return Windows.List;

   --  Each a Hardware_Fault, of either node.
   function Of_Hardware (From : Script) return Fault_List;

   --  Faults of servos, for a plant whose first step begins at that time.
   function For_Plant
     (From : Script; Begins : Microseconds) return Surface_Faults.List;

private

   type One_Path is record
      Noises     : Fault_List;
      Replays    : Fault_List;
      Characters : Fault_List;
   end record;

   type Both_Paths is array (Direction) of One_Path;
   type Board_Stalls is array (Node, Board) of Windows.List;

   --  Each fault is in one of the first six.
   type Script is record
      Cuts     : Windows.List;
      Consoles : Windows.List;
      Paths    : Both_Paths;
      Stalls   : Board_Stalls;
      Hardware : Fault_List;
      Servos   : Fault_List;

      --  All of them again, for counting.
      Every    : Fault_List;
   end record;

   function Cuts (From : Script) return Windows.List is (From.Cuts);

   function Lost_Consoles (From : Script) return Windows.List is
     (From.Consoles);

   function Noises (From : Script; Path : Direction) return Fault_List is
     (From.Paths (Path).Noises);

   function Replays (From : Script; Path : Direction) return Fault_List is
     (From.Paths (Path).Replays);

   function Of_Characters (From : Script; Path : Direction) return Fault_List
   is
     (From.Paths (Path).Characters);

   function Stalls
     (From : Script; Where : Node; Stalled : Board) return Windows.List
   is
     (From.Stalls (Where, Stalled));

   function Of_Hardware (From : Script) return Fault_List is (From.Hardware);

end Sim.Faults;
