--  SPDX-License-Identifier: Apache-2.0

with Telemetry.Headers; use Telemetry.Headers;

package body Theorems.Boards with SPARK_Mode is

   --  When a receiver says that a message begins, and that it ended well.
   procedure Begins_And_Ends
     (Item         : Receiver;
      Length       : Block_Length;
      Wants_Data   : Boolean;
      Data         : Byte;
      Parity_Error : Boolean;
      What         : Event)
   with
     Global => null,
     Pre    =>
       What = Outcome_Of (Item, Length, Wants_Data, Data, Parity_Error),
     Post   =>
       (if What.Kind = Block_Begun then Item.State = At_Start)
       and then
         (if What.Kind in Block_Good | Block_Bad
          then Item.State = In_Data and then Item.Received >= Length)
       and then
         (if What.Kind = Block_Good
          then not Item.Damaged
            and then not Parity_Error
            and then Data = Item.Sum);

   --  Which buffers become full, and which no longer are.
   procedure Full_And_Empty
     (Item          : Receiver;
      Length        : Block_Length;
      Before, After : Buffer_Pair;
      What          : Event_Kind;
      Data          : Byte)
   with
     Global => null,
     Pre    =>
       Fits (Item, Before, Length)
       and then
         (if Is_Stored (Item, What) then Item.Received < Longest_Block)
       and then (if What = Block_Begun then Item.State = At_Start)
       and then
         (if What in Block_Good | Block_Bad then Item.State = In_Data)
       and then After =
         (if Is_Stored (Item, What)
          then Pair_With_Byte (Item, Before, Data)
          else Pair_After (Item, Before, What)),
     Post   =>
       (for all Which in Slot =>
          Is_Filled (Before, After, Which) =
            (What = Block_Good and then Which = Item.Target)
          and then
            (if Before.Slots (Which).Full
               and then not After.Slots (Which).Full
             then Both_Full (Before)
               and then Which = Other (Before.Newest)))
       and then
         (if What = Block_Good
          then After.Newest = Item.Target
            and then After.Slots (Item.Target).Data =
              Before.Slots (Item.Target).Data);

   --  What the board makes of it.
   procedure Owed_And_Counted
     (Item             : Control;
      What             : Event;
      Received, Blocks : Buffer_Pair;
      After            : Control)
   with
     Global => null,
     Pre    => After = Informed (Item, What, Received, Blocks),
     Post   =>
       (if What.Kind = Block_Good then After.Owed = Good)
       and then After.Receive_Length = Item.Receive_Length
       and then After.Messages =
         Counted (Item.Messages, What.Kind = Block_Good)
       and then After.Tally.Not_Taken = Counted
         (Item.Tally.Not_Taken,
          What.Kind = Block_Good and then Both_Full (Received));

   procedure Begins_And_Ends
     (Item         : Receiver;
      Length       : Block_Length;
      Wants_Data   : Boolean;
      Data         : Byte;
      Parity_Error : Boolean;
      What         : Event)
   is null;

   procedure Full_And_Empty
     (Item          : Receiver;
      Length        : Block_Length;
      Before, After : Buffer_Pair;
      What          : Event_Kind;
      Data          : Byte)
   is
      pragma Unreferenced (Length, Data);
   begin
      case What is
         when Block_Begun            =>
            pragma Assert
              (for all Which in Slot =>
                 After.Slots (Which).Full =
                   (Before.Slots (Which).Full
                    and then Which /= To_Fill (Before)));
         when Block_Good | Block_Bad =>
            pragma Assert (not Is_Stored (Item, What));
            pragma Assert
              (After.Slots (Other (Item.Target)).Full =
                 Before.Slots (Other (Item.Target)).Full);
            if What = Block_Good then
               pragma Assert (After.Slots (Item.Target).Full);
            else
               pragma Assert (not After.Slots (Item.Target).Full);
            end if;
         when others                 =>
            if Is_Stored (Item, What) then
               pragma Assert
                 (After.Slots (Item.Target).Full =
                    Before.Slots (Item.Target).Full);
               pragma Assert
                 (After.Slots (Other (Item.Target)).Full =
                    Before.Slots (Other (Item.Target)).Full);
            end if;
      end case;
   end Full_And_Empty;

   procedure Owed_And_Counted
     (Item             : Control;
      What             : Event;
      Received, Blocks : Buffer_Pair;
      After            : Control)
   is null;

   --  What a character may do to the receive pair, and what is counted. Good
   --  tells that a data message ended with it, and well.
   procedure Hear
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean;
      Good         : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       (for all Which in Slot =>
          Is_Filled (Receive_Pair (Item'Old), Receive_Pair (Item), Which) =
            (Good and then Which = Control_Of (Item'Old).Receiver.Target)
          and then
            (if Receive_Pair (Item'Old).Slots (Which).Full
               and then not Receive_Pair (Item).Slots (Which).Full
             then Both_Full (Receive_Pair (Item'Old))
               and then Which = Other (Receive_Pair (Item'Old).Newest)))
       and then
         (if Good
          then not Parity_Error
            and then Control_Of (Item'Old).Receiver.State = In_Data
            and then Control_Of (Item'Old).Receiver.Received =
              Control_Of (Item).Receive_Length
            and then not Control_Of (Item'Old).Receiver.Damaged
            and then Data = Checksum.Of_Message
              (Data_Header (Control_Of (Item).Receive_Length),
               Receive_Pair (Item).Slots
                 (Control_Of (Item'Old).Receiver.Target).Data,
               Control_Of (Item).Receive_Length)
            and then Receive_Pair (Item).Newest =
              Control_Of (Item'Old).Receiver.Target
            and then Control_Of (Item).Owed = Turns.Good)
       and then Control_Of (Item).Messages =
         Counted (Control_Of (Item'Old).Messages, Good)
       and then Tally (Item).Not_Taken = Counted
         (Tally (Item'Old).Not_Taken,
          Good and then Both_Full (Receive_Pair (Item)));

   procedure Hear
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean;
      Good         : out Boolean)
   is
      Was  : constant Control     := Control_Of (Item);
      Pair : constant Buffer_Pair := Receive_Pair (Item);
      Sent : constant Buffer_Pair := Transmit_Pair (Item);
      What : constant Event       := Heard (Item, Data, Parity_Error);
      Told : Control              := Was;
   begin
      Accept_Character (Item, Data, Parity_Error);
      Good := Is_Listening (Was) and then What.Kind = Block_Good;
      if Is_Listening (Was) then
         Begins_And_Ends
           (Was.Receiver, Was.Receive_Length, Wants_Data (Was), Data,
            Parity_Error, What);
         Full_And_Empty
           (Was.Receiver, Was.Receive_Length, Pair, Receive_Pair (Item),
            What.Kind, Data);
         Told.Receiver := Receiver_After
           (Was.Receiver, Pair, What.Kind, Data, Parity_Error);
         Owed_And_Counted
           (Told, What, Receive_Pair (Item), Sent, Control_Of (Item));
         if Good then
            Checksum.Same_Bytes_Same_Sum
              (Data_Header (Was.Receive_Length),
               Pair.Slots (Was.Receiver.Target).Data,
               Receive_Pair (Item).Slots (Was.Receiver.Target).Data,
               Was.Receiver.Received);
         end if;
      end if;
   end Hear;

   procedure Full_Only_When_Right
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
      Good : Boolean;
   begin
      Hear (Item, Data, Parity_Error, Good);
      pragma Unreferenced (Good);
   end Full_Only_When_Right;

   procedure Older_Is_Overwritten
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
      Good : Boolean;
   begin
      Hear (Item, Data, Parity_Error, Good);
      pragma Unreferenced (Good);
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

   procedure Taken_Once (Item : in out Board) is
      Data                 : Block_Data;
      Fresh, Ever_Received : Boolean;
   begin
      Take (Item, Data, Fresh, Ever_Received);
      pragma Unreferenced (Data, Fresh, Ever_Received);
   end Taken_Once;

end Theorems.Boards;
