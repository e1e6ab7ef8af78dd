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

   function Control_Of (This : Board) return Control
   with Global => null;

   function Receive_Pair (This : Board) return Buffer_Pair
   with Global => null;

   function Transmit_Pair (This : Board) return Buffer_Pair
   with Global => null;

   --  The name for units that use only boards.
   subtype Statistics is Telemetry.Statistics;

   function Tally (This : Board) return Statistics
   with
     Global => null,
     Post   => Tally'Result = Control_Of (This).Tally;

   --  The board may have a character to send: it does not wait, or only for
   --  the short time at the end of a message.
   function May_Speak (This : Board) return Boolean
   with Global => null;

   function Time_Left (This : Board) return Character_Times
   with Global => null;

   --  A transmit buffer is busy exactly while its block is on its way. Any
   --  other full buffer was transmitted at most once.
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

   --  The board is consistent. All boards are, whatever operations below made
   --  them and whatever characters arrived.
   function Is_Sound (This : Board) return Boolean is
     (Is_Sound (Control_Of (This))
      and then Fits
        (Control_Of (This).Receiver, Receive_Pair (This),
         Control_Of (This).Receive_Length)
      and then Holds (Transmit_Pair (This), Control_Of (This))
      and then Fits (Control_Of (This), Transmit_Pair (This)))
   with Global => null;

   --  A new board. The lengths are those of the blocks that it sends and
   --  receives.
   function New_Board
     (Role            : Station;
      Transmit_Length : Block_Length;
      Receive_Length  : Block_Length) return Board
   with
     Global => null,
     Post   => Is_Sound (New_Board'Result);

   --  Sets the round trip of the line (LNK-11). Call it for both boards before
   --  they start. A new board has a round trip of 0, that of a wire.
   procedure Set_Round_Trip (This : in out Board; Time : Round_Trip_Time)
   with
     Global => null,
     Pre    => Is_Sound (This),
     Post   =>
       Is_Sound (This)
       and then Control_Of (This) =
         (Control_Of (This'Old) with delta Round_Trip => Time)
       and then Receive_Pair (This) = Receive_Pair (This'Old)
       and then Transmit_Pair (This) = Transmit_Pair (This'Old);

   --  The event that a character causes for a board that listens.
   function Heard
     (This         : Board;
      Data         : Byte;
      Parity_Error : Boolean) return Event
   is
     (Outcome_Of
        (Control_Of (This).Receiver, Control_Of (This).Receive_Length,
         Wants_Data (Control_Of (This)), Data, Parity_Error))
   with
     Ghost,
     Global => null;

   --  A character has arrived. A talking board ignores it. A board in its
   --  reset only notes that the line is not silent.
   procedure Accept_Character
     (This         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     Inline,
     Global => null,
     Pre    => Is_Sound (This),
     Post   =>
       Is_Sound (This)
       and then
         (if Is_Listening (Control_Of (This'Old))
          then
            Receive_Pair (This) =
              (if Is_Stored
                 (Control_Of (This'Old).Receiver,
                  Heard (This'Old, Data, Parity_Error).Kind)
               then Pair_With_Byte
                 (Control_Of (This'Old).Receiver, Receive_Pair (This'Old),
                  Data)
               else Pair_After
                 (Receive_Pair (This'Old),
                  Heard (This'Old, Data, Parity_Error).Kind))
            and then Transmit_Pair (This) = Settled
              (Transmit_Pair (This'Old),
               Control_Of (This'Old).Sender.Source,
               Delivery_After
                 (Control_Of (This'Old),
                  Heard (This'Old, Data, Parity_Error)))
            and then Control_Of (This) = Informed
              ((Control_Of (This'Old) with delta
                  Receiver => Receiver_After
                    (Control_Of (This'Old).Receiver, Receive_Pair (This'Old),
                     Heard (This'Old, Data, Parity_Error).Kind,
                     Data, Parity_Error)),
               Heard (This'Old, Data, Parity_Error),
               Transmit_Pair (This'Old))
          else
            Receive_Pair (This) = Receive_Pair (This'Old)
            and then Transmit_Pair (This) = Transmit_Pair (This'Old)
            and then Control_Of (This) =
              (if Is_Talking (Control_Of (This'Old))
               then Control_Of (This'Old)
               else (Control_Of (This'Old) with delta Silence => 0)));

   --  The transmitter is empty. Data is the next character if Send is True;
   --  otherwise the board has none now.
   procedure Next_Character
     (This : in out Board;
      Send : out Boolean;
      Data : out Byte)
   with
     Inline,
     Global => null,
     Pre    => Is_Sound (This),
     Post   =>
       Is_Sound (This)
       and then Receive_Pair (This) = Receive_Pair (This'Old)
       and then Transmit_Pair (This) =
         (if May_Begin_Block (Control_Of (This'Old), Transmit_Pair (This'Old))
          then Begun
            (Transmit_Pair (This'Old),
             Newest_Full (Transmit_Pair (This'Old)))
          else Transmit_Pair (This'Old))
       and then Fits
         (Prepared (Control_Of (This'Old), Transmit_Pair (This'Old)),
          Transmit_Pair (This))
       and then Control_Of (This) = Spoken
         (Prepared (Control_Of (This'Old), Transmit_Pair (This'Old)),
          Transmit_Pair (This))
       and then Data = Output
         (Prepared (Control_Of (This'Old), Transmit_Pair (This'Old)),
          Transmit_Pair (This))
       and then Send = Control_Of (This).Line_Taken;

   --  Time has passed. A board that has waited too long resets itself. A board
   --  that waits at the end of a message judges the message.
   procedure Elapse (This : in out Board; Time : Character_Times)
   with
     Inline,
     Global => null,
     Pre    => Is_Sound (This),
     Post   =>
       Is_Sound (This)
       and then Control_Of (This) =
         (if Is_Judged_After (Control_Of (This'Old), Time)
          then Judged (Control_Of (This'Old), Receive_Pair (This))
          else Elapsed
            (Control_Of (This'Old), Time, Transmit_Pair (This'Old)))
       and then
         (if Is_Judged_After (Control_Of (This'Old), Time)
          then
            Receive_Pair (This) = Pair_Judged
              (Control_Of (This'Old).Receiver, Receive_Pair (This'Old))
            and then Transmit_Pair (This) = Transmit_Pair (This'Old)
          elsif Is_Reset_After (Control_Of (This'Old), Time)
          then
            Receive_Pair (This) = Released (Receive_Pair (This'Old))
            and then Transmit_Pair (This) = Settled
              (Transmit_Pair (This'Old),
               Control_Of (This'Old).Sender.Source,
               Delivery_In_Reset (Control_Of (This'Old)))
          else
            Receive_Pair (This) = Receive_Pair (This'Old)
            and then Transmit_Pair (This) = Transmit_Pair (This'Old));

   --  The controller takes the newest block received, if any. Ever_Received
   --  says whether a block was received since the board started.
   procedure Take
     (This          : in out Board;
      Data          : out Block_Data;
      Fresh         : out Boolean;
      Ever_Received : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (This),
     Post   =>
       Is_Sound (This)
       and then Data = Contents (Receive_Pair (This'Old))
       and then Fresh = Any_Full (Receive_Pair (This'Old))
       and then Ever_Received = (Control_Of (This'Old).Messages > 0)
       and then Receive_Pair (This) = Taken (Receive_Pair (This'Old))
       and then Transmit_Pair (This) = Transmit_Pair (This'Old)
       and then Control_Of (This) = Control_Of (This'Old);

   --  The controller gives a block to transmit. Overwrote is True if it
   --  replaced one that still waited.
   procedure Put
     (This      : in out Board;
      Data      : Block_Data;
      Overwrote : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (This),
     Post   =>
       Is_Sound (This)
       and then Overwrote = Both_Full (Transmit_Pair (This'Old))
       and then Transmit_Pair (This) =
         Filled (Transmit_Pair (This'Old), Data)
       and then Receive_Pair (This) = Receive_Pair (This'Old)
       and then Control_Of (This) = Control_Of (This'Old);

   --  The controller's part of the start: empties the transmit buffers and
   --  their flags, and frees their semaphores (INI-4).
   procedure Clear_Transmit_Half (This : in out Board)
   with
     Global => null,
     Pre    => Is_Sound (This),
     Post   =>
       Is_Sound (This)
       and then Transmit_Pair (This) = Empty_Pair
       and then Receive_Pair (This) = Receive_Pair (This'Old)
       and then Control_Of (This) =
         Turns.Starts.Cleared (Control_Of (This'Old));

   --  The board's own start. The transmit buffers are the controller's and
   --  stay (INI-4).
   procedure Start (This : in out Board)
   with
     Global => null,
     Pre    => Is_Sound (This),
     Post   =>
       Is_Sound (This)
       and then Receive_Pair (This) = Empty_Pair
       and then Transmit_Pair (This) = Settled
         (Transmit_Pair (This'Old),
          Control_Of (This'Old).Sender.Source,
          Delivery_In_Reset (Control_Of (This'Old)))
       and then Control_Of (This) =
         Turns.Starts.Started
           (Control_Of (This'Old), Transmit_Pair (This'Old));

private

   type Board is record
      Control       : Turns.Control;
      Receive_Pair  : Buffer_Pair;
      Transmit_Pair : Buffer_Pair;
   end record;

   function Control_Of (This : Board) return Control is (This.Control);

   --  These read the component itself: Control_Of copies it.

   function Tally (This : Board) return Statistics is (This.Control.Tally);

   --  Within a message the board waits, unless its own character is on the
   --  line.
   function May_Speak (This : Board) return Boolean is
     (case This.Control.Receiver.State is
         when At_End  => True,
         when In_Data => This.Control.Line_Taken,
         when others  => not Is_Waiting (This.Control));

   function Time_Left (This : Board) return Character_Times is
     (Time_Left (This.Control));

   function Receive_Pair (This : Board) return Buffer_Pair is
     (This.Receive_Pair);

   function Transmit_Pair (This : Board) return Buffer_Pair is
     (This.Transmit_Pair);

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
