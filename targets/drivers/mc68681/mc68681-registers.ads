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

   --  The chips' states, and the character with a number that a channel
   --  receives or will receive. A character does not change.

   function Ports return Port_Models
   with Ghost, Global => Chips;

   function Chips_Now return Chip_Models
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
     Pre    =>
       not Ports (Port).Receiver_Is_On
       and then not Ports (Port).Sender_Is_On
       and then not Ports (Port).Second_Is_Next,
     Post   =>
       Follow
         (Ports,
          (Ports'Old with delta Port => With_Mode (Ports'Old (Port), Mode)));

   procedure Write_Mode (Port : Port_Name; Mode : Mode_2)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    =>
       not Ports (Port).Receiver_Is_On
       and then not Ports (Port).Sender_Is_On
       and then Ports (Port).Second_Is_Next,
     Post   =>
       Follow
         (Ports,
          (Ports'Old with delta Port => With_Mode (Ports'Old (Port), Mode)));

   procedure Write_Clocks (Port : Port_Name; Clocks : Byte)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    =>
       not Ports (Port).Receiver_Is_On
       and then not Ports (Port).Sender_Is_On,
     Post   =>
       Follow
         (Ports,
          (Ports'Old with delta
             Port => (Ports'Old (Port) with delta Clocks => Clocks)));

   procedure Write_Command (Port : Port_Name; Order : Command)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Obeys (Ports (Port), Ports'Old (Port), Order)
       and then
         (for all Each in Port_Name =>
            (if Each /= Port
             then Follows (Ports (Each), Ports'Old (Each))));

   procedure Read_Status (Port : Port_Name; Status : out Channel_Status)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follow (Ports, Ports'Old)
       and then
         Shows
           (Status, Ports (Port),
            Received_Character (Port, Ports (Port).Oldest));

   --  The oldest character leaves the receiver.
   procedure Read_Data (Port : Port_Name; Data : out Byte)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    => Ports (Port).Held > 0,
     Post   =>
       Follow
         (Ports,
          (Ports'Old with delta Port => Without_Oldest (Ports'Old (Port))))
       and then
         Data = Received_Character (Port, Ports'Old (Port).Oldest).Data;

   procedure Write_Data (Port : Port_Name; Data : Byte)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    =>
       Ports (Port).Sender_Is_On and then Ports (Port).Takes_Character,
     Post   =>
       Follow
         (Ports,
          (Ports'Old with delta
             Port => With_Character (Ports'Old (Port), Data)));

   --  Timers and interrupts

   procedure Write_Auxiliary (Chip : Chip_Name; Value : Byte)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follow
         (Chips_Now,
          (Chips_Now'Old with delta
             Chip => (Chips_Now'Old (Chip) with delta Auxiliary => Value)));

   procedure Write_Count_High (Chip : Chip_Name; Value : Count_Half)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follow
         (Chips_Now,
          (Chips_Now'Old with delta
             Chip => (Chips_Now'Old (Chip) with delta High => Value)));

   procedure Write_Count_Low (Chip : Chip_Name; Value : Count_Half)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follow
         (Chips_Now,
          (Chips_Now'Old with delta
             Chip => (Chips_Now'Old (Chip) with delta Low => Value)));

   --  Begins a period with the count as it is.
   procedure Start_Timer (Chip : Chip_Name)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    =>
       Chips_Now (Chip).Auxiliary = Timer_On_Own_Clock
       and then Count_Of (Chips_Now (Chip)) in Timer_Count,
     Post   =>
       Follow
         (Chips_Now,
          (Chips_Now'Old with delta
             Chip => (Chips_Now'Old (Chip) with delta Runs => True)));

   --  A read of the stop register.
   procedure Answer_Timer (Chip : Chip_Name)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Is_Answered (Chips_Now (Chip), Chips_Now'Old (Chip))
       and then
         (for all Each in Chip_Name =>
            (if Each /= Chip
             then Follows (Chips_Now (Each), Chips_Now'Old (Each))));

   procedure Read_Interrupts (Chip : Chip_Name; Pending : out Interrupt_Set)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follow (Chips_Now, Chips_Now'Old)
       and then Pending.Timer = Chips_Now (Chip).Is_Due;

   procedure Write_Interrupts (Chip : Chip_Name; Used : Interrupt_Set)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follow
         (Chips_Now,
          (Chips_Now'Old with delta
             Chip => (Chips_Now'Old (Chip) with delta Interrupts => Used)));

   procedure Write_Vector (Chip : Chip_Name; Vector : Byte)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follow
         (Chips_Now,
          (Chips_Now'Old with delta
             Chip => (Chips_Now'Old (Chip) with delta Vector => Vector)));

end MC68681.Registers;
