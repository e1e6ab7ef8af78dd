--  SPDX-License-Identifier: Apache-2.0

--  The receiving half of the board's software: one character in, one event
--  out (report, appendix A.2; LNK-3 to LNK-5, D-27).
--
--  A data message goes, byte by byte, into the receive buffer that was
--  chosen when its header came. That buffer is busy until the message ends;
--  it becomes full only if the checksum matched, no character had a parity
--  error, and none came after the checksum until the board judged it.
--
--  After a first byte that is no header the receiver is out of step: it can
--  not know where the next message begins, and listens to nothing until the
--  board puts it back at the start.
--
--  These functions are the code: Accept_Character assigns their results.

with Telemetry.Checksum;
with Telemetry.Headers; use Telemetry.Headers;
with Telemetry.Memory;  use Telemetry.Memory;

package Telemetry.Receivers with Pure, SPARK_Mode is

   type Receiver_State is
     (At_Start,
      In_Data,
      At_End,        --  the checksum has come; the message may yet go on
      Out_Of_Step);

   type Receiver is record
      State    : Receiver_State := At_Start;

      --  Where the data goes, and how many bytes of it have come.
      Target   : Slot       := First;
      Received : Byte_Count := 0;

      --  The checksum so far; something was wrong with this message.
      Sum      : Byte    := 0;
      Damaged  : Boolean := False;
   end record;

   function Data_Header (Length : Block_Length) return Byte is
     (Encode ((Kind => Data, Length => Length)))
   with Global => null;

   --  A data message has begun that is not judged yet.
   function Has_Message (This : Receiver) return Boolean is
     (This.State in In_Data | At_End)
   with Global => null;

   --  The receiver and its buffers fit together: within a message, the
   --  buffer is claimed and not full, and the checksum is that of the bytes
   --  in it.
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
      Lost_Step,     --  a first byte that is no header, or none wanted now
      Command,       --  command to downlink
      Status,        --  see the other components of Event
      Block_Begun,   --  the header of a data message
      Block_Whole,   --  its last character: the checksum matched
      Block_Spoilt); --  it did not, or this is one more

   type Event is record
      Kind           : Event_Kind := Nothing;
      Good           : Boolean    := False;
      Wants_Downlink : Boolean    := False;
   end record;

   --  What a first byte means.
   function Meaning
     (Data         : Byte;
      Parity_Error : Boolean;
      Length       : Block_Length;
      Wants_Data   : Boolean) return Event
   is
     (if Parity_Error or else not Is_Valid (Data)
      then (Kind => Lost_Step, others => False)
      else
        (case Decode (Data).Kind is
            when Command_To_Downlink => (Kind => Command, others => False),
            when Headers.Status      =>
              (Kind           => Status,
               Good           => Decode (Data).Good,
               Wants_Downlink => Decode (Data).Wants_Downlink),
            when Headers.Data        =>
              (Kind   => (if Wants_Data and then Decode (Data).Length = Length
                          then Block_Begun else Lost_Step),
               others => False)))
   with Global => null;

   --  What a character brings. Between messages it is a header or nothing;
   --  after the data it is the checksum, and the receiver has that of the
   --  header and the data (see Fits); after that there must be none; out of
   --  step it is noise. Length is
   --  that of the blocks this board is sent; a data message is taken only
   --  when the board wants one.
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

   --  The receiver after a character that brought this.
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

   --  Its buffers after anything but a byte of the block. One is claimed
   --  when a message begins: it is busy, and no longer full.
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

   --  And when the message is judged: only now, after a good one, it is full
   --  again.
   function Pair_Judged (This : Receiver; Pair : Buffer_Pair)
     return Buffer_Pair
   is
     ((Newest => (if This.Damaged then Pair.Newest else This.Target),
       Slots  => (Pair.Slots with delta
         This.Target => (Pair.Slots (This.Target) with delta
           Busy => False, Full => not This.Damaged))))
   with Global => null;

   --  And after a byte of the block.
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

   --  It has come: what most characters are, so it is done in place.
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

   --  A character has come.
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
