--  SPDX-License-Identifier: Apache-2.0

--  A telemetry board: its memory, its two halves, and whose turn it is on the
--  link (report, appendix A; LNK-1 to LNK-10, D-18, D-20, D-22).
--
--  The board's interrupt handler calls Accept_Character, its main program
--  Next_Character whenever the transmitter is empty, and its timer Elapse.
--  The controller uses Take and Put. Time is counted in character times.
--
--  When a board that waits hears nothing for the dead space it resets
--  itself. The ground, before it starts afresh, stays idle until it has
--  heard nothing for longer than the aircraft's dead space: by then the
--  aircraft has reset itself too (LNK-9, D-7; docs/link.md has the
--  argument).

with Telemetry.Checksum;
with Telemetry.Headers;   use Telemetry.Headers;
with Telemetry.Memory;    use Telemetry.Memory;
with Telemetry.Receivers; use Telemetry.Receivers;
with Telemetry.Senders;   use Telemetry.Senders;

package Telemetry.Boards with Pure, SPARK_Mode is

   --  How long a board waits for the other one.
   Dead_Space : constant Character_Times := 20;

   --  How long the line must be silent before the ground starts afresh.
   Idle_Time  : constant Character_Times := 24;

   type Turn is
     (Ready,             --  nothing of ours is on its way
      Sending,           --  a data message
      Awaiting_Status,   --  the answer to our data message
      Awaiting_Data,     --  ground: the answer to a command to downlink
      Idling);           --  ground: in its reset

   --  The answer owed to a data message.
   type Reply is (None, Good, Bad);

   --  A ground board that knows of a waiting downlink asks for it twice at
   --  the most.
   type Turn_Count is range 0 .. 2;

   type Statistics is record
      Sent      : Count := 0;   --  data messages, retries included
      Received  : Count := 0;   --  data messages with a good checksum
      Bad       : Count := 0;   --  data messages that came bad or cut short
      Scrapped  : Count := 0;   --  blocks given up after two transmissions
      Cleared   : Count := 0;   --  blocks cleared for a newer one (LNK-7)
      Resets    : Count := 0;   --  dead space resets

      --  Blocks received that the controller had not taken when the next
      --  one came. It never will: of two full buffers it gets the newer.
      Not_Taken : Count := 0;
   end record;

   --  Transmit_Length and Receive_Length are the lengths of the blocks that
   --  the board sends and is sent.
   type Board
     (Role            : Station;
      Transmit_Length : Block_Length;
      Receive_Length  : Block_Length)
   is record
      Receive_Pair   : Buffer_Pair;
      Transmit_Pair  : Buffer_Pair;
      Receiver       : Receivers.Receiver;
      Sender         : Senders.Sender;
      State          : Turn            := Ready;
      Owed           : Reply           := None;

      --  A character of ours is on the line.
      Line_Taken     : Boolean         := False;

      --  For how long nothing has been heard or sent.
      Silence        : Character_Times := 0;

      --  Ground: how often the aircraft may still be told to downlink.
      Downlink_Turns : Turn_Count      := 0;

      --  Aircraft: it has been told to downlink.
      Clear_To_Send  : Boolean         := False;

      --  Data messages received, for the controller (LNK-10).
      Messages       : Count           := 0;

      Tally          : Statistics;
   end record;

   --  The board holds together. True of every board that the operations
   --  below have made, whatever came in.
   function Is_Sound (Item : Board) return Boolean is
     (Fits (Item.Receiver, Item.Receive_Pair, Item.Receive_Length)

      --  A transmit buffer is busy while its block is on its way, and only
      --  then. Elsewhere a full one has been transmitted once at the most.
      and then
        (for all Which in Slot =>
           (if Item.State in Sending | Awaiting_Status
              and then Which = Item.Sender.Source
            then Item.Transmit_Pair.Slots (Which).Busy
              and then Item.Transmit_Pair.Slots (Which).Full
              and then Item.Transmit_Pair.Slots (Which).Attempts > 0
            else not Item.Transmit_Pair.Slots (Which).Busy
              and then Item.Transmit_Pair.Slots (Which).Attempts < 2))
      and then
        (if Item.State = Sending
         then Fits
                (Item.Sender,
                 Item.Transmit_Pair.Slots (Item.Sender.Source).Data,
                 Item.Transmit_Length))

      --  An answer is owed only between messages.
      and then
        (if Item.Owed /= None
         then Item.State = Ready and then Item.Receiver.State = At_Start)
      and then
        (if Item.Receiver.State = In_Data
         then Item.State =
           (if Item.Role = Ground then Awaiting_Data else Ready))
      and then
        (if Item.Role = Ground
         then Item.Receiver.State /= Out_Of_Step
           and then not Item.Clear_To_Send
         else Item.State not in Awaiting_Data | Idling
           and then Item.Downlink_Turns = 0))
   with Global => null;

   --  The board has something on the line or is about to: the link is half
   --  duplex, so it hears nothing meanwhile.
   function Is_Talking (Item : Board) return Boolean is
     (Item.Line_Taken or else Item.Owed /= None or else Item.State = Sending)
   with Global => null;

   --  The board waits for the other one, and not for ever.
   function Is_Waiting (Item : Board) return Boolean is
     (Item.State in Awaiting_Status | Awaiting_Data | Idling
      or else Item.Receiver.State /= At_Start)
   with Global => null;

   --  The board may have a character to send: nothing but its own turn
   --  keeps it from speaking.
   function May_Speak (Item : Board) return Boolean is
     (Is_Talking (Item)
      or else (Item.State = Ready and then Item.Receiver.State = At_Start))
   with Global => null;

   function Patience (Item : Board) return Character_Times is
     (if Item.State = Idling then Idle_Time else Dead_Space)
   with Global => null;

   --  Value, one higher if something is so.
   function Counted (Value : Count; If_So : Boolean) return Count is
     (if If_So then Incremented (Value) else Value)
   with
     Ghost,
     Global => null;

   --  The transmit half when the block on its way, if there is one, is
   --  given up: it is tried again or scrapped (LNK-6).
   function Pair_Given_Up (Item : Board) return Buffer_Pair is
     (if Item.State in Sending | Awaiting_Status
      then Refused (Item.Transmit_Pair, Item.Sender.Source)
      else Item.Transmit_Pair)
   with
     Ghost,
     Global => null;

   --  The transmit half when the block on its way is answered.
   function Pair_Answered
     (Item      : Board;
      Confirmed : Boolean) return Buffer_Pair
   is
     (if Confirmed then Emptied (Item.Transmit_Pair, Item.Sender.Source)
      else Pair_Given_Up (Item))
   with
     Ghost,
     Global => null;

   --  How often the ground may tell the aircraft to downlink then.
   function Turns_Given
     (Item           : Board;
      Wants_Downlink : Boolean) return Turn_Count
   is
     (if Item.Role = Aircraft then Item.Downlink_Turns
      elsif Wants_Downlink then Turn_Count'Last
      else 0)
   with
     Ghost,
     Global => null;

   --  Whether a block on its way that is given up is scrapped.
   function Is_Scrapped (Item : Board) return Boolean is
     (Item.State in Sending | Awaiting_Status
      and then Item.Transmit_Pair.Slots (Item.Sender.Source).Attempts =
                 Attempt_Count'Last)
   with
     Ghost,
     Global => null;

   --  The board after its dead space has passed (LNK-9): nothing is coming
   --  in and no block is on its way. A ground goes into its idle time and
   --  from there to Ready, an aircraft to Ready.
   function Reset_Board (Item : Board) return Board is
     ((Item with delta
         Receiver      => (Item.Receiver with delta State => At_Start),
         Receive_Pair  => Released (Item.Receive_Pair),
         Transmit_Pair => Pair_Given_Up (Item),
         State         =>
           (if Item.Role = Ground and then Item.State /= Idling
            then Idling else Ready),
         Silence       => 0,
         Tally         => (Item.Tally with delta
           Bad      =>
             Counted (Item.Tally.Bad, Item.Receiver.State = In_Data),
           Scrapped => Counted (Item.Tally.Scrapped, Is_Scrapped (Item)),
           Resets   => Counted (Item.Tally.Resets, Item.State /= Idling))))
   with
     Ghost,
     Global => null;

   --  What a character brings to a board that listens.
   function Heard
     (Item         : Board;
      Data         : Byte;
      Parity_Error : Boolean) return Event
   is
     (Outcome_Of
        (Item         => Item.Receiver,
         Length       => Item.Receive_Length,
         Wants_Data   => Item.Role = Aircraft
                           or else Item.State = Awaiting_Data,
         Data         => Data,
         Parity_Error => Parity_Error))
   with
     Ghost,
     Global => null;

   --  It is the answer to our block.
   function Is_Answer (Item : Board; What : Event) return Boolean is
     (Item.State = Awaiting_Status and then What.Kind = Receivers.Status)
   with
     Ghost,
     Global => null;

   --  It tells that our block did not arrive: it says so, the ground speaks
   --  of other things, or it makes no sense to the ground.
   function Is_Refusal (Item : Board; What : Event) return Boolean is
     (Item.State = Awaiting_Status
      and then
        (case What.Kind is
            when Receivers.Status      => not What.Good,
            when Command | Block_Begun => Item.Role = Aircraft,
            when Lost_Step             => Item.Role = Ground,
            when others                => False))
   with
     Ghost,
     Global => null;

   --  The board after a character that brought this, but for the receiver.
   function Informed (Item : Board; What : Event) return Board is
     ((Item with delta
         Transmit_Pair  =>
           (if Is_Refusal (Item, What) then Pair_Given_Up (Item)
            elsif Is_Answer (Item, What)
            then Pair_Answered (Item, What.Good)
            else Item.Transmit_Pair),
         State          =>
           (if What.Kind = Lost_Step and then Item.Role = Ground then Idling
            elsif What.Kind in Block_Good | Block_Bad
              or else Is_Answer (Item, What)
              or else Is_Refusal (Item, What)
            then Ready
            else Item.State),
         Owed           =>
           (case What.Kind is
               when Block_Good => Good,
               when Block_Bad  => Bad,
               when others     => Item.Owed),
         Silence        => 0,
         Downlink_Turns =>
           (if What.Kind = Block_Good then 0
            elsif Is_Answer (Item, What)
            then Turns_Given (Item, What.Wants_Downlink)
            else Item.Downlink_Turns),

         --  The ground needs no permission and disregards it (LNK-3).
         Clear_To_Send  =>
           Item.Clear_To_Send
           or else (What.Kind = Command and then Item.Role = Aircraft),
         Messages       => Counted (Item.Messages, What.Kind = Block_Good),
         Tally          => (Item.Tally with delta
           Received  =>
             Counted (Item.Tally.Received, What.Kind = Block_Good),
           Bad       => Counted (Item.Tally.Bad, What.Kind = Block_Bad),
           Scrapped  => Counted
             (Item.Tally.Scrapped,
              Is_Refusal (Item, What) and then Is_Scrapped (Item)),
           Resets    => Counted
             (Item.Tally.Resets,
              What.Kind = Lost_Step and then Item.Role = Ground),
           Not_Taken => Counted
             (Item.Tally.Not_Taken,
              What.Kind = Block_Good
                and then Item.Receive_Pair.Slots
                           (Other (Item.Receiver.Target)).Full))))
   with
     Ghost,
     Global => null;

   --  The receiver after it. Where it makes no sense the aircraft waits for
   --  silence as it is; the ground leaves at once for its idle time.
   function Receiver_Informed
     (Item         : Board;
      What         : Event;
      Data         : Byte;
      Parity_Error : Boolean) return Receivers.Receiver
   is
     (if What.Kind = Lost_Step and then Item.Role = Ground
      then (Item.Receiver with delta State => At_Start)
      else Receiver_After
        (Item.Receiver, Item.Receive_Pair, What.Kind, Data, Parity_Error))
   with
     Ghost,
     Global => null,
     Pre    => Is_Sound (Item)
       and then What = Heard (Item, Data, Parity_Error);

   --  The board after a character that it listens to.
   function Board_After
     (Item         : Board;
      What         : Event;
      Data         : Byte;
      Parity_Error : Boolean) return Board
   is
     ((Informed (Item, What) with delta
         Receiver     => Receiver_Informed (Item, What, Data, Parity_Error),
         Receive_Pair => Pair_After
           (Item.Receiver, Item.Receive_Pair, What.Kind, Data)))
   with
     Ghost,
     Global => null,
     Pre    => Is_Sound (Item)
       and then What = Heard (Item, Data, Parity_Error);

   --  A character has arrived.
   procedure Accept_Character
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)

       --  While the board talks it hears nothing; in its reset, nothing but
       --  that the line is not silent.
       and then Item =
         (if Is_Talking (Item'Old)
          then Item'Old
          elsif Item'Old.State = Idling
          then (Item'Old with delta Silence => 0)
          else Board_After
            (Item'Old,
             Heard (Item'Old, Data, Parity_Error), Data, Parity_Error))

       --  A receive buffer becomes full only with a data message whose
       --  checksum matched; that one is counted, and owed a good status.
       and then
         (for all Which in Slot =>
            (if Item.Receive_Pair.Slots (Which).Full
               and then not Item'Old.Receive_Pair.Slots (Which).Full
             then not Parity_Error
               and then Item'Old.Receiver.State = In_Data
               and then Item'Old.Receiver.Target = Which
               and then Item'Old.Receiver.Received = Item.Receive_Length
               and then not Item'Old.Receiver.Damaged
               and then Data = Checksum.Of_Message
                 (Data_Header (Item.Receive_Length),
                  Item.Receive_Pair.Slots (Which).Data,
                  Item.Receive_Length)
               and then Item.Receive_Pair.Newest = Which
               and then Item.Owed = Good))

       --  The counter counts exactly those.
       and then Item.Messages =
         (if (for some Which in Slot =>
                Item.Receive_Pair.Slots (Which).Full
                and then not Item'Old.Receive_Pair.Slots (Which).Full)
          then Incremented (Item'Old.Messages)
          else Item'Old.Messages)

       --  So is one that finds the block before not taken yet: both buffers
       --  are full from then on.
       and then Item.Tally.Not_Taken =
         (if Both_Full (Item.Receive_Pair)
            and then not Both_Full (Item'Old.Receive_Pair)
          then Incremented (Item'Old.Tally.Not_Taken)
          else Item'Old.Tally.Not_Taken)

       --  A block that the controller has not taken is overwritten only
       --  when both buffers are full, and then it is the older one (LNK-4).
       and then
         (for all Which in Slot =>
            (if Item'Old.Receive_Pair.Slots (Which).Full
               and then not Item.Receive_Pair.Slots (Which).Full
             then Both_Full (Item'Old.Receive_Pair)
               and then Which = Other (Item'Old.Receive_Pair.Newest)))

       --  Nothing is ever put into a transmit buffer here.
       and then
         (for all Which in Slot =>
            Item.Transmit_Pair.Slots (Which).Data =
              Item'Old.Transmit_Pair.Slots (Which).Data
            and then
              (if Item.Transmit_Pair.Slots (Which).Full
               then Item'Old.Transmit_Pair.Slots (Which).Full
                 and then Item.Transmit_Pair.Slots (Which).Attempts =
                   Item'Old.Transmit_Pair.Slots (Which).Attempts));

   --  The board may begin to send a block.
   function May_Begin_Block (Item : Board) return Boolean is
     (Item.State = Ready
      and then Item.Owed = None
      and then Item.Receiver.State = At_Start
      and then (Item.Role = Ground or else Item.Clear_To_Send)
      and then Any_Full (Item.Transmit_Pair))
   with
     Ghost,
     Global => null;

   --  The ground may let the aircraft send a block (LNK-8).
   function May_Command (Item : Board) return Boolean is
     (Item.State = Ready
      and then Item.Owed = None
      and then Item.Receiver.State = At_Start
      and then not May_Begin_Block (Item)
      and then Item.Downlink_Turns > 0)
   with
     Ghost,
     Global => null;

   --  Dead space begins when our last character has left.
   function Silence_Now (Item : Board) return Character_Times is
     (if Item.Line_Taken then 0 else Item.Silence)
   with
     Ghost,
     Global => null;

   --  The transmitter is empty: Data is the next character if Send is True,
   --  else there is none now.
   procedure Next_Character
     (Item : in out Board;
      Send : out Boolean;
      Data : out Byte)
   with
     Global         => null,
     Pre            => Is_Sound (Item),
     Post           => Is_Sound (Item) and then Item.Line_Taken = Send,
     Contract_Cases =>
       --  An owed status goes out first.
       (Item.Owed /= None =>
          Send
          and then Data = Encode
            ((Kind           => Headers.Status,
              Good           => Item'Old.Owed = Good,
              Wants_Downlink =>
                Item.Role = Aircraft
                and then Any_Full (Item.Transmit_Pair)))
          and then Item = (Item'Old with delta
            Owed       => None,
            Line_Taken => True,
            Silence    => Silence_Now (Item'Old)),

        --  A data message goes out as header, data, checksum.
        Item.State = Sending =>
          Send
          and then Data = Message_Byte
            (Item'Old.Transmit_Pair.Slots (Item'Old.Sender.Source).Data,
             Item.Transmit_Length,
             Item'Old.Sender.Sent + 1)
          and then Item = (Item'Old with delta
            Sender     => Advanced
              (Item'Old.Sender,
               Item'Old.Transmit_Pair.Slots (Item'Old.Sender.Source).Data,
               Item.Transmit_Length),
            State      =>
              (if Item'Old.Sender.Sent + 1 =
                    Message_Length (Item.Transmit_Length)
               then Awaiting_Status else Sending),
            Line_Taken => True,
            Silence    => Silence_Now (Item'Old)),

        --  A block that begins is the newest, is now transmitted once more,
        --  and is alone.
        May_Begin_Block (Item) =>
          Send
          and then Data = Data_Header (Item.Transmit_Length)
          and then Item = (Item'Old with delta
            Transmit_Pair => Begun
              (Item'Old.Transmit_Pair, Newest_Full (Item'Old.Transmit_Pair)),
            Sender        =>
              (Source => Newest_Full (Item'Old.Transmit_Pair),
               Sent   => 1,
               Sum    => Checksum.Next (Checksum.First_Value, Data)),
            State         => Sending,
            Line_Taken    => True,
            Silence       => Silence_Now (Item'Old),
            Clear_To_Send => False,
            Tally         => (Item'Old.Tally with delta
              Sent    => Incremented (Item'Old.Tally.Sent),
              Cleared => Counted
                (Item'Old.Tally.Cleared, Both_Full (Item'Old.Transmit_Pair)))),

        --  Without one of its own, the ground lets the aircraft send.
        May_Command (Item) =>
          Send
          and then Data = Encode ((Kind => Command_To_Downlink))
          and then Item = (Item'Old with delta
            State          => Awaiting_Data,
            Line_Taken     => True,
            Silence        => Silence_Now (Item'Old),
            Downlink_Turns => Item'Old.Downlink_Turns - 1),

        --  Who waits is silent. A permission that finds no block lapses.
        others =>
          not Send
          and then Data = 0
          and then Item = (Item'Old with delta
            Line_Taken    => False,
            Silence       => Silence_Now (Item'Old),
            Clear_To_Send =>
              Item'Old.Clear_To_Send
              and then (Item'Old.State /= Ready
                        or else Item'Old.Receiver.State /= At_Start)));

   --  Time has passed. A board that has waited for too long resets itself.
   procedure Elapse (Item : in out Board; Time : Character_Times)
   with
     Global         => null,
     Pre            => Is_Sound (Item),
     Post           => Is_Sound (Item),
     Contract_Cases =>
       (Is_Talking (Item) or else not Is_Waiting (Item) =>
          Item = Item'Old,

        --  Silence shorter than its patience changes nothing.
        not Is_Talking (Item)
          and then Is_Waiting (Item)
          and then Time < Patience (Item)
          and then Item.Silence < Patience (Item) - Time =>
            Item = (Item'Old with delta
                      Silence => Item'Old.Silence + Time),

        others => Item = Reset_Board (Item'Old));

   --  How long until the board resets itself if nothing happens; the last
   --  value if it never does.
   function Time_Left (Item : Board) return Character_Times is
     (if Is_Talking (Item) or else not Is_Waiting (Item)
      then Character_Times'Last
      elsif Item.Silence >= Patience (Item)
      then 0
      else Patience (Item) - Item.Silence)
   with Global => null;

   --  The controller takes the newest block received, if there is one.
   --  Ever_Received tells that there has been any since the board started.
   procedure Take
     (Item          : in out Board;
      Data          : out Block_Data;
      Fresh         : out Boolean;
      Ever_Received : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then Fresh = Any_Full (Item'Old.Receive_Pair)
       and then Ever_Received = (Item'Old.Messages > 0)
       and then
         (if Fresh
          then Data = Item'Old.Receive_Pair.Slots
                        (Newest_Full (Item'Old.Receive_Pair)).Data
          else Data = (Data'Range => 0))
       and then Item = (Item'Old with delta
         Receive_Pair => Taken (Item'Old.Receive_Pair));

   --  The controller gives a block to transmit. Overwrote tells that it
   --  replaced one that was still waiting.
   procedure Put
     (Item      : in out Board;
      Data      : Block_Data;
      Overwrote : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then Overwrote = Both_Full (Item'Old.Transmit_Pair)
       and then Any_Full (Item.Transmit_Pair)
       and then Newest_Full (Item.Transmit_Pair) = Item.Transmit_Pair.Newest
       and then Item.Transmit_Pair.Slots (Item.Transmit_Pair.Newest).Data =
                  Data
       and then Item = (Item'Old with delta
         Transmit_Pair => Filled (Item'Old.Transmit_Pair, Data));

   --  The controller's part of the start: transmit buffers empty, flags
   --  empty, semaphores available (INI-4). A ground board whose message is
   --  broken off idles before it sends again, as after a reset.
   procedure Clear_Transmit_Half (Item : in out Board)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then Item =
         (if Item'Old.State in Sending | Awaiting_Status
          then
            (Item'Old with delta
               Transmit_Pair => Empty_Pair,
               State         =>
                 (if Item.Role = Ground then Idling else Ready),
               Silence       => 0)
          else (Item'Old with delta Transmit_Pair => Empty_Pair));

   --  The board's own start: a board that has neither sent nor received,
   --  but for its transmit buffers, which are the controller's (INI-4). It
   --  may have been in the middle of a message: the ground idles first.
   procedure Start (Item : in out Board)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then Item = (Item'Old with delta
         Receive_Pair   => Empty_Pair,
         Transmit_Pair  => Pair_Given_Up (Item'Old),
         Receiver       => (others => <>),
         State          => (if Item.Role = Ground then Idling else Ready),
         Owed           => None,
         Line_Taken     => False,
         Silence        => 0,
         Downlink_Turns => 0,
         Clear_To_Send  => False,
         Messages       => 0,
         Tally          => (Item'Old.Tally with delta
           Scrapped =>
             Counted (Item'Old.Tally.Scrapped, Is_Scrapped (Item'Old))));

end Telemetry.Boards;
