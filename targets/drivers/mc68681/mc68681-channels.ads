--  SPDX-License-Identifier: Apache-2.0

--  The driver of a serial channel: 8 bits, even parity, 2 stop bits, with the
--  clock of the line from outside (BRD-6).

with MC68681.Models;    use MC68681.Models;
with MC68681.Registers; use MC68681.Registers;

package MC68681.Channels with SPARK_Mode is

   pragma Unevaluated_Use_Of_Old (Allow);

   type Error_Counts is record
      Overruns       : Count := 0;
      Parity_Errors  : Count := 0;
      Framing_Errors : Count := 0;   --  with breaks
   end record;

   --  What one call of Receive has found. Overrun: characters were lost since
   --  the last report of an overrun. They would have come after this one and
   --  others that the receiver holds.
   type Reception is record
      Is_There      : Boolean := False;
      Data          : Byte    := 0;
      Wrong_Parity  : Boolean := False;
      Wrong_Framing : Boolean := False;
      Overrun       : Boolean := False;
   end record;

   function Is_Damaged (Result : Reception) return Boolean is
     (Result.Wrong_Parity or else Result.Wrong_Framing
      or else Result.Overrun);

   function Counted
     (Counts : Error_Counts;
      Result : Reception) return Error_Counts
   is
     ((Overruns       =>
         (if Result.Overrun
          then Incremented (Counts.Overruns) else Counts.Overruns),
       Parity_Errors  =>
         (if Result.Wrong_Parity
          then Incremented (Counts.Parity_Errors) else Counts.Parity_Errors),
       Framing_Errors =>
         (if Result.Wrong_Framing
          then Incremented (Counts.Framing_Errors)
          else Counts.Framing_Errors)));

   Line_Mode_1 : constant Mode_1 :=
     (Size   => Eight_Bits,
      Is_Odd => False,
      Parity => With_Parity,
      others => False);

   Line_Mode_2 : constant Mode_2 :=
     (Stop         => Two_Stop_Bits,
      Obeys_CTS    => False,
      Controls_RTS => False,
      Channel      => Normal);

   function Is_Set_Up (Port : Port_Model) return Boolean is
     (Port.First_Mode = Line_Mode_1
      and then Port.Second_Mode = Line_Mode_2
      and then Port.Clocks = Outside_Clocks
      and then Port.Receiver_Is_On
      and then Port.Sender_Is_On)
   with Ghost;

   --  Sets the modes and switches receiver and sender on, whatever the chip
   --  was doing.
   procedure Set_Up (Port : Port_Name)
   with
     Global => (In_Out => Chips),
     Post   => Is_Set_Up (Ports (Port));

   --  The characters come in order, none twice, each with its own errors. A
   --  loss is reported by this call or by a later one. An overrun is reported
   --  once, and only if the chip has shown it.
   procedure Receive
     (Port   : Port_Name;
      Counts : in out Error_Counts;
      Result : out Reception)
   with
     Global => (In_Out => Chips),
     Post   =>
       Same_Settings (Ports (Port), Ports'Old (Port))
       and then (if Ports'Old (Port).Held > 0 then Result.Is_There)
       and then Counts = Counted (Counts'Old, Result)
       and then
         Ports (Port).Oldest =
           Ports'Old (Port).Oldest + (if Result.Is_There then 1 else 0)
       and then
         (if Result.Is_There
          then Matches
            (Result, Received_Character (Port, Ports'Old (Port).Oldest))
          else not Result.Wrong_Parity and then not Result.Wrong_Framing)
       and then
         (if Ports (Port).Losses /= Ports'Old (Port).Losses
            or else Ports'Old (Port).Overrun
          then Result.Overrun or else Ports (Port).Overrun)
       and then
         (if Result.Overrun
          then Ports (Port).Overrun_Resets =
            Ports'Old (Port).Overrun_Resets + 1
          else Ports (Port).Overrun_Resets = Ports'Old (Port).Overrun_Resets)
       and then
         (if Ports'Old (Port).Takes_Character
          then Ports (Port).Takes_Character)
       and then Ports (Port).Sent = Ports'Old (Port).Sent;

   function Matches
     (Result : Reception;
      Heard  : Heard_Character) return Boolean
   is
     (Result.Data = Heard.Data
      and then Result.Wrong_Parity = Heard.Wrong_Parity
      and then
        Result.Wrong_Framing = (Heard.Wrong_Framing or else Heard.Is_Break))
   with Ghost;

   --  Is_Free: the sender takes a character now.
   procedure Look_At_Sender (Port : Port_Name; Is_Free : out Boolean)
   with
     Global => (In_Out => Chips),
     Post   =>
       Follows (Ports (Port), Ports'Old (Port))
       and then Is_Free = Ports (Port).Takes_Character;

   procedure Send (Port : Port_Name; Data : Byte)
   with
     Global => (In_Out => Chips),
     Pre    =>
       Ports (Port).Sender_Is_On and then Ports (Port).Takes_Character,
     Post   =>
       Follows (Ports (Port), With_Character (Ports'Old (Port), Data));

end MC68681.Channels;
