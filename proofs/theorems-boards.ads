--  SPDX-License-Identifier: Apache-2.0

--  The telemetry board never gives its controller a wrong or an incomplete
--  block, as far as checksum and parity can detect it, and overwrites blocks
--  only by the report's rules (LNK-4 to LNK-7, LNK-10). This holds for both
--  boards in every state that they can reach, whatever characters, silence and
--  calls come. Errors that the checksum cannot detect are excluded; see
--  Theorems.Link.

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

   --  No block was put into a buffer, and none has come back.
   function Nothing_Put (Before, After : Buffer_Pair) return Boolean is
     (for all Which in Slot =>
        After.Slots (Which).Data = Before.Slots (Which).Data
        and then
          (if After.Slots (Which).Full
           then Before.Slots (Which).Full
             and then After.Slots (Which).Attempts =
               Before.Slots (Which).Attempts));

   --  A data message has ended, and no error was found in it.
   function Is_Whole (Item : Board) return Boolean is
     (Control_Of (Item).Receiver.State = At_End
      and then not Control_Of (Item).Receiver.Damaged);

   --  A message ends without an error only with the checksum of its header and
   --  of the bytes in its buffer. The buffer is not yet full.
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

   --  A receive buffer becomes full only after a message without errors, when
   --  no character came for the guard time. This message is counted, and a
   --  good status is owed. If both buffers are then full, the untaken block is
   --  counted.
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

       --  The counters count exactly these events.
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

   --  A message with one character more is never taken (D-27). If another
   --  character comes within the guard time after the apparent end, no buffer
   --  becomes full, even if the checksum was right, and the answer is bad. A
   --  doubled or inserted character has this effect.
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

   --  An untaken block is overwritten only if both buffers are full, and then
   --  it is the older one (LNK-4).
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

   --  Only the controller puts blocks into transmit buffers, so a scrapped
   --  block does not come back. No character puts one,
   procedure Character_Puts_Nothing
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => Nothing_Put (Transmit_Pair (Item'Old), Transmit_Pair (Item));

   --  nor does time.
   procedure Time_Puts_Nothing (Item : in out Board; Time : Character_Times)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => Nothing_Put (Transmit_Pair (Item'Old), Transmit_Pair (Item));

   --  The controller's new block is the newest, and the block on its way is
   --  unchanged (LNK-7).
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

   --  Two buffers are equal only if all components are equal. A contract about
   --  a pair therefore covers every byte. This procedure does not compile if a
   --  component is added.
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
