--  A telemetry board: its memory, its two halves, and whose turn it is on
--  the link (report, appendix A; LNK-1 to LNK-10).
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

       --  While the board talks it hears nothing.
       and then (if Is_Talking (Item'Old) then Item = Item'Old)

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

   --  The transmitter is empty: Data is the next character if Send is True,
   --  else there is none now.
   procedure Next_Character
     (Item : in out Board;
      Send : out Boolean;
      Data : out Byte)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then Item.Line_Taken = Send

       --  An owed status goes out first.
       and then
         (if Item'Old.Owed /= None
          then Send
            and then Item.Owed = None
            and then Item.State = Item'Old.State
            and then Data = Encode
              ((Kind           => Headers.Status,
                Good           => Item'Old.Owed = Good,
                Wants_Downlink =>
                  Item.Role = Aircraft
                  and then Any_Full (Item.Transmit_Pair))))

       --  A data message goes out as header, data, checksum.
       and then
         (if Item'Old.State = Sending
          then Send
            and then Data = Message_Byte
              (Item'Old.Transmit_Pair.Slots (Item'Old.Sender.Source).Data,
               Item.Transmit_Length,
               Item'Old.Sender.Sent + 1)
            and then Item.Owed = None
            and then Item.Sender =
              (Item.Sender with delta Sent => Item'Old.Sender.Sent + 1)
            and then Item.State =
              (if Item.Sender.Sent = Message_Length (Item.Transmit_Length)
               then Awaiting_Status else Sending))

       --  Who waits is silent. Dead space begins when the last character
       --  has left.
       and then
         (if Item'Old.State in Awaiting_Status | Awaiting_Data | Idling
            or else (Item'Old.State = Ready
                     and then Item'Old.Owed = None
                     and then Item'Old.Receiver.State /= At_Start)
          then not Send
            and then Item.State = Item'Old.State
            and then Item.Owed = Item'Old.Owed
            and then Item.Silence =
              (if Item'Old.Line_Taken then 0 else Item'Old.Silence))

       --  A block that begins is the newest, is now transmitted once more,
       --  and is alone.
       and then
         (if Item'Old.State = Ready and then Item.State = Sending
          then Item.Sender.Source = Newest_Full (Item'Old.Transmit_Pair)
            and then not Item.Transmit_Pair.Slots
                           (Other (Item.Sender.Source)).Full
            and then Item.Transmit_Pair.Slots (Item.Sender.Source).Attempts =
              Item'Old.Transmit_Pair.Slots (Item.Sender.Source).Attempts + 1
            and then (Item.Role = Ground or else Item'Old.Clear_To_Send))

       --  The receive half is not touched.
       and then Item.Receive_Pair = Item'Old.Receive_Pair
       and then Item.Receiver = Item'Old.Receiver
       and then Item.Messages = Item'Old.Messages;

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

        --  Else it resets: the ground into its idle time and from there to
        --  Ready, the aircraft to Ready.
        others =>
          Item.Receiver.State = At_Start
          and then Item.State =
            (if Item.Role = Ground and then Item'Old.State /= Idling
             then Idling else Ready)
          and then Item.Silence = 0
          and then Item.Owed = None
          and then not Item.Line_Taken
          and then Item.Messages = Item'Old.Messages

          --  No block becomes full, and one that stays full has not been
          --  transmitted more often.
          and then
            (for all Which in Slot =>
               Item.Receive_Pair.Slots (Which).Full =
                 Item'Old.Receive_Pair.Slots (Which).Full
               and then Item.Transmit_Pair.Slots (Which).Data =
                 Item'Old.Transmit_Pair.Slots (Which).Data
               and then
                 (if Item.Transmit_Pair.Slots (Which).Full
                  then Item'Old.Transmit_Pair.Slots (Which).Full
                    and then Item.Transmit_Pair.Slots (Which).Attempts =
                      Item'Old.Transmit_Pair.Slots (Which).Attempts)));

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
                        (Newest_Full (Item'Old.Receive_Pair)).Data)
       and then not Any_Full (Item.Receive_Pair)
       and then Item.Transmit_Pair = Item'Old.Transmit_Pair;

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
       and then Item.State = Item'Old.State
       and then Item.Receive_Pair = Item'Old.Receive_Pair;

   --  The controller's part of the start: transmit buffers empty, flags
   --  empty, semaphores available (INI-4). A ground board whose message is
   --  broken off idles before it sends again, as after a reset.
   procedure Clear_Transmit_Half (Item : in out Board)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then Item.Transmit_Pair = Empty_Pair
       and then Item.State =
         (if Item'Old.State not in Sending | Awaiting_Status
          then Item'Old.State
          elsif Item.Role = Ground then Idling
          else Ready)
       and then Item.Receive_Pair = Item'Old.Receive_Pair;

   --  The board's own start: a board that has neither sent nor received,
   --  but for its transmit buffers, which are the controller's (INI-4). It
   --  may have been in the middle of a message: the ground idles first.
   procedure Start (Item : in out Board)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then Item.Receive_Pair = Empty_Pair
       and then Item.State = (if Item.Role = Ground then Idling else Ready)
       and then Item.Receiver.State = At_Start
       and then Item.Silence = 0
       and then Item.Messages = 0
       and then
         (for all Which in Slot =>
            Item.Transmit_Pair.Slots (Which).Data =
              Item'Old.Transmit_Pair.Slots (Which).Data
            and then
              (if Item.Transmit_Pair.Slots (Which).Full
               then Item'Old.Transmit_Pair.Slots (Which).Full));

end Telemetry.Boards;
