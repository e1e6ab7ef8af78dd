--  The receiving half of the board's software: one character in, one event
--  out (report, appendix A.2; LNK-3 to LNK-5).
--
--  A data message goes, byte by byte, into the receive buffer that was
--  chosen when its header came. That buffer is busy until the message ends;
--  it becomes full only if the checksum matched and no character had a
--  parity error.
--
--  After a first byte that is no header the receiver is out of step: it can
--  not know where the next message begins, and listens to nothing until
--  someone calls Restart.

with Telemetry.Checksum;
with Telemetry.Headers; use Telemetry.Headers;
with Telemetry.Memory;  use Telemetry.Memory;

package Telemetry.Receivers with Pure, SPARK_Mode is

   type Receiver_State is (At_Start, In_Data, Out_Of_Step);

   type Receiver is record
      State    : Receiver_State := At_Start;

      --  Where the data goes, and how many bytes of it have come.
      Target   : Slot       := First;
      Received : Byte_Count := 0;

      --  The checksum so far; a parity error was seen in this message.
      Sum      : Byte    := 0;
      Damaged  : Boolean := False;
   end record;

   function Data_Header (Length : Block_Length) return Byte is
     (Encode ((Kind => Data, Length => Length)))
   with Global => null;

   --  The receiver and its buffers fit together: within a message, the
   --  buffer is claimed and not full, and the checksum is that of the bytes
   --  in it.
   function Fits
     (Item   : Receiver;
      Pair   : Buffer_Pair;
      Length : Block_Length) return Boolean
   is
     (if Item.State = In_Data
      then Item.Received <= Length
        and then Pair.Slots (Item.Target).Busy
        and then not Pair.Slots (Item.Target).Full
        and then not Pair.Slots (Other (Item.Target)).Busy
        and then Item.Sum = Checksum.Of_Message
                   (Data_Header (Length),
                    Pair.Slots (Item.Target).Data,
                    Item.Received)
      else not Pair.Slots (First).Busy and then not Pair.Slots (Second).Busy)
   with Global => null;

   type Event_Kind is
     (Nothing,
      Lost_Step,     --  a first byte that is no header, or none wanted now
      Command,       --  command to downlink
      Status,        --  see the other components of Event
      Block_Begun,   --  the header of a data message
      Block_Good,    --  a data message ended, its checksum matched
      Block_Bad);    --  it did not

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

   --  A character has come. Length is that of the blocks this board is
   --  sent; a data message is taken only when the board wants one.
   procedure Accept_Character
     (Item         : in out Receiver;
      Pair         : in out Buffer_Pair;
      Length       : Block_Length;
      Wants_Data   : Boolean;
      Data         : Byte;
      Parity_Error : Boolean;
      Outcome      : out Event)
   with
     Global         => null,
     Pre            => Fits (Item, Pair, Length),
     Post           => Fits (Item, Pair, Length)
       and then Pair.Slots (Other (Item.Target)) =
                  Pair'Old.Slots (Other (Item.Target)),
     Contract_Cases =>
       --  Between messages, the byte is a header or nothing.
       (Item.State = At_Start =>
          Outcome = Meaning (Data, Parity_Error, Length, Wants_Data)
          and then Item.State =
            (case Outcome.Kind is
                when Block_Begun => In_Data,
                when Lost_Step   => Out_Of_Step,
                when others      => At_Start)
          and then
            (if Outcome.Kind = Block_Begun
             then Item.Target = To_Fill (Pair'Old)
               and then Item.Received = 0
               and then not Item.Damaged
               and then Pair = Claimed (Pair'Old, Item.Target)
             else Pair = Pair'Old),

        --  Within the data, it goes into the buffer.
        Item.State = In_Data and then Item.Received < Length =>
          Outcome = (others => <>)
          and then Item.State = In_Data
          and then Item.Target = Item'Old.Target
          and then Item.Received = Item'Old.Received + 1
          and then Item.Damaged = (Item'Old.Damaged or Parity_Error)
          and then Pair = (Pair'Old with delta
            Slots => (Pair'Old.Slots with delta
              Item.Target => (Pair'Old.Slots (Item.Target) with delta
                Data => (Pair'Old.Slots (Item.Target).Data with delta
                  Item.Received => Data)))),

        --  After the data, it is the checksum. The buffer is full only if
        --  it is that of the header and the bytes in the buffer.
        Item.State = In_Data and then Item.Received = Length =>
          Item.State = At_Start
          and then Outcome =
            (Kind   => (if not Item'Old.Damaged
                          and then not Parity_Error
                          and then Data = Checksum.Of_Message
                                     (Data_Header (Length),
                                      Pair.Slots (Item.Target).Data,
                                      Length)
                        then Block_Good else Block_Bad),
             others => False)
          and then Item.Target = Item'Old.Target
          and then Pair.Newest =
            (if Outcome.Kind = Block_Good
             then Item.Target else Pair'Old.Newest)
          and then Pair.Slots =
            (Pair'Old.Slots with delta
               Item.Target => (Pair'Old.Slots (Item.Target) with delta
                 Busy => False,
                 Full => Outcome.Kind = Block_Good)),

        --  Out of step, it is noise.
        Item.State = Out_Of_Step =>
          Outcome = (others => <>)
          and then Item = Item'Old
          and then Pair = Pair'Old);

   --  A pair with one buffer claimed for filling: busy, and no longer full.
   function Claimed (Pair : Buffer_Pair; Which : Slot) return Buffer_Pair is
     ((Pair with delta
         Slots => (Pair.Slots with delta
           Which => (Pair.Slots (Which) with delta
             Busy => True, Full => False))))
   with Global => null;

   --  Gives up the message that was coming in, if any, and its buffer.
   procedure Restart
     (Item : in out Receiver;
      Pair : in out Buffer_Pair)
   with
     Global => null,
     Post   =>
       Item.State = At_Start
       and then Pair.Newest = Pair'Old.Newest
       and then (for all Which in Slot =>
                   Pair.Slots (Which) =
                     (Pair'Old.Slots (Which) with delta Busy => False));

end Telemetry.Receivers;
