--  SPDX-License-Identifier: Apache-2.0

--  Whose turn it is on the link, and what follows from it: the protocol
--  (report, appendix A; LNK-2, LNK-3, LNK-6 to LNK-10, D-18, D-20, D-22).
--
--  Control is all that a board knows, but for the blocks in its buffers.
--  These functions are the code: Telemetry.Boards assigns their results.
--
--  When a board that waits hears nothing for the dead space it resets
--  itself. The ground, before it starts afresh, stays idle until it has
--  heard nothing for longer than that: by then the aircraft has reset itself
--  too (LNK-9, D-7; docs/link.md has the argument).

with Telemetry.Headers;   use Telemetry.Headers;
with Telemetry.Memory;    use Telemetry.Memory;
with Telemetry.Receivers; use Telemetry.Receivers;
with Telemetry.Senders;   use Telemetry.Senders;

package Telemetry.Turns with Pure, SPARK_Mode is

   type Turn is
     (Ready,             --  nothing of ours is on its way
      Sending,           --  a data message
      Awaiting_Status,   --  the answer to our data message
      Awaiting_Data,     --  ground: the answer to a command to downlink
      Idling);           --  ground: in its reset

   --  The answer owed to a data message.
   type Reply is (None, Good, Bad);

   --  A ground that knows of a waiting downlink asks for it twice at most.
   type Turn_Count is range 0 .. 2;

   --  After two data messages the ground idles before the next (D-28).
   type Row_Count is range 0 .. 2;

   --  The lengths are those of the blocks that the board sends and is sent.
   type Control is record
      Role            : Station;
      Transmit_Length : Block_Length;
      Receive_Length  : Block_Length;
      Receiver        : Receivers.Receiver;
      Sender          : Senders.Sender;
      State           : Turn            := Ready;
      Owed            : Reply           := None;
      Line_Taken      : Boolean         := False;  --  by a character of ours
      Silence         : Character_Times := 0;      --  nothing heard or sent
      Downlink_Turns  : Turn_Count      := 0;      --  ground: commands left
      Clear_To_Send   : Boolean         := False;  --  aircraft: may downlink
      In_A_Row        : Row_Count       := 0;      --  ground: sent since idle

      --  Data messages received, for the controller (LNK-10).
      Messages        : Count           := 0;
      Tally           : Statistics;
   end record;

   --  It holds together. An answer is owed only between messages.
   function Is_Sound (Item : Control) return Boolean is
     ((if Item.Owed /= None
       then Item.State = Ready and then Item.Receiver.State = At_Start)
      and then
        (if Has_Message (Item.Receiver) then Item.State =
           (if Item.Role = Ground then Awaiting_Data else Ready))
      and then
        (if Item.Role = Ground
         then Item.Receiver.State /= Out_Of_Step
           and then not Item.Clear_To_Send
         else Item.State not in Awaiting_Data | Idling
           and then Item.Downlink_Turns = 0
           and then Item.In_A_Row = 0))
   with Global => null;

   --  The board has something on the line or is about to: the link is half
   --  duplex, so it hears nothing meanwhile.
   function Is_Talking (Item : Control) return Boolean is
     (Item.Line_Taken or else Item.Owed /= None or else Item.State = Sending)
   with Global => null;

   --  Ready for whatever comes next: a message, a command, a block to send.
   function Is_At_Rest (Item : Control) return Boolean is
     (Item.State = Ready
      and then Item.Owed = None
      and then Item.Receiver.State = At_Start)
   with Global => null;

   --  The board waits for the other one, and not for ever.
   function Is_Waiting (Item : Control) return Boolean is
     (not Is_Talking (Item) and then not Is_At_Rest (Item))
   with Global => null;

   --  A block of ours is on its way: its buffer is busy.
   function Has_Block_Out (Item : Control) return Boolean is
     (Item.State in Sending | Awaiting_Status)
   with Global => null;

   function Patience (Item : Control) return Character_Times is
     (if Item.State = Idling then Idle_Time
      elsif Item.Receiver.State = At_End then Guard_Time
      else Dead_Space)
   with Global => null;

   --  Time. Blocks is the transmit pair.

   --  What becomes of our block in a reset: it is tried again or scrapped.
   function Fate_In_Reset (Item : Control) return Fate is
     (if Has_Block_Out (Item) then Failed else Open)
   with Global => null;

   function After_Break (Item : Control) return Turn is
     (if Item.Role = Ground then Idling else Ready)
   with Global => null;

   --  After the reset (LNK-9) nothing is coming in and no block is on its
   --  way. A ground goes into its idle time first, and from there to Ready.
   function Reset (Item : Control; Blocks : Buffer_Pair) return Control is
     ((Item with delta
         Receiver => (Item.Receiver with delta State => At_Start),
         State    =>
           (if Item.State = Idling then Ready else After_Break (Item)),
         Silence  => 0,
         In_A_Row => 0,
         Tally    => (Item.Tally with delta
           Bad      => Counted (Item.Tally.Bad, Has_Message (Item.Receiver)),
           Scrapped => Counted
             (Item.Tally.Scrapped,
              Is_Scrapped
                (Blocks, Item.Sender.Source, Fate_In_Reset (Item))),
           Resets   => Counted (Item.Tally.Resets, Item.State /= Idling))))
   with Global => null;

   --  How long until the board judges a message or resets itself if nothing
   --  happens; the last value if it never does.
   function Time_Left (Item : Control) return Character_Times is
     (if not Is_Waiting (Item) then Character_Times'Last
      elsif Item.Silence >= Patience (Item) then 0
      else Patience (Item) - Item.Silence)
   with Global => null;

   function Is_Over_After
     (Item : Control; Time : Character_Times) return Boolean is
     (Is_Waiting (Item) and then Time >= Time_Left (Item))
   with Global => null;

   --  A message that went no further than its end is judged.
   function Is_Judged_After
     (Item : Control; Time : Character_Times) return Boolean is
     (Is_Over_After (Item, Time) and then Item.Receiver.State = At_End)
   with Global => null;

   --  Any other board that has waited for too long resets itself.
   function Is_Reset_After
     (Item : Control; Time : Character_Times) return Boolean is
     (Is_Over_After (Item, Time) and then Item.Receiver.State /= At_End)
   with Global => null;

   function Elapsed
     (Item : Control; Time : Character_Times; Blocks : Buffer_Pair)
      return Control is
     (if Is_Reset_After (Item, Time) then Reset (Item, Blocks)
      elsif Is_Waiting (Item)
      then (Item with delta Silence => Item.Silence + Time)
      else Item)
   with Global => null, Pre => not Is_Judged_After (Item, Time);

   --  What is heard

   --  In its reset a board hears only that the line is not silent.
   function Is_Listening (Item : Control) return Boolean is
     (not Is_Talking (Item) and then Item.State /= Idling)
   with Global => null;

   function Wants_Data (Item : Control) return Boolean is
     (Item.Role = Aircraft or else Item.State = Awaiting_Data)
   with Global => null;

   --  What becomes of our block when this comes. It did not arrive if the
   --  answer says so, if the ground speaks of other things, or if what
   --  comes makes no sense to the ground.
   function Fate_After (Item : Control; What : Event) return Fate is
     (if Item.State /= Awaiting_Status
      then Open
      else
        (case What.Kind is
            when Receivers.Status      =>
              (if What.Good then Confirmed else Failed),
            when Command | Block_Begun =>
              (if Item.Role = Aircraft then Failed else Open),
            when Lost_Step             =>
              (if Item.Role = Ground then Failed else Open),
            when others                => Open))
   with Global => null;

   --  The receiver has taken a character that brought this. What makes no
   --  sense to the ground sends it into its idle time at once; the aircraft
   --  waits for silence as it is.
   function Informed
     (Item : Control; What : Event; Blocks : Buffer_Pair) return Control
   is
     (if What.Kind = Lost_Step and then Item.Role = Ground
      then Reset (Item, Blocks)
      else
        (Item with delta
           State          =>
             (if Fate_After (Item, What) /= Open then Ready else Item.State),
           Silence        => 0,
           Downlink_Turns =>
             (if What.Kind = Receivers.Status
                and then Item.Role = Ground
                and then Item.State = Awaiting_Status
              then (if What.Wants_Downlink then Turn_Count'Last else 0)
              else Item.Downlink_Turns),

           --  The ground needs no permission and disregards it (LNK-3).
           Clear_To_Send  => Item.Clear_To_Send
             or else (What.Kind = Command and then Item.Role = Aircraft),
           Tally          => (Item.Tally with delta
             Scrapped => Counted
               (Item.Tally.Scrapped,
                Is_Scrapped
                  (Blocks, Item.Sender.Source, Fate_After (Item, What))))))
   with Global => null;

   --  The message that has come to its end went no further: it is judged,
   --  and an answer is owed. Received is the receive pair after it.
   function Judged (Item : Control; Received : Buffer_Pair) return Control is
     ((Item with delta
         Receiver       => (Item.Receiver with delta State => At_Start),
         State          => Ready,
         Owed           => (if Item.Receiver.Damaged then Bad else Good),
         Silence        => 0,
         Downlink_Turns =>
           (if Item.Receiver.Damaged then Item.Downlink_Turns else 0),
         Messages       => Counted (Item.Messages, not Item.Receiver.Damaged),
         Tally          => (Item.Tally with delta
           Received  => Counted
             (Item.Tally.Received, not Item.Receiver.Damaged),
           Bad       => Counted (Item.Tally.Bad, Item.Receiver.Damaged),
           Not_Taken => Counted
             (Item.Tally.Not_Taken,
              not Item.Receiver.Damaged and then Both_Full (Received)))))
   with Global => null,
     Post => (if Is_Sound (Item) then Is_Sound (Judged'Result));

   --  What is said

   --  The block on its way fits what was sent of it.
   function Fits (Item : Control; Blocks : Buffer_Pair) return Boolean is
     (if Item.State = Sending
      then Fits
        (Item.Sender, Blocks.Slots (Item.Sender.Source).Data,
         Item.Transmit_Length))
   with Global => null;

   --  The board may begin to send a block.
   function May_Begin_Block
     (Item : Control; Blocks : Buffer_Pair) return Boolean is
     (Is_At_Rest (Item)
      and then
        (if Item.Role = Ground
         then Item.In_A_Row < Row_Count'Last
         else Item.Clear_To_Send)
      and then Any_Full (Blocks))
   with Global => null;

   --  A block that begins is the newest, and is alone (LNK-7). A permission
   --  that finds no block lapses. A ground that has said all, or enough,
   --  idles (D-28).
   function Prepared (Item : Control; Blocks : Buffer_Pair) return Control is
     (if May_Begin_Block (Item, Blocks)
      then
        (Item with delta
           Sender        => (Source => Newest_Full (Blocks), others => <>),
           State         => Sending,
           Clear_To_Send => False,
           In_A_Row      => Item.In_A_Row + Boolean'Pos (Item.Role = Ground),
           Tally         => (Item.Tally with delta
             Sent    => Incremented (Item.Tally.Sent),
             Cleared => Counted (Item.Tally.Cleared, Both_Full (Blocks))))
      elsif Is_At_Rest (Item)
        and then Item.In_A_Row > 0 and then Item.Downlink_Turns = 0
      then (Item with delta State => Idling, Silence => 0)
      else
        (Item with delta
           Clear_To_Send =>
             Item.Clear_To_Send and then not Is_At_Rest (Item)))
   with Global => null,
     Post => (if Is_Sound (Item) then Is_Sound (Prepared'Result));

   --  The ground, without a block of its own, lets the aircraft send one
   --  (LNK-8).
   function May_Command (Item : Control) return Boolean is
     (Is_At_Rest (Item) and then Item.Downlink_Turns > 0)
   with Global => null;

   --  What a prepared board sends, an owed answer first; 0 if nothing.
   function Output (Item : Control; Blocks : Buffer_Pair) return Byte is
     (if Item.Owed /= None
      then Encode
        ((Kind           => Headers.Status,
          Good           => Item.Owed = Good,
          Wants_Downlink =>
            Item.Role = Aircraft and then Any_Full (Blocks)))
      elsif Item.State = Sending
      then Next_Byte
        (Item.Sender, Blocks.Slots (Item.Sender.Source).Data,
         Item.Transmit_Length)
      elsif May_Command (Item) then Encode ((Kind => Command_To_Downlink))
      else 0)
   with Global => null, Pre => Fits (Item, Blocks);

   function Spoken (Item : Control; Blocks : Buffer_Pair) return Control is
     ((Item with delta
         Sender         =>
           (if Item.State = Sending
            then Advanced
              (Item.Sender, Blocks.Slots (Item.Sender.Source).Data,
               Item.Transmit_Length)
            else Item.Sender),
         State          =>
           (if Item.State = Sending
              and then Item.Sender.Sent + 1 =
                         Message_Length (Item.Transmit_Length)
            then Awaiting_Status
            elsif May_Command (Item) then Awaiting_Data
            else Item.State),
         Owed           => None,
         Line_Taken     =>
           Item.Owed /= None or else Item.State = Sending
           or else May_Command (Item),

         --  Dead space begins when our last character has left.
         Silence        => (if Item.Line_Taken then 0 else Item.Silence),
         Downlink_Turns =>
           Item.Downlink_Turns - (if May_Command (Item) then 1 else 0)))
   with Global => null,
     Pre  => Fits (Item, Blocks),
     Post =>
       Fits (Spoken'Result, Blocks)
       and then (if Is_Sound (Item) then Is_Sound (Spoken'Result));

end Telemetry.Turns;
