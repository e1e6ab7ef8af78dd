--  SPDX-License-Identifier: Apache-2.0

with Telemetry.Headers; use Telemetry.Headers;

package body Theorems.Boards with SPARK_Mode is

   --  The buffers that a character fills, and those that it empties.
   procedure Full_And_Empty
     (Item          : Receiver;
      Length        : Block_Length;
      Before, After : Buffer_Pair;
      Trigger       : Event_Kind;
      Data          : Byte)
   with
     Global => null,
     Pre    =>
       Fits (Item, Before, Length)
       and then
         (if Is_Stored (Item, Trigger) then Item.Received < Longest_Block)
       and then (if Trigger = Block_Begun then Item.State = At_Start)
       and then After =
         (if Is_Stored (Item, Trigger)
          then Pair_With_Byte (Item, Before, Data)
          else Pair_After (Before, Trigger)),
     Post   =>
       (for all Which in Slot =>
          not Is_Filled (Before, After, Which)
          and then
            (if Before.Slots (Which).Full
               and then not After.Slots (Which).Full
             then Both_Full (Before)
               and then Which = Other (Before.Newest)));

   procedure Full_And_Empty
     (Item          : Receiver;
      Length        : Block_Length;
      Before, After : Buffer_Pair;
      Trigger       : Event_Kind;
      Data          : Byte)
   is
      pragma Unreferenced (Length, Data);
   begin
      if Trigger = Block_Begun then
         pragma Assert
           (for all Which in Slot =>
              After.Slots (Which).Full =
                (Before.Slots (Which).Full
                 and then Which /= To_Fill (Before)));
      elsif Is_Stored (Item, Trigger) then
         pragma Assert
           (After.Slots (Item.Target).Full =
              Before.Slots (Item.Target).Full);
         pragma Assert
           (After.Slots (Other (Item.Target)).Full =
              Before.Slots (Other (Item.Target)).Full);
      end if;
   end Full_And_Empty;

   --  The events of a character that ends a message.
   procedure Ends_Whole
     (Item         : Receiver;
      Length       : Block_Length;
      Wants_Data   : Boolean;
      Data         : Byte;
      Parity_Error : Boolean;
      Trigger      : Event)
   with
     Global => null,
     Pre    =>
       Trigger = Outcome_Of (Item, Length, Wants_Data, Data, Parity_Error),
     Post   =>
       (if Trigger.Kind = Block_Whole
        then Item.State = In_Data
          and then Item.Received >= Length
          and then not Item.Damaged
          and then not Parity_Error
          and then Data = Item.Sum)
       and then (if Trigger.Kind = Block_Begun then Item.State = At_Start);

   procedure Ends_Whole
     (Item         : Receiver;
      Length       : Block_Length;
      Wants_Data   : Boolean;
      Data         : Byte;
      Parity_Error : Boolean;
      Trigger      : Event)
   is null;

   --  The possible effects of a character on the receive pair.
   procedure Hear
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Is_Sound (Item)
       and then
         (for all Which in Slot =>
            not Is_Filled
              (Receive_Pair (Item'Old), Receive_Pair (Item), Which)
            and then
              (if Receive_Pair (Item'Old).Slots (Which).Full
                 and then not Receive_Pair (Item).Slots (Which).Full
               then Both_Full (Receive_Pair (Item'Old))
                 and then Which = Other (Receive_Pair (Item'Old).Newest)))
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

   procedure Hear
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
      Was     : constant Control     := Control_Of (Item);
      Pair    : constant Buffer_Pair := Receive_Pair (Item);
      Trigger : constant Event       := Heard (Item, Data, Parity_Error);
   begin
      Accept_Character (Item, Data, Parity_Error);
      if Is_Listening (Was) then
         Ends_Whole
           (Was.Receiver, Was.Receive_Length, Wants_Data (Was), Data,
            Parity_Error, Trigger);
         Full_And_Empty
           (Was.Receiver, Was.Receive_Length, Pair, Receive_Pair (Item),
            Trigger.Kind, Data);
      end if;
   end Hear;

   procedure Whole_Only_When_Right
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
   begin
      Hear (Item, Data, Parity_Error);
   end Whole_Only_When_Right;

   --  Judging leaves a message unchanged; only its buffer becomes full.
   procedure Judged_As_It_Is
     (Item : Receiver; Before, After : Buffer_Pair)
   with
     Global => null,
     Pre    => After = Pair_Judged (Item, Before),
     Post   =>
       (for all Which in Slot =>
          After.Slots (Which).Data = Before.Slots (Which).Data
          and then After.Slots (Which).Full =
            (if Which = Item.Target then not Item.Damaged
             else Before.Slots (Which).Full));

   procedure Judged_As_It_Is
     (Item : Receiver; Before, After : Buffer_Pair)
   is
   begin
      pragma Assert
        (After.Slots (Item.Target).Data = Before.Slots (Item.Target).Data);
      pragma Assert
        (After.Slots (Other (Item.Target)) =
           Before.Slots (Other (Item.Target)));
   end Judged_As_It_Is;

   --  The state of a board after one more character.
   procedure Goes_On
     (Item    : Control;
      Trigger : Event;
      Blocks  : Buffer_Pair;
      After   : Control)
   with
     Global => null,
     Pre    =>
       Trigger.Kind = Block_Spoilt
       and then After = Informed
         ((Item with delta
             Receiver => (Item.Receiver with delta
               State => At_End, Damaged => True)),
          Trigger, Blocks),
     Post   =>
       After.Receiver.State = At_End
       and then After.Receiver.Damaged
       and then After.Silence = 0
       and then After.State = Item.State
       and then After.Owed = Item.Owed
       and then After.Line_Taken = Item.Line_Taken
       and then After.Messages = Item.Messages;

   procedure Goes_On
     (Item    : Control;
      Trigger : Event;
      Blocks  : Buffer_Pair;
      After   : Control)
   is null;

   --  The answer owed and the count after a bad message is judged.
   procedure Judged_Bad
     (Item : Control; Received : Buffer_Pair; After : Control)
   with
     Global => null,
     Pre    =>
       Item.Receiver.Damaged and then After = Judged (Item, Received),
     Post   => After.Owed = Bad and then After.Messages = Item.Messages;

   procedure Judged_Bad
     (Item : Control; Received : Buffer_Pair; After : Control)
   is null;

   --  A message is judged after its wait is over.
   procedure Waited_To_Judge (Item : Control; Time : Character_Times)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       (if Item.Receiver.State = At_End and then not Is_Talking (Item)
        then Is_Judged_After (Item, Time) =
          (Natural (Item.Silence) + Natural (Time) >= Natural (Guard_Time))
        else not Is_Judged_After (Item, Time));

   procedure Waited_To_Judge (Item : Control; Time : Character_Times) is
      pragma Unreferenced (Time);
   begin
      pragma Assert
        (if Item.Receiver.State = At_End then Timeout (Item) = Guard_Time);
   end Waited_To_Judge;

   procedure Full_Only_When_Right
     (Item : in out Board; Time : Character_Times)
   is
      Was  : constant Control     := Control_Of (Item);
      Pair : constant Buffer_Pair := Receive_Pair (Item);
   begin
      Elapse (Item, Time);
      Waited_To_Judge (Was, Time);
      if Is_Judged_After (Was, Time) then
         Judged_As_It_Is (Was.Receiver, Pair, Receive_Pair (Item));
         pragma Assert (Was.Receiver.State = At_End);
      else
         pragma Assert
           (for all Which in Slot =>
              Receive_Pair (Item).Slots (Which).Full =
                Pair.Slots (Which).Full);
      end if;
   end Full_Only_When_Right;

   --  From then on the message ends as bad.
   procedure Ends_Bad (Item : in out Board; After : Character_Times)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then Control_Of (Item).Receiver.State = At_End
       and then Control_Of (Item).Receiver.Damaged
       and then not Is_Talking (Control_Of (Item))
       and then Control_Of (Item).Silence = 0,
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

   procedure Ends_Bad (Item : in out Board; After : Character_Times) is
      Was  : constant Control     := Control_Of (Item);
      Pair : constant Buffer_Pair := Receive_Pair (Item);
   begin
      Waited_To_Judge (Was, After);
      Elapse (Item, After);
      if Is_Judged_After (Was, After) then
         Judged_As_It_Is (Was.Receiver, Pair, Receive_Pair (Item));
         Judged_Bad (Was, Receive_Pair (Item), Control_Of (Item));
      end if;
   end Ends_Bad;

   procedure One_Character_More_Is_Bad
     (Item         : in out Board;
      Before       : Character_Times;
      Data         : Byte;
      Parity_Error : Boolean;
      After        : Character_Times)
   is
      Had : constant Count := Control_Of (Item).Messages;
   begin
      Waited_To_Judge (Control_Of (Item), Before);
      Elapse (Item, Before);
      pragma Assert (Control_Of (Item).Messages = Had);
      pragma Assert
        (Control_Of (Item).Receiver.State = At_End
         and then Is_Listening (Control_Of (Item)));
      declare
         Was     : constant Control     := Control_Of (Item);
         Pair    : constant Buffer_Pair := Receive_Pair (Item);
         Sent    : constant Buffer_Pair := Transmit_Pair (Item);
         Trigger : constant Event       := Heard (Item, Data, Parity_Error);
      begin
         Accept_Character (Item, Data, Parity_Error);
         Goes_On (Was, Trigger, Sent, Control_Of (Item));
         pragma Assert (Receive_Pair (Item) = Pair);
      end;
      Ends_Bad (Item, After);
   end One_Character_More_Is_Bad;

   procedure Older_Is_Overwritten
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
   begin
      Hear (Item, Data, Parity_Error);
   end Older_Is_Overwritten;

   procedure Character_Puts_Nothing
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
   begin
      Accept_Character (Item, Data, Parity_Error);
   end Character_Puts_Nothing;

   procedure Time_Puts_Nothing (Item : in out Board; Time : Character_Times)
   is
   begin
      Elapse (Item, Time);
   end Time_Puts_Nothing;

   procedure Put_Is_Newest (Item : in out Board; Data : Block_Data) is
      Overwrote : Boolean;
   begin
      Put (Item, Data, Overwrote);
      pragma Unreferenced (Overwrote);
   end Put_Is_Newest;

   procedure The_Same_In_All
     (One        : Buffer;
      Full, Busy : Boolean;
      Attempts   : Attempt_Count;
      Data       : Block_Data)
   is null;

   procedure Taken_Once (Item : in out Board) is
      Data                 : Block_Data;
      Fresh, Ever_Received : Boolean;
   begin
      Take (Item, Data, Fresh, Ever_Received);
      pragma Unreferenced (Data, Fresh, Ever_Received);
   end Taken_Once;

end Theorems.Boards;
