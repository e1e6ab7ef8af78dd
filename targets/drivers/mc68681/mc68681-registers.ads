--  SPDX-License-Identifier: Apache-2.0

--  Access to the registers of the board's MC68681, one access of the bus each
--  (BRD-6, D-92).
--
--  This is a boundary of the proof: a contract here is what the data sheet
--  says of the register, and which conditions it sets. On the MC68000 the body
--  reads and writes the register. In the tests the body is a simulated chip,
--  which executes these contracts.

with MC68681.Models; use MC68681.Models;

package MC68681.Registers
  with
    SPARK_Mode,
    Abstract_State => Chips,
    Initializes    => Chips
is

   pragma Unevaluated_Use_Of_Old (Allow);

   --  The states of channels and chips, and the character with a number that a
   --  channel receives or will receive. A character does not change.

   function State (Port : Port_Name) return Port_Model
   with Ghost, Global => Chips;

   function State (Chip : Chip_Name) return Chip_Model
   with Ghost, Global => Chips;

   function Received_Character
     (Port   : Port_Name;
      Number : Event_Number) return Heard_Character
   with Ghost, Global => null;

   --  Channels. The modes and clocks change only while receiver and sender are
   --  off.

   procedure Write_Mode (Port : Port_Name; Mode : Mode_1)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    => Is_Off (State (Port)) and then not State (Port).Second_Is_Next,
     Post   => Follows (State (Port), With_Mode (State (Port)'Old, Mode));

   procedure Write_Mode (Port : Port_Name; Mode : Mode_2)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    => Is_Off (State (Port)) and then State (Port).Second_Is_Next,
     Post   => Follows (State (Port), With_Mode (State (Port)'Old, Mode));

   procedure Write_Clocks (Port : Port_Name; Clocks : Byte)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    => Is_Off (State (Port)),
     Post   => Follows (State (Port), With_Clocks (State (Port)'Old, Clocks));

   procedure Write_Command (Port : Port_Name; Order : Command)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   => Obeys (State (Port), State (Port)'Old, Order);

   procedure Read_Status (Port : Port_Name; Status : out Channel_Status)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follows (State (Port), State (Port)'Old)
       and then
         Shows
           (Status, State (Port),
            Received_Character (Port, State (Port).Oldest));

   --  The oldest character leaves the receiver.
   procedure Read_Data (Port : Port_Name; Data : out Byte)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    => State (Port).Held > 0,
     Post   =>
       Follows (State (Port), Without_Oldest (State (Port)'Old))
       and then
         Data = Received_Character (Port, State (Port)'Old.Oldest).Data;

   procedure Write_Data (Port : Port_Name; Data : Byte)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    =>
       State (Port).Sender_Is_On and then State (Port).Takes_Character,
     Post   => Follows (State (Port), With_Character (State (Port)'Old, Data));

   --  Timers and interrupts

   procedure Write_Auxiliary (Chip : Chip_Name; Value : Byte)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follows
         (State (Chip), (State (Chip)'Old with delta Auxiliary => Value));

   procedure Write_Count_High (Chip : Chip_Name; Value : Count_Half)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follows (State (Chip), (State (Chip)'Old with delta High => Value));

   procedure Write_Count_Low (Chip : Chip_Name; Value : Count_Half)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follows (State (Chip), (State (Chip)'Old with delta Low => Value));

   --  Begins a period with the count as it is.
   procedure Start_Timer (Chip : Chip_Name)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    =>
       State (Chip).Auxiliary = Timer_On_Own_Clock
       and then Count_Of (State (Chip)) in Timer_Count,
     Post   =>
       Follows (State (Chip), (State (Chip)'Old with delta Runs => True));

   --  A read of the stop register.
   procedure Answer_Timer (Chip : Chip_Name)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   => Is_Answered (State (Chip), State (Chip)'Old);

   procedure Read_Interrupts (Chip : Chip_Name; Pending : out Interrupt_Set)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follows (State (Chip), State (Chip)'Old)
       and then Pending.Timer = State (Chip).Is_Due;

   procedure Write_Interrupts (Chip : Chip_Name; Used : Interrupt_Set)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follows
         (State (Chip), (State (Chip)'Old with delta Interrupts => Used));

   procedure Write_Vector (Chip : Chip_Name; Vector : Byte)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follows (State (Chip), (State (Chip)'Old with delta Vector => Vector));

end MC68681.Registers;
