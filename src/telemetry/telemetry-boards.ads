--  SPDX-License-Identifier: Apache-2.0

--  A telemetry board: its control and its memory (report, appendix A; LNK-1,
--  LNK-4, LNK-5, LNK-10). Telemetry.Turns has the protocol.
--
--  The board's interrupt handler calls Accept_Character, its main program
--  Next_Character whenever the transmitter is empty, and its timer Elapse.
--  The controller uses Take and Put. Time is counted in character times.

with Telemetry.Headers;   use Telemetry.Headers;
with Telemetry.Memory;    use Telemetry.Memory;
with Telemetry.Receivers; use Telemetry.Receivers;
with Telemetry.Turns;     use Telemetry.Turns;
with Telemetry.Turns.Starts;

package Telemetry.Boards with Pure, SPARK_Mode is

   type Board is private;

   function Control_Of (Item : Board) return Control
   with Global => null;

   function Receive_Pair (Item : Board) return Buffer_Pair
   with Global => null;

   function Transmit_Pair (Item : Board) return Buffer_Pair
   with Global => null;

   --  For those who know of boards only.
   subtype Statistics is Telemetry.Statistics;

   function Tally (Item : Board) return Statistics is (Control_Of (Item).Tally)
   with Global => null;

   --  The board may have a character to send: nothing but its own turn
   --  keeps it from speaking, or the short wait at the end of a message.
   function May_Speak (Item : Board) return Boolean is
     (not Is_Waiting (Control_Of (Item))
      or else Control_Of (Item).Receiver.State = At_End)
   with Global => null;

   function Time_Left (Item : Board) return Character_Times is
     (Time_Left (Control_Of (Item)))
   with Global => null;

   --  A transmit buffer is busy while its block is on its way, and only
   --  then. Elsewhere a full one has been transmitted once at the most.
   function Holds (Blocks : Buffer_Pair; Item : Control) return Boolean
   is
     (for all Which in Slot =>
        (if Has_Block_Out (Item) and then Which = Item.Sender.Source
         then Blocks.Slots (Which).Busy
           and then Blocks.Slots (Which).Full
           and then Blocks.Slots (Which).Attempts > 0
         else not Blocks.Slots (Which).Busy
           and then Blocks.Slots (Which).Attempts < 2))
   with Global => null;

   --  The board holds together. True of every board that the operations
   --  below have made, whatever came in.
   function Is_Sound (Item : Board) return Boolean is
     (Is_Sound (Control_Of (Item))
      and then Fits
        (Control_Of (Item).Receiver, Receive_Pair (Item),
         Control_Of (Item).Receive_Length)
      and then Holds (Transmit_Pair (Item), Control_Of (Item))
      and then Fits (Control_Of (Item), Transmit_Pair (Item)))
   with Global => null;

   --  A new board. The lengths are those of the blocks that it sends and is
   --  sent.
   function New_Board
     (Role            : Station;
      Transmit_Length : Block_Length;
      Receive_Length  : Block_Length) return Board
   with
     Global => null,
     Post   => Is_Sound (New_Board'Result);

   --  What a character brings to a board that listens.
   function Heard
     (Item         : Board;
      Data         : Byte;
      Parity_Error : Boolean) return Event
   is
     (Outcome_Of
        (Control_Of (Item).Receiver, Control_Of (Item).Receive_Length,
         Wants_Data (Control_Of (Item)), Data, Parity_Error))
   with
     Ghost,
     Global => null;

   --  A character has arrived. While the board talks it hears nothing; in
   --  its reset, nothing but that the line is not silent.
   procedure Accept_Character
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     Inline,
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then
         (if Is_Listening (Control_Of (Item'Old))
          then
            Receive_Pair (Item) =
              (if Is_Stored
                 (Control_Of (Item'Old).Receiver,
                  Heard (Item'Old, Data, Parity_Error).Kind)
               then Pair_With_Byte
                 (Control_Of (Item'Old).Receiver, Receive_Pair (Item'Old),
                  Data)
               else Pair_After
                 (Receive_Pair (Item'Old),
                  Heard (Item'Old, Data, Parity_Error).Kind))
            and then Transmit_Pair (Item) = Settled
              (Transmit_Pair (Item'Old),
               Control_Of (Item'Old).Sender.Source,
               Fate_After
                 (Control_Of (Item'Old),
                  Heard (Item'Old, Data, Parity_Error)))
            and then Control_Of (Item) = Informed
              ((Control_Of (Item'Old) with delta
                  Receiver => Receiver_After
                    (Control_Of (Item'Old).Receiver, Receive_Pair (Item'Old),
                     Heard (Item'Old, Data, Parity_Error).Kind,
                     Data, Parity_Error)),
               Heard (Item'Old, Data, Parity_Error),
               Transmit_Pair (Item'Old))
          else
            Receive_Pair (Item) = Receive_Pair (Item'Old)
            and then Transmit_Pair (Item) = Transmit_Pair (Item'Old)
            and then Control_Of (Item) =
              (if Is_Talking (Control_Of (Item'Old))
               then Control_Of (Item'Old)
               else (Control_Of (Item'Old) with delta Silence => 0)));

   --  The transmitter is empty: Data is the next character if Send is True,
   --  else there is none now.
   procedure Next_Character
     (Item : in out Board;
      Send : out Boolean;
      Data : out Byte)
   with
     Inline,
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then Receive_Pair (Item) = Receive_Pair (Item'Old)
       and then Transmit_Pair (Item) =
         (if May_Begin_Block (Control_Of (Item'Old), Transmit_Pair (Item'Old))
          then Begun
            (Transmit_Pair (Item'Old),
             Newest_Full (Transmit_Pair (Item'Old)))
          else Transmit_Pair (Item'Old))
       and then Fits
         (Prepared (Control_Of (Item'Old), Transmit_Pair (Item'Old)),
          Transmit_Pair (Item))
       and then Control_Of (Item) = Spoken
         (Prepared (Control_Of (Item'Old), Transmit_Pair (Item'Old)),
          Transmit_Pair (Item))
       and then Data = Output
         (Prepared (Control_Of (Item'Old), Transmit_Pair (Item'Old)),
          Transmit_Pair (Item))
       and then Send = Control_Of (Item).Line_Taken;

   --  Time has passed. A board that has waited for too long resets itself;
   --  one that waits at the end of a message judges it.
   procedure Elapse (Item : in out Board; Time : Character_Times)
   with
     Inline,
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then Control_Of (Item) =
         (if Is_Judged_After (Control_Of (Item'Old), Time)
          then Judged (Control_Of (Item'Old), Receive_Pair (Item))
          else Elapsed
            (Control_Of (Item'Old), Time, Transmit_Pair (Item'Old)))
       and then
         (if Is_Judged_After (Control_Of (Item'Old), Time)
          then
            Receive_Pair (Item) = Pair_Judged
              (Control_Of (Item'Old).Receiver, Receive_Pair (Item'Old))
            and then Transmit_Pair (Item) = Transmit_Pair (Item'Old)
          elsif Is_Reset_After (Control_Of (Item'Old), Time)
          then
            Receive_Pair (Item) = Released (Receive_Pair (Item'Old))
            and then Transmit_Pair (Item) = Settled
              (Transmit_Pair (Item'Old),
               Control_Of (Item'Old).Sender.Source,
               Fate_In_Reset (Control_Of (Item'Old)))
          else
            Receive_Pair (Item) = Receive_Pair (Item'Old)
            and then Transmit_Pair (Item) = Transmit_Pair (Item'Old));

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
       and then Data = Contents (Receive_Pair (Item'Old))
       and then Fresh = Any_Full (Receive_Pair (Item'Old))
       and then Ever_Received = (Control_Of (Item'Old).Messages > 0)
       and then Receive_Pair (Item) = Taken (Receive_Pair (Item'Old))
       and then Transmit_Pair (Item) = Transmit_Pair (Item'Old)
       and then Control_Of (Item) = Control_Of (Item'Old);

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
       and then Overwrote = Both_Full (Transmit_Pair (Item'Old))
       and then Transmit_Pair (Item) =
         Filled (Transmit_Pair (Item'Old), Data)
       and then Receive_Pair (Item) = Receive_Pair (Item'Old)
       and then Control_Of (Item) = Control_Of (Item'Old);

   --  The controller's part of the start: transmit buffers empty, flags
   --  empty, semaphores available (INI-4).
   procedure Clear_Transmit_Half (Item : in out Board)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then Transmit_Pair (Item) = Empty_Pair
       and then Receive_Pair (Item) = Receive_Pair (Item'Old)
       and then Control_Of (Item) =
         Turns.Starts.Cleared (Control_Of (Item'Old));

   --  The board's own start, but for its transmit buffers, which are the
   --  controller's (INI-4).
   procedure Start (Item : in out Board)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then Receive_Pair (Item) = Empty_Pair
       and then Transmit_Pair (Item) = Settled
         (Transmit_Pair (Item'Old),
          Control_Of (Item'Old).Sender.Source,
          Fate_In_Reset (Control_Of (Item'Old)))
       and then Control_Of (Item) =
         Turns.Starts.Started
           (Control_Of (Item'Old), Transmit_Pair (Item'Old));

private

   type Board is record
      Control       : Turns.Control;
      Receive_Pair  : Buffer_Pair;
      Transmit_Pair : Buffer_Pair;
   end record;

   function Control_Of (Item : Board) return Control is (Item.Control);

   function Receive_Pair (Item : Board) return Buffer_Pair is
     (Item.Receive_Pair);

   function Transmit_Pair (Item : Board) return Buffer_Pair is
     (Item.Transmit_Pair);

   function New_Board
     (Role            : Station;
      Transmit_Length : Block_Length;
      Receive_Length  : Block_Length) return Board
   is
     ((Control       =>
         (Role            => Role,
          Transmit_Length => Transmit_Length,
          Receive_Length  => Receive_Length,
          others          => <>),
       Receive_Pair  => Empty_Pair,
       Transmit_Pair => Empty_Pair));

end Telemetry.Boards;
