--  SPDX-License-Identifier: Apache-2.0

--  The receiving half of the board's software: one character in, one event
--  out (report, appendix A.2; LNK-3 to LNK-5, D-27).
--
--  The data of a message goes, byte by byte, into the receive buffer that was
--  chosen at its header. The buffer is busy until the message ends. It
--  becomes full only if the checksum matched, no character had a parity error,
--  and no character followed the checksum until the board judged the message.
--
--  After a first byte that is no header the receiver is out of step. It cannot
--  know where the next message begins, so it ignores all characters until the
--  board resets it to the start.
--
--  Accept_Character assigns the results of these functions.

with Telemetry.Checksum;
with Telemetry.Headers; use Telemetry.Headers;
with Telemetry.Memory;  use Telemetry.Memory;

package Telemetry.Receivers with Pure, SPARK_Mode is

   type Receiver_State is
     (At_Start,
      In_Data,
      At_End,        --  the checksum has come; characters may follow
      Out_Of_Step);

   type Receiver is record
      State    : Receiver_State := At_Start;

      --  The buffer for the data, and the number of bytes received.
      Target   : Slot       := First;
      Received : Byte_Count := 0;

      --  The checksum so far; Damaged if any error was found in this message.
      Sum      : Byte    := 0;
      Damaged  : Boolean := False;
   end record
   with Alignment => 2;

   function Data_Header (Length : Block_Length) return Byte is
     (Encode ((Kind => Data, Length => Length)))
   with Global => null;

   --  A data message has begun and is not judged yet.
   function Has_Message (This : Receiver) return Boolean is
     (This.State in In_Data | At_End)
   with Global => null;

   --  The receiver agrees with its buffers: within a message, the buffer is
   --  claimed and not full, and Sum is the checksum of the bytes in it.
   function Fits
     (This   : Receiver;
      Pair   : Buffer_Pair;
      Length : Block_Length) return Boolean
   is
     (if Has_Message (This)
      then This.Received <= Length
        and then (if This.State = At_End then This.Received = Length)
        and then Pair.Slots (This.Target).Busy
        and then not Pair.Slots (This.Target).Full
        and then not Pair.Slots (Other (This.Target)).Busy
        and then This.Sum = Checksum.Of_Message
                   (Data_Header (Length),
                    Pair.Slots (This.Target).Data,
                    This.Received)
      else not Pair.Slots (First).Busy and then not Pair.Slots (Second).Busy)
   with Global => null;

   type Event_Kind is
     (Nothing,
      Lost_Step,     --  a first byte that is no header or not wanted now
      Command,       --  command to downlink
      Status,        --  see the other components of Event
      Block_Begun,   --  the header of a data message
      Block_Whole,   --  its last character: the checksum matched
      Block_Spoilt); --  the checksum was wrong, or a character follows it

   type Event is record
      Kind           : Event_Kind := Nothing;
      Good           : Boolean    := False;
      Wants_Downlink : Boolean    := False;
   end record
   with Alignment => 2;

   --  The meaning of a first byte.
   function Meaning
     (Data         : Byte;
      Parity_Error : Boolean;
      Length       : Block_Length;
      Wants_Data   : Boolean) return Event
   is
     (if Parity_Error or else not Is_Valid (Data)
      then (Kind => Lost_Step, others => False)
      else
        (case Kind_Of (Data) is
            when Command_To_Downlink => (Kind => Command, others => False),
            when Headers.Status      =>
              (Kind           => Status,
               Good           => Is_Good (Data),
               Wants_Downlink => Wants_Downlink (Data)),
            when Headers.Data        =>
              (Kind   => (if Wants_Data and then Data = Data_Header (Length)
                          then Block_Begun else Lost_Step),
               others => False)))
   with Global => null;

   --  The event that a character causes. Between messages it is a header, or
   --  the receiver loses step. After the data it is the checksum, which the
   --  receiver compares with its own (see Fits). After the checksum no
   --  character may follow. Out of step it is noise. Length is that of the
   --  blocks sent to this board. A data message is accepted only if the board
   --  wants one.
   function Outcome_Of
     (This         : Receiver;
      Length       : Block_Length;
      Wants_Data   : Boolean;
      Data         : Byte;
      Parity_Error : Boolean) return Event
   is
     (case This.State is
         when At_Start    =>
           Meaning (Data, Parity_Error, Length, Wants_Data),
         when In_Data     =>
           (Kind   =>
              (if This.Received < Length then Nothing
               elsif not This.Damaged
                 and then not Parity_Error
                 and then Data = This.Sum
               then Block_Whole
               else Block_Spoilt),
            others => False),
         when At_End      => (Kind => Block_Spoilt, others => False),
         when Out_Of_Step => (others => <>))
   with Global => null;

   --  The character is a byte of the block.
   function Is_Stored (This : Receiver; Outcome : Event_Kind) return Boolean
   is
     (This.State = In_Data and then Outcome = Nothing)
   with Global => null;

   --  The receiver after a character with this outcome.
   function Receiver_After
     (This         : Receiver;
      Pair         : Buffer_Pair;
      Outcome      : Event_Kind;
      Data         : Byte;
      Parity_Error : Boolean) return Receiver
   is
     (case Outcome is
         when Lost_Step        => (This with delta State => Out_Of_Step),
         when Command | Status => This,
         when Block_Begun      =>
           (State    => In_Data,
            Target   => To_Fill (Pair),
            Received => 0,
            Sum      => Checksum.Next (Checksum.First_Value, Data),
            Damaged  => False),
         when Nothing          =>
           (if Is_Stored (This, Outcome)
            then
              (This with delta
                 Received => This.Received + 1,
                 Sum      => Checksum.Next (This.Sum, Data),
                 Damaged  => This.Damaged or Parity_Error)
            else This),
         when Block_Whole      => (This with delta State => At_End),
         when Block_Spoilt     =>
           (This with delta State => At_End, Damaged => True))
   with
     Global => null,
     Pre    =>
       (if Is_Stored (This, Outcome) then This.Received < Longest_Block);

   --  The buffers after any character but a byte of the block. A message that
   --  begins claims a buffer: it is busy and no longer full.
   function Pair_After
     (Pair : Buffer_Pair; Outcome : Event_Kind) return Buffer_Pair
   is
     (case Outcome is
         when Block_Begun =>
           (Pair with delta
              Slots => (Pair.Slots with delta
                To_Fill (Pair) => (Pair.Slots (To_Fill (Pair)) with delta
                  Busy => True, Full => False))),
         when others      => Pair)
   with Global => null;

   --  The buffers when the message is judged. Only now, after a good message,
   --  does the buffer become full.
   function Pair_Judged (This : Receiver; Pair : Buffer_Pair)
     return Buffer_Pair
   is
     ((Newest => (if This.Damaged then Pair.Newest else This.Target),
       Slots  => (Pair.Slots with delta
         This.Target => (Pair.Slots (This.Target) with delta
           Busy => False, Full => not This.Damaged))))
   with Global => null;

   --  The buffers after a byte of the block.
   function Pair_With_Byte
     (This : Receiver;
      Pair : Buffer_Pair;
      Data : Byte) return Buffer_Pair
   is
     ((Pair with delta
         Slots =>
           (for Each in Slot =>
              (if Each = This.Target
               then (Pair.Slots (Each) with delta
                       Data =>
                         (for Number in Byte_Index =>
                            (if Number = This.Received + 1 then Data
                             else Pair.Slots (Each).Data (Number))))
               else Pair.Slots (Each)))))
   with
     Ghost,
     Global => null,
     Pre    => This.Received < Longest_Block;

   --  The next character is a byte of the block.
   function Takes_Byte (This : Receiver; Length : Block_Length) return Boolean
   is
     (This.State = In_Data and then This.Received < Length)
   with Global => null;

   --  Accepts such a byte. Most characters are of this kind, so it works in
   --  place.
   procedure Store_Byte
     (This         : in out Receiver;
      Pair         : in out Buffer_Pair;
      Length       : Block_Length;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     Inline,
     Global => null,
     Pre    => Fits (This, Pair, Length) and then Takes_Byte (This, Length),
     Post   =>
       Fits (This, Pair, Length)
       and then This = Receiver_After
         (This'Old, Pair'Old, Nothing, Data, Parity_Error)
       and then Pair = Pair_With_Byte (This'Old, Pair'Old, Data);

   --  Accepts any character.
   procedure Accept_Character
     (This         : in out Receiver;
      Pair         : in out Buffer_Pair;
      Length       : Block_Length;
      Wants_Data   : Boolean;
      Data         : Byte;
      Parity_Error : Boolean;
      Outcome      : out Event)
   with
     Global => null,
     Pre    => Fits (This, Pair, Length),
     Post   =>
       Fits (This, Pair, Length)
       and then Outcome = Outcome_Of
         (This'Old, Length, Wants_Data, Data, Parity_Error)
       and then This = Receiver_After
         (This'Old, Pair'Old, Outcome.Kind, Data, Parity_Error)
       and then Pair =
         (if Is_Stored (This'Old, Outcome.Kind)
          then Pair_With_Byte (This'Old, Pair'Old, Data)
          else Pair_After (Pair'Old, Outcome.Kind));

end Telemetry.Receivers;
