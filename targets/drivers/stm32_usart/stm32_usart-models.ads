--  SPDX-License-Identifier: Apache-2.0

--  The state of a serial port as the reference manual describes it, for
--  contracts (BRD-6, D-92). Between two accesses of the program characters
--  arrive and the sender becomes free: Follows permits that.

package STM32_USART.Models with Pure, SPARK_Mode is

   type Port_Model is record
      Settings        : Control_1;
      More_Settings   : Control_2;
      Bit_Time        : Natural;

      --  The data register has a character that was not read. Its number since
      --  power up, or that of the next one.
      Received        : Boolean;
      Present         : Event_Number;

      --  Characters lost since power up, and the flag. A loss sets it.
      Losses          : Event_Number;
      Overrun         : Boolean;

      --  The last read of the status register showed the flag; a read of the
      --  data register resets it then. The number of these resets.
      Overrun_Shown   : Boolean;
      Overrun_Resets  : Event_Number;

      --  The last read of the status register showed the wrong parity of the
      --  present character. Not only a read of the data register resets this
      --  flag then, but a write, too.
      Parity_Shown    : Boolean;

      Takes_Character : Boolean;

      --  Characters given to the sender, and the last one of them.
      Sent            : Event_Number;
      Last_Sent       : Byte;
   end record;

   function Same_Settings (One, Other : Port_Model) return Boolean is
     (One.Settings = Other.Settings
      and then One.More_Settings = Other.More_Settings
      and then One.Bit_Time = Other.Bit_Time);

   function Follows (After, Before : Port_Model) return Boolean is
     (Same_Settings (After, Before)
      and then (if Before.Received then After.Received)
      and then After.Present = Before.Present
      and then
        (if not Before.Settings.Receiver_On
         then After.Received = Before.Received
           and then After.Losses = Before.Losses)
      and then (if Before.Overrun then After.Overrun)
      and then (if After.Losses /= Before.Losses then After.Overrun)
      and then After.Overrun_Shown = Before.Overrun_Shown
      and then After.Overrun_Resets = Before.Overrun_Resets
      and then After.Parity_Shown = Before.Parity_Shown
      and then (if Before.Takes_Character then After.Takes_Character)
      and then After.Sent = Before.Sent
      and then After.Last_Sent = Before.Last_Sent);

   function Is_Off (Port : Port_Model) return Boolean is
     (not Port.Settings.Receiver_On and then not Port.Settings.Sender_On);

   function With_Character (Port : Port_Model; Data : Byte) return Port_Model
   is
     ((Port with delta
         Takes_Character => False,
         Sent            => Port.Sent + 1,
         Last_Sent       => Data));

   --  A read of the data register. A character that arrives just before it may
   --  be lost: if the last status showed an overrun, the flag of this loss is
   --  reset too, else it stays, without a character in the data register.
   function Is_Read (After, Before : Port_Model) return Boolean is
     (Follows
        (After,
         (if Before.Overrun_Shown
          then
            (Before with delta
               Received       => False,
               Present        => After.Present,
               Overrun        => After.Overrun,
               Losses         => After.Losses,
               Overrun_Shown  => False,
               Parity_Shown   => False,
               Overrun_Resets => Before.Overrun_Resets + 1)
          else
            (Before with delta
               Received     => False,
               Parity_Shown => False,
               Present      => After.Present)))
      and then (if Before.Received then After.Present = Before.Present + 1));

   --  The status register of a port with this present character.
   function Shows
     (Status  : Port_Status;
      Port    : Port_Model;
      Present : Heard_Character) return Boolean
   is
     (Status.Received = Port.Received
      and then Status.Takes_Character = Port.Takes_Character
      and then Status.Overrun = Port.Overrun
      and then
        (if Status.Received
         then Status.Wrong_Parity = Present.Wrong_Parity
           and then Status.Wrong_Framing = Present.Wrong_Framing
           and then Status.Noise = Present.Noise));

end STM32_USART.Models;
