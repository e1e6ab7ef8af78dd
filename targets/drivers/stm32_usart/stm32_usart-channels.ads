--  SPDX-License-Identifier: Apache-2.0

--  The driver of a serial port: 8 bits, even parity, 2 stop bits (BRD-6).

with STM32_USART.Models;    use STM32_USART.Models;
with STM32_USART.Registers; use STM32_USART.Registers;

package STM32_USART.Channels with SPARK_Mode is

   pragma Unevaluated_Use_Of_Old (Allow);

   type Error_Counts is record
      Overruns       : Count := 0;
      Parity_Errors  : Count := 0;
      Framing_Errors : Count := 0;
      Noisy          : Count := 0;
   end record;

   --  The result of one call of Receive. Overrun: characters were lost since
   --  the last report of an overrun. It may come without a character.
   type Reception is record
      Is_There      : Boolean := False;
      Data          : Byte    := 0;
      Wrong_Parity  : Boolean := False;
      Wrong_Framing : Boolean := False;
      Noise         : Boolean := False;
      Overrun       : Boolean := False;
   end record;

   function Is_Damaged (Result : Reception) return Boolean is
     (Result.Wrong_Parity or else Result.Wrong_Framing
      or else Result.Noise or else Result.Overrun);

   function Raised (Number : Count; When_True : Boolean) return Count is
     (if When_True then Incremented (Number) else Number);

   function Counted
     (Counts : Error_Counts;
      Result : Reception) return Error_Counts
   is
     ((Overruns       => Raised (Counts.Overruns, Result.Overrun),
       Parity_Errors  => Raised (Counts.Parity_Errors, Result.Wrong_Parity),
       Framing_Errors => Raised (Counts.Framing_Errors, Result.Wrong_Framing),
       Noisy          => Raised (Counts.Noisy, Result.Noise)));

   function Line_Settings (Interrupt : Boolean) return Control_1 is
     ((Receiver_On        => True,
       Sender_On          => True,
       Receiver_Interrupt => Interrupt,
       Is_Odd             => False,
       With_Parity        => True,
       Nine_Bits          => True,
       Port_On            => True));

   --  Sets the mode and switches receiver and sender on, whatever the port was
   --  doing. A bit lasts this number of cycles of the bus clock. With
   --  Interrupt each character interrupts, and so does an overrun.
   procedure Set_Up
     (Port      : Port_Name;
      Bit_Time  : Divider;
      Interrupt : Boolean)
   with
     Global => (In_Out => Chip),
     Post   =>
       State (Port).Settings = Line_Settings (Interrupt)
       and then State (Port).More_Settings.Stop = Two
       and then State (Port).Bit_Time = Bit_Time;

   --  The characters come in order, none twice, each with its own errors. A
   --  loss is reported by this call or by a later one. An overrun is reported
   --  once, and only if the port has shown it.
   procedure Receive
     (Port   : Port_Name;
      Counts : in out Error_Counts;
      Result : out Reception)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       Same_Settings (State (Port), State (Port)'Old)
       and then not State (Port).Parity_Shown
       and then (if State (Port)'Old.Received then Result.Is_There)
       and then Counts = Counted (Counts'Old, Result)
       and then
         (if Result.Is_There
          then Matches
              (Result, Received_Character (Port, State (Port)'Old.Present))
            and then State (Port).Present = State (Port)'Old.Present + 1
          else not Result.Wrong_Parity
            and then not Result.Wrong_Framing
            and then not Result.Noise)
       and then
         (if not Result.Is_There and then not Result.Overrun
          then State (Port).Present = State (Port)'Old.Present)
       and then
         (if State (Port).Losses /= State (Port)'Old.Losses
            or else State (Port)'Old.Overrun
          then Result.Overrun or else State (Port).Overrun)
       and then
         (if Result.Overrun
          then State (Port).Overrun_Resets =
            State (Port)'Old.Overrun_Resets + 1
          else State (Port).Overrun_Resets = State (Port)'Old.Overrun_Resets)
       and then
         (if State (Port)'Old.Takes_Character
          then State (Port).Takes_Character)
       and then State (Port).Sent = State (Port)'Old.Sent;

   function Matches
     (Result : Reception;
      Heard  : Heard_Character) return Boolean
   is
     (Result.Data = Heard.Data
      and then Result.Wrong_Parity = Heard.Wrong_Parity
      and then Result.Wrong_Framing = Heard.Wrong_Framing
      and then Result.Noise = Heard.Noise)
   with Ghost;

   --  Is_Free: the sender takes a character now. It does not while a character
   --  with a wrong parity waits: Receive takes that one first.
   procedure Look_At_Sender (Port : Port_Name; Is_Free : out Boolean)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       Is_Free =
         (State (Port).Takes_Character
          and then not State (Port).Parity_Shown)
       and then Same_Settings (State (Port), State (Port)'Old)
       and then State (Port).Present = State (Port)'Old.Present
       and then (if State (Port)'Old.Received then State (Port).Received)
       and then (if State (Port)'Old.Overrun then State (Port).Overrun)
       and then
         (if State (Port).Losses /= State (Port)'Old.Losses
          then State (Port).Overrun);

   procedure Send (Port : Port_Name; Data : Byte)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    =>
       State (Port).Settings.Port_On
       and then State (Port).Settings.Sender_On
       and then State (Port).Takes_Character
       and then not State (Port).Parity_Shown,
     Post   =>
       Follows (State (Port), With_Character (State (Port)'Old, Data));

end STM32_USART.Channels;
