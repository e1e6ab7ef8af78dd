--  SPDX-License-Identifier: Apache-2.0

--  The protocol: which board may talk on the link, and what it sends (report,
--  appendix A; LNK-2, LNK-3, LNK-6 to LNK-10, D-18, D-20, D-22).
--
--  Control is the whole state of a board except for the blocks in its buffers.
--  The protocol is a set of functions. Telemetry.Turns.Changes has the same as
--  procedures, for Telemetry.Boards.
--
--  A waiting board that hears nothing for the dead space resets itself. The
--  ground then idles until it has heard nothing for a longer time: by then the
--  aircraft has reset itself too (LNK-9, D-7; docs/link.md has the argument).
--  The round trip of the line extends both waits (LNK-11, D-38).

with Telemetry.Headers;   use Telemetry.Headers;
with Telemetry.Memory;    use Telemetry.Memory;
with Telemetry.Receivers; use Telemetry.Receivers;
with Telemetry.Senders;   use Telemetry.Senders;

package Telemetry.Turns with Pure, SPARK_Mode is

   type Turn is
     (Ready,             --  no message of this board is on its way
      Sending,           --  a data message
      Awaiting_Status,   --  the answer to this board's data message
      Awaiting_Data,     --  ground: the answer to a command to downlink
      Idling);           --  ground: in its reset

   --  The answer owed to a data message.
   type Reply is (None, Good, Bad);

   --  A ground that knows of a waiting downlink requests it at most twice.
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
      Round_Trip      : Round_Trip_Time := 0;      --  of the line

      --  Data messages received, for the controller (LNK-10).
      Messages        : Count           := 0;
      Tally           : Statistics;
   end record;

   --  The control is consistent. An answer is owed only between messages.
   function Is_Sound (This : Control) return Boolean is
     ((if This.Owed /= None
       then This.State = Ready and then This.Receiver.State = At_Start)
      and then
        (if Has_Message (This.Receiver) then This.State =
           (if This.Role = Ground then Awaiting_Data else Ready))
      and then
        (if This.Role = Ground
         then This.Receiver.State /= Out_Of_Step
           and then not This.Clear_To_Send
         else This.State not in Awaiting_Data | Idling
           and then This.Downlink_Turns = 0
           and then This.In_A_Row = 0))
   with Global => null;

   --  The board has something on the line or will have it next. The link is
   --  half duplex, so the board hears nothing meanwhile.
   function Is_Talking (This : Control) return Boolean is
     (This.Line_Taken or else This.Owed /= None or else This.State = Sending)
   with Global => null;

   --  Ready for a message, a command, or a block to send.
   function Is_At_Rest (This : Control) return Boolean is
     (This.State = Ready
      and then This.Owed = None
      and then This.Receiver.State = At_Start)
   with Global => null;

   --  The board waits for the other one, for a limited time.
   function Is_Waiting (This : Control) return Boolean is
     (not Is_Talking (This) and then not Is_At_Rest (This))
   with Global => null;

   --  A block of this board is on its way; its buffer is busy.
   function Has_Block_Out (This : Control) return Boolean is
     (This.State in Sending | Awaiting_Status)
   with Global => null;

   function Timeout (This : Control) return Character_Times is
     (if This.State = Idling then Idle_Time_On (This.Round_Trip)
      elsif This.Receiver.State = At_End then Guard_Time
      else Dead_Space_On (This.Round_Trip))
   with Global => null;

   --  Passing time. Blocks is the transmit pair.

   --  The outcome of this board's block in a reset: it is tried again or
   --  scrapped.
   function Delivery_In_Reset (This : Control) return Delivery is
     (if Has_Block_Out (This) then Failed else Open)
   with Global => null;

   function After_Break (This : Control) return Turn is
     (if This.Role = Ground then Idling else Ready)
   with Global => null;

   --  The state after a reset (LNK-9): no message is arriving and no block is
   --  on its way. The ground idles first, and then becomes Ready.
   function Reset (This : Control; Blocks : Buffer_Pair) return Control is
     ((This with delta
         Receiver => (This.Receiver with delta State => At_Start),
         State    =>
           (if This.State = Idling then Ready else After_Break (This)),
         Silence  => 0,
         In_A_Row => 0,
         Tally    => (This.Tally with delta
           Bad      => Counted (This.Tally.Bad, Has_Message (This.Receiver)),
           Scrapped => Counted
             (This.Tally.Scrapped,
              Is_Scrapped
                (Blocks, This.Sender.Source, Delivery_In_Reset (This))),
           Resets   => Counted (This.Tally.Resets, This.State /= Idling))))
   with Global => null;

   --  The time until the board judges a message or resets itself if nothing
   --  happens; the last value if it does neither.
   function Time_Left (This : Control) return Character_Times is
     (if not Is_Waiting (This) then Character_Times'Last
      elsif This.Silence >= Timeout (This) then 0
      else Timeout (This) - This.Silence)
   with Global => null;

   function Is_Over_After
     (This : Control; Time : Character_Times) return Boolean is
     (Is_Waiting (This) and then Time >= Time_Left (This))
   with Global => null;

   --  A message is judged when no character followed its end.
   function Is_Judged_After
     (This : Control; Time : Character_Times) return Boolean is
     (Is_Over_After (This, Time) and then This.Receiver.State = At_End)
   with Global => null;

   --  Any other board that has waited too long resets itself.
   function Is_Reset_After
     (This : Control; Time : Character_Times) return Boolean is
     (Is_Over_After (This, Time) and then This.Receiver.State /= At_End)
   with Global => null;

   function Elapsed
     (This : Control; Time : Character_Times; Blocks : Buffer_Pair)
      return Control is
     (if Is_Reset_After (This, Time) then Reset (This, Blocks)
      elsif Is_Waiting (This)
      then (This with delta Silence => This.Silence + Time)
      else This)
   with Global => null, Pre => not Is_Judged_After (This, Time);

   --  Received characters

   --  A board in its reset notes only that the line is not silent.
   function Is_Listening (This : Control) return Boolean is
     (not Is_Talking (This) and then This.State /= Idling)
   with Global => null;

   function Wants_Data (This : Control) return Boolean is
     (This.Role = Aircraft or else This.State = Awaiting_Data)
   with Global => null;

   --  The outcome of this board's block after an event. The block has failed
   --  if the answer says so, if the ground sends another message, or if the
   --  ground receives an invalid character.
   function Delivery_After (This : Control; Trigger : Event) return Delivery is
     (if This.State /= Awaiting_Status
      then Open
      else
        (case Trigger.Kind is
            when Receivers.Status      =>
              (if Trigger.Good then Confirmed else Failed),
            when Command | Block_Begun =>
              (if This.Role = Aircraft then Failed else Open),
            when Lost_Step             =>
              (if This.Role = Ground then Failed else Open),
            when others                => Open))
   with Global => null;

   --  The state after the receiver's event. An invalid character sends the
   --  ground into its idle time at once. The aircraft continues to wait for
   --  silence.
   function Informed
     (This : Control; Trigger : Event; Blocks : Buffer_Pair) return Control
   is
     (if Trigger.Kind = Lost_Step and then This.Role = Ground
      then Reset (This, Blocks)
      else
        (This with delta
           State          =>
             (if Delivery_After (This, Trigger) /= Open then Ready
              else This.State),
           Silence        => 0,
           Downlink_Turns =>
             (if Trigger.Kind = Receivers.Status
                and then This.Role = Ground
                and then This.State = Awaiting_Status
              then (if Trigger.Wants_Downlink then Turn_Count'Last else 0)
              else This.Downlink_Turns),

           --  The ground needs no permission and ignores it (LNK-3).
           Clear_To_Send  => This.Clear_To_Send
             or else (Trigger.Kind = Command and then This.Role = Aircraft),
           Tally          => (This.Tally with delta
             Scrapped => Counted
               (This.Tally.Scrapped,
                Is_Scrapped
                  (Blocks, This.Sender.Source,
                   Delivery_After (This, Trigger))))))
   with Global => null;

   --  No character followed the end of the message: it is judged, and an
   --  answer is owed. Received is the receive pair afterwards.
   function Judged (This : Control; Received : Buffer_Pair) return Control is
     ((This with delta
         Receiver       => (This.Receiver with delta State => At_Start),
         State          => Ready,
         Owed           => (if This.Receiver.Damaged then Bad else Good),
         Silence        => 0,
         Downlink_Turns =>
           (if This.Receiver.Damaged then This.Downlink_Turns else 0),
         Messages       => Counted (This.Messages, not This.Receiver.Damaged),
         Tally          => (This.Tally with delta
           Received  => Counted
             (This.Tally.Received, not This.Receiver.Damaged),
           Bad       => Counted (This.Tally.Bad, This.Receiver.Damaged),
           Not_Taken => Counted
             (This.Tally.Not_Taken,
              not This.Receiver.Damaged and then Both_Full (Received)))))
   with Global => null,
     Post => (if Is_Sound (This) then Is_Sound (Judged'Result));

   --  Sent characters

   --  The block on its way agrees with the characters already sent.
   function Fits (This : Control; Blocks : Buffer_Pair) return Boolean is
     (if This.State = Sending
      then Fits
        (This.Sender, Blocks.Slots (This.Sender.Source).Data,
         This.Transmit_Length))
   with Global => null;

   --  The board may begin to send a block.
   function May_Begin_Block
     (This : Control; Blocks : Buffer_Pair) return Boolean is
     (Is_At_Rest (This)
      and then
        (if This.Role = Ground
         then This.In_A_Row < Row_Count'Last
         else This.Clear_To_Send)
      and then Any_Full (Blocks))
   with Global => null;

   --  The board begins with the newest block, and clears the other (LNK-7). A
   --  permission without a block lapses. A ground idles when it has nothing
   --  more to send, or has sent two messages (D-28).
   function Prepared (This : Control; Blocks : Buffer_Pair) return Control is
     (if May_Begin_Block (This, Blocks)
      then
        (This with delta
           Sender        => (Source => Newest_Full (Blocks), others => <>),
           State         => Sending,
           Clear_To_Send => False,
           In_A_Row      => This.In_A_Row + Boolean'Pos (This.Role = Ground),
           Tally         => (This.Tally with delta
             Sent    => Incremented (This.Tally.Sent),
             Cleared => Counted (This.Tally.Cleared, Both_Full (Blocks))))
      elsif Is_At_Rest (This)
        and then This.In_A_Row > 0 and then This.Downlink_Turns = 0
      then (This with delta State => Idling, Silence => 0)
      else
        (This with delta
           Clear_To_Send =>
             This.Clear_To_Send and then not Is_At_Rest (This)))
   with Global => null,
     Post => (if Is_Sound (This) then Is_Sound (Prepared'Result));

   --  The ground has no block of its own to send and lets the aircraft send
   --  one (LNK-8).
   function May_Command (This : Control) return Boolean is
     (Is_At_Rest (This) and then This.Downlink_Turns > 0)
   with Global => null;

   --  The next character of a prepared board, an owed answer first; 0 if none.
   function Output (This : Control; Blocks : Buffer_Pair) return Byte is
     (if This.Owed /= None
      then Encode
        ((Kind           => Headers.Status,
          Good           => This.Owed = Good,
          Wants_Downlink =>
            This.Role = Aircraft and then Any_Full (Blocks)))
      elsif This.State = Sending
      then Next_Byte
        (This.Sender, Blocks.Slots (This.Sender.Source).Data,
         This.Transmit_Length)
      elsif May_Command (This) then Encode ((Kind => Command_To_Downlink))
      else 0)
   with Global => null, Pre => Fits (This, Blocks);

   function Spoken (This : Control; Blocks : Buffer_Pair) return Control is
     ((This with delta
         Sender         =>
           (if This.State = Sending
            then Advanced
              (This.Sender, Blocks.Slots (This.Sender.Source).Data,
               This.Transmit_Length)
            else This.Sender),
         State          =>
           (if This.State = Sending
              and then This.Sender.Sent + 1 =
                         Message_Length (This.Transmit_Length)
            then Awaiting_Status
            elsif May_Command (This) then Awaiting_Data
            else This.State),
         Owed           => None,
         Line_Taken     =>
           This.Owed /= None or else This.State = Sending
           or else May_Command (This),

         --  Dead space begins when this board's last character has left.
         Silence        => (if This.Line_Taken then 0 else This.Silence),
         Downlink_Turns =>
           This.Downlink_Turns - (if May_Command (This) then 1 else 0)))
   with Global => null,
     Pre  => Fits (This, Blocks),
     Post =>
       Fits (Spoken'Result, Blocks)
       and then (if Is_Sound (This) then Is_Sound (Spoken'Result));

end Telemetry.Turns;
