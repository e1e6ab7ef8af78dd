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

   --  The result of one call of Receive. Overrun: characters were lost since
   --  the last report of an overrun. They would have come after this one and
   --  others that the receiver holds.
   type Reception is record
      Is_There      : Boolean;
      Data          : Byte;
      Wrong_Parity  : Boolean;
      Wrong_Framing : Boolean;
      Overrun       : Boolean;

      --  The sender takes a character now.
      Sender_Is_Free : Boolean;
   end record
   with Alignment => 2;

   function Is_Damaged (Result : Reception) return Boolean is
     (Result.Wrong_Parity or else Result.Wrong_Framing
      or else Result.Overrun);

   function Raised (Number : Count; When_True : Boolean) return Count is
     (if When_True then Incremented (Number) else Number);

   function Counted
     (Counts        : Error_Counts;
      Overrun       : Boolean;
      Wrong_Parity  : Boolean;
      Wrong_Framing : Boolean) return Error_Counts
   is
     ((Overruns       => Raised (Counts.Overruns, Overrun),
       Parity_Errors  => Raised (Counts.Parity_Errors, Wrong_Parity),
       Framing_Errors => Raised (Counts.Framing_Errors, Wrong_Framing)));

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
      and then Port.Sender_Is_On
      and then not Port.Errors_Are_Gone)
   with Ghost;

   --  Sets the modes and switches receiver and sender on, whatever the chip
   --  was doing.
   procedure Set_Up (Port : Port_Name)
   with
     Global => (In_Out => Chips),
     Post   => Is_Set_Up (State (Port));

   --  The characters come in order, none twice, each with its own errors. A
   --  loss is reported by this call or by a later one. An overrun is reported
   --  once, with a character, and only if the chip has shown it.
   procedure Receive
     (Port   : Port_Name;
      Counts : in out Error_Counts;
      Result : out Reception)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    => not State (Port).Errors_Are_Gone,
     Post   =>
       Same_Settings (State (Port), State (Port)'Old)
       and then not State (Port).Errors_Are_Gone
       and then (if State (Port)'Old.Held > 0 then Result.Is_There)
       and then
         Counts =
           Counted
             (Counts'Old, Result.Overrun, Result.Wrong_Parity,
              Result.Wrong_Framing)
       and then
         State (Port).Oldest =
           State (Port)'Old.Oldest + (if Result.Is_There then 1 else 0)
       and then
         (if Result.Is_There
          then Matches
            (Result, Received_Character (Port, State (Port)'Old.Oldest))
          else not Result.Wrong_Parity and then not Result.Wrong_Framing)
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
          then Result.Sender_Is_Free)
       and then
         (if Result.Sender_Is_Free then State (Port).Takes_Character)
       and then State (Port).Sent = State (Port)'Old.Sent;

   --  A look that costs less than Receive. Faulty: a character waits that has
   --  an error, or after which one was lost. Receive reports it.

   type Arrival is (Nothing, Good, Faulty);

   procedure Look
     (Port           : Port_Name;
      Line           : out Arrival;
      Sender_Is_Free : out Boolean)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    => not State (Port).Errors_Are_Gone,
     Post   =>
       Follows (State (Port), State (Port)'Old)
       and then Sender_Is_Free = State (Port).Takes_Character
       and then (Line = Nothing) = (State (Port).Held = 0)
       and then
         (if Line = Good
          then State (Port).Held > 0
            and then not State (Port).Overrun
            and then Is_Good
              (Received_Character (Port, State (Port).Oldest)));

   function Is_Good (Heard : Heard_Character) return Boolean is
     (not Heard.Wrong_Parity
      and then not Heard.Wrong_Framing
      and then not Heard.Is_Break)
   with Ghost;

   --  The character that Look has shown as Good.
   procedure Take (Port : Port_Name; Data : out Byte)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    => State (Port).Held > 0,
     Post   =>
       Follows (State (Port), Without_Oldest (State (Port)'Old))
       and then
         Data = Received_Character (Port, State (Port)'Old.Oldest).Data;

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
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       Follows (State (Port), State (Port)'Old)
       and then Is_Free = State (Port).Takes_Character;

   procedure Send (Port : Port_Name; Data : Byte)
   with
     Inline,
     Global => (In_Out => Chips),
     Pre    =>
       State (Port).Sender_Is_On and then State (Port).Takes_Character,
     Post   =>
       Follows (State (Port), With_Character (State (Port)'Old, Data));

end MC68681.Channels;
