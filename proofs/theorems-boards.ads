--  SPDX-License-Identifier: Apache-2.0

--  What follows from what a telemetry board does: when a buffer becomes full
--  and when it is overwritten (LNK-4 to LNK-7, LNK-10). Each theorem is
--  about any sound board, whatever happens to it.

with Telemetry;           use Telemetry;
with Telemetry.Boards;    use Telemetry.Boards;
with Telemetry.Checksum;
with Telemetry.Memory;    use Telemetry.Memory;
with Telemetry.Receivers; use Telemetry.Receivers;
with Telemetry.Turns;     use Telemetry.Turns;
with URVOS;               use URVOS;

package Theorems.Boards with Pure, SPARK_Mode, Ghost is

   --  A buffer that has become full.
   function Is_Filled (Before, After : Buffer_Pair; Which : Slot)
     return Boolean
   is
     (After.Slots (Which).Full and then not Before.Slots (Which).Full);

   --  Nothing has been put into a buffer, and no block has come back.
   function Nothing_Put (Before, After : Buffer_Pair) return Boolean is
     (for all Which in Slot =>
        After.Slots (Which).Data = Before.Slots (Which).Data
        and then
          (if After.Slots (Which).Full
           then Before.Slots (Which).Full
             and then After.Slots (Which).Attempts =
               Before.Slots (Which).Attempts));

   --  A data message has come to its end, and all of it was right so far.
   function Is_Whole (Item : Board) return Boolean is
     (Control_Of (Item).Receiver.State = At_End
      and then not Control_Of (Item).Receiver.Damaged);

   --  A message comes to its end and is right only with the checksum of its
   --  header and of what is in its buffer. The buffer is not full yet.
   procedure Whole_Only_When_Right
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       (for all Which in Slot =>
          not Is_Filled
            (Receive_Pair (Item'Old), Receive_Pair (Item), Which))
       and then
         (if Is_Whole (Item) and then not Is_Whole (Item'Old)
          then not Parity_Error
            and then Control_Of (Item'Old).Receiver.State = In_Data
            and then Control_Of (Item'Old).Receiver.Received =
              Control_Of (Item).Receive_Length
            and then not Control_Of (Item'Old).Receiver.Damaged
            and then Data = Checksum.Of_Message
              (Data_Header (Control_Of (Item).Receive_Length),
               Receive_Pair (Item).Slots
                 (Control_Of (Item).Receiver.Target).Data,
               Control_Of (Item).Receive_Length));

   --  A receive buffer becomes full only with a message that was right to
   --  its end, and after which nothing came for the guard time; that one is
   --  counted, and owed a good status. One that nobody took in time is
   --  counted when the newer one is full.
   procedure Full_Only_When_Right
     (Item : in out Board; Time : Character_Times)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       (for all Which in Slot =>
          (if Is_Filled
             (Receive_Pair (Item'Old), Receive_Pair (Item), Which)
           then Is_Whole (Item'Old)
             and then Control_Of (Item'Old).Receiver.Target = Which
             and then Natural (Control_Of (Item'Old).Silence)
                        + Natural (Time) >= Natural (Guard_Time)
             and then Receive_Pair (Item).Slots (Which).Data =
               Receive_Pair (Item'Old).Slots (Which).Data
             and then Receive_Pair (Item).Newest = Which
             and then Control_Of (Item).Owed = Good))

       --  The counters count exactly those.
       and then Control_Of (Item).Messages =
         (if (for some Which in Slot =>
                Is_Filled
                  (Receive_Pair (Item'Old), Receive_Pair (Item), Which))
          then Incremented (Control_Of (Item'Old).Messages)
          else Control_Of (Item'Old).Messages)
       and then Tally (Item).Not_Taken =
         (if Both_Full (Receive_Pair (Item))
            and then not Both_Full (Receive_Pair (Item'Old))
          then Incremented (Tally (Item'Old).Not_Taken)
          else Tally (Item'Old).Not_Taken);

   --  A message with one character more is never taken (D-27): when another
   --  comes within the guard time of what seemed its end, as the last
   --  character of a message does in which one was doubled or inserted,
   --  nothing becomes full, however right it seemed, and the answer is bad.
   procedure One_Character_More_Is_Bad
     (Item         : in out Board;
      Before       : Character_Times;
      Data         : Byte;
      Parity_Error : Boolean;
      After        : Character_Times)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then Control_Of (Item).Receiver.State = At_End
       and then not Is_Talking (Control_Of (Item))
       and then Natural (Control_Of (Item).Silence) + Natural (Before) <
                  Natural (Guard_Time),
     Post   =>
       Is_Sound (Item)
       and then
         (for all Which in Slot =>
            not Is_Filled
              (Receive_Pair (Item'Old), Receive_Pair (Item), Which))
       and then Control_Of (Item).Messages = Control_Of (Item'Old).Messages
       and then
         (if After >= Guard_Time
          then Control_Of (Item).Owed = Bad
          else Control_Of (Item).Receiver.State = At_End
            and then Control_Of (Item).Receiver.Damaged
            and then not Is_Talking (Control_Of (Item)));

   --  A block that the controller has not taken is overwritten only when
   --  both buffers are full, and then it is the older one (LNK-4).
   procedure Older_Is_Overwritten
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       (for all Which in Slot =>
          (if Receive_Pair (Item'Old).Slots (Which).Full
             and then not Receive_Pair (Item).Slots (Which).Full
           then Both_Full (Receive_Pair (Item'Old))
             and then Which = Other (Receive_Pair (Item'Old).Newest)));

   --  Nothing is ever put into a transmit buffer but by the controller: what
   --  was scrapped does not come back. Not by a character,
   procedure Character_Puts_Nothing
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => Nothing_Put (Transmit_Pair (Item'Old), Transmit_Pair (Item));

   --  nor by time.
   procedure Time_Puts_Nothing (Item : in out Board; Time : Character_Times)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => Nothing_Put (Transmit_Pair (Item'Old), Transmit_Pair (Item));

   --  The block that the controller puts is the newest, and the block on
   --  its way stays as it is (LNK-7).
   procedure Put_Is_Newest (Item : in out Board; Data : Block_Data)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Any_Full (Transmit_Pair (Item))
       and then Newest_Full (Transmit_Pair (Item)) =
         Transmit_Pair (Item).Newest
       and then Transmit_Pair (Item).Slots
         (Transmit_Pair (Item).Newest).Data = Data
       and then
         (for all Which in Slot =>
            (if Transmit_Pair (Item'Old).Slots (Which).Busy
             then Transmit_Pair (Item).Slots (Which) =
               Transmit_Pair (Item'Old).Slots (Which)));

   --  Buffers are the same only if all that they have is: what a contract
   --  says of a pair, it says of every byte. A component more does not
   --  compile here.
   procedure The_Same_In_All
     (One        : Buffer;
      Full, Busy : Boolean;
      Attempts   : Attempt_Count;
      Data       : Block_Data)
   with
     Global => null,
     Post   =>
       (One = (Full, Busy, Attempts, Data)) =
         (One.Full = Full
          and then One.Busy = Busy
          and then One.Attempts = Attempts
          and then One.Data = Data);

   --  The controller takes a block once.
   procedure Taken_Once (Item : in out Board)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => not Any_Full (Receive_Pair (Item));

end Theorems.Boards;
