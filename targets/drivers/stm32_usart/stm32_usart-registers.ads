--  SPDX-License-Identifier: Apache-2.0

--  Access to the registers of the serial ports, one access of the bus each
--  (BRD-6, D-92).
--
--  This is a boundary of the proof: a contract here is what the reference
--  manual says of the register, and which conditions it sets. On the Cortex-M4
--  the body reads and writes the register. In the tests the body is a
--  simulated chip, which executes these contracts.

with STM32_USART.Models; use STM32_USART.Models;

package STM32_USART.Registers
  with
    SPARK_Mode,
    Abstract_State => Chip,
    Initializes    => Chip
is

   pragma Unevaluated_Use_Of_Old (Allow);

   --  The state of a port, and the character with a number that it receives or
   --  will receive. A character does not change.

   function State (Port : Port_Name) return Port_Model
   with Ghost, Global => Chip;

   function Received_Character
     (Port   : Port_Name;
      Number : Event_Number) return Heard_Character
   with Ghost, Global => null;

   procedure Write_Control_1 (Port : Port_Name; Value : Control_1)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       Follows (State (Port), (State (Port)'Old with delta Settings => Value));

   --  Stop bits and bit time change only while receiver and sender are off.

   procedure Write_Control_2 (Port : Port_Name; Value : Control_2)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => Is_Off (State (Port)),
     Post   =>
       Follows
         (State (Port), (State (Port)'Old with delta More_Settings => Value));

   procedure Write_Divider (Port : Port_Name; Value : Divider)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => Is_Off (State (Port)),
     Post   =>
       Follows (State (Port), (State (Port)'Old with delta Bit_Time => Value));

   procedure Read_Status (Port : Port_Name; Status : out Port_Status)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       Follows
         (State (Port),
          (State (Port)'Old with delta
             Overrun_Shown => Status.Overrun,
             Parity_Shown  =>
               Status.Received and then Status.Wrong_Parity))
       and then
         Shows
           (Status, State (Port),
            Received_Character (Port, State (Port).Present));

   --  The present character, or an old one if there is none, without its
   --  parity bit.
   procedure Read_Data (Port : Port_Name; Data : out Byte)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       Is_Read (State (Port), State (Port)'Old)
       and then
         (if State (Port)'Old.Received
          then Data =
            Received_Character (Port, State (Port)'Old.Present).Data);

   procedure Write_Data (Port : Port_Name; Data : Byte)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    =>
       State (Port).Settings.Port_On
       and then State (Port).Settings.Sender_On
       and then State (Port).Takes_Character
       and then not State (Port).Parity_Shown,
     Post   => Follows (State (Port), With_Character (State (Port)'Old, Data));

end STM32_USART.Registers;
