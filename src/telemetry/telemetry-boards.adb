--  SPDX-License-Identifier: Apache-2.0

with Telemetry.Checksum;
with Telemetry.Senders;       use Telemetry.Senders;
with Telemetry.Turns.Changes; use Telemetry.Turns.Changes;

package body Telemetry.Boards with SPARK_Mode is

   procedure Set_Round_Trip (This : in out Board; Time : Round_Trip_Time) is
   begin
      This.Control.Round_Trip := Time;
   end Set_Round_Trip;

   --  No further character came after the end of the message: it is judged
   --  good or bad.
   procedure Judge (This : in out Board)
   with
     Global => null,
     Pre    =>
       Is_Sound (This)
       and then Control_Of (This).Receiver.State = At_End,
     Post   =>
       Is_Sound (This)
       and then Control_Of (This) =
         Judged (Control_Of (This'Old), Receive_Pair (This))
       and then Receive_Pair (This) = Pair_Judged
         (Control_Of (This'Old).Receiver, Receive_Pair (This'Old))
       and then Transmit_Pair (This) = Transmit_Pair (This'Old);

   --  Time has passed, and the board is not within a message; see Elapse.
   procedure Elapse_Otherwise (This : in out Board; Time : Character_Times)
   with No_Inline;

   --  Rare paths are out of line, so that the common path for each character
   --  stays short. Elapse_Otherwise, Accept_Other and Begin_Or_Reply have no
   --  contract; they are proved at their calls.

   --  Accepts a character that is not a byte of a block; see Accept_Character.
   procedure Accept_Other
     (This         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with No_Inline;

   --  Gives the next character; see Next_Character. It does not touch the
   --  receiving side.
   procedure Speak
     (Item   : in out Turns.Control;
      Blocks : in out Buffer_Pair;
      Send   : out Boolean;
      Data   : out Byte)
   with
     Inline,
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then Holds (Blocks, Item)
       and then Fits (Item, Blocks),
     Post   =>
       Is_Sound (Item)
       and then Holds (Blocks, Item)
       and then Fits (Item, Blocks)
       and then Blocks =
         (if May_Begin_Block (Item'Old, Blocks'Old)
          then Begun (Blocks'Old, Newest_Full (Blocks'Old))
          else Blocks'Old)
       and then Fits (Prepared (Item'Old, Blocks'Old), Blocks)
       and then Item = Spoken (Prepared (Item'Old, Blocks'Old), Blocks)
       and then Item.Receiver = Item'Old.Receiver
       and then Item.Receive_Length = Item'Old.Receive_Length
       and then Data = Output (Prepared (Item'Old, Blocks'Old), Blocks)
       and then Send = Item.Line_Taken;

   --  The same for a board that neither sends a byte of its block nor waits.
   procedure Begin_Or_Reply
     (Item   : in out Turns.Control;
      Blocks : in out Buffer_Pair;
      Send   : out Boolean;
      Data   : out Byte)
   with No_Inline;

   --  The board has waited too long and resets itself.
   procedure Break_Off (This : in out Board; Time : Character_Times)
   with
     No_Inline,
     Global => null,
     Pre    =>
       Is_Sound (This) and then Is_Reset_After (Control_Of (This), Time),
     Post   =>
       Is_Sound (This)
       and then Control_Of (This) = Elapsed
         (Control_Of (This'Old), Time, Transmit_Pair (This'Old))
       and then Receive_Pair (This) = Released (Receive_Pair (This'Old))
       and then Transmit_Pair (This) = Settled
         (Transmit_Pair (This'Old),
          Control_Of (This'Old).Sender.Source,
          Delivery_In_Reset (Control_Of (This'Old)));

   procedure Accept_Other
     (This         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
      Before  : constant Turns.Control := This.Control with Ghost;
      Heard   : Receivers.Receiver with Ghost;
      Block   : Delivery;
      Trigger : Event;
   begin
      if Is_Listening (This.Control) then
         Accept_Character
           (This.Control.Receiver, This.Receive_Pair,
            This.Control.Receive_Length, Wants_Data (This.Control),
            Data, Parity_Error, Trigger);
         Heard := This.Control.Receiver;
         Block := Delivery_After (This.Control, Trigger);
         Inform (This.Control, Trigger, Block, This.Transmit_Pair);
         pragma Assert (Is_Sound (This.Control));
         pragma Assert
           (Has_Block_Out (This.Control) =
              (Has_Block_Out (Before) and then Block = Open));
         Settle (This.Transmit_Pair, This.Control.Sender.Source, Block);
         pragma Assert (Holds (This.Transmit_Pair, This.Control));
         pragma Assert (Fits (This.Control, This.Transmit_Pair));
         pragma Assert
           (if Has_Message (This.Control.Receiver)
            then This.Control.Receiver = Heard);
         pragma Assert
           (Fits
              (This.Control.Receiver, This.Receive_Pair,
               This.Control.Receive_Length));
      elsif not Is_Talking (This.Control) then
         This.Control.Silence := 0;
      end if;
   end Accept_Other;

   procedure Accept_Character
     (This         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean) is
   begin
      --  A board with a message has nothing else to send and does not idle.
      if Takes_Byte (This.Control.Receiver, This.Control.Receive_Length)
        and then not This.Control.Line_Taken
      then
         Store_Byte
           (This.Control.Receiver, This.Receive_Pair,
            This.Control.Receive_Length, Data, Parity_Error);
         This.Control.Silence := 0;
         pragma Assert (Holds (This.Transmit_Pair, This.Control));
         pragma Assert (Fits (This.Control, This.Transmit_Pair));
      else
         Accept_Other (This, Data, Parity_Error);
      end if;
   end Accept_Character;

   procedure Begin_Or_Reply
     (Item   : in out Turns.Control;
      Blocks : in out Buffer_Pair;
      Send   : out Boolean;
      Data   : out Byte)
   is
      Before : constant Turns.Control := Item with Ghost;
      Begins : constant Boolean := May_Begin_Block (Item, Blocks);
   begin
      Prepare (Item, Blocks, Begins);
      pragma Assert (Item = Prepared (Before, Blocks));
      if Begins then
         pragma Assert (Item.Sender.Source = Newest_Full (Blocks));
         Begin_Block (Blocks, Item.Sender.Source);
      end if;
      pragma Assert (Holds (Blocks, Item));
      pragma Assert (Fits (Item, Blocks));
      Data := Output (Item, Blocks);
      Note_Spoken (Item, Blocks);
      pragma Assert (Holds (Blocks, Item));
      Send := Item.Line_Taken;
   end Begin_Or_Reply;

   procedure Speak
     (Item   : in out Turns.Control;
      Blocks : in out Buffer_Pair;
      Send   : out Boolean;
      Data   : out Byte)
   is
      Before : constant Turns.Control := Item with Ghost;
   begin
      if Item.State = Sending
        and then Item.Sender.Sent
                 in 1 .. Character_Count (Item.Transmit_Length)
      then
         --  A byte of the block. Most characters are of this kind.
         pragma Assert (Prepared (Before, Blocks) = Before);
         Send := True;
         if Item.Sender.Source = First then
            Data := Blocks.Slots (First).Data (Byte_Index (Item.Sender.Sent));
         else
            Data := Blocks.Slots (Second).Data (Byte_Index (Item.Sender.Sent));
         end if;
         Item.Sender.Sum := Checksum.Next (Item.Sender.Sum, Data);
         Item.Sender.Sent := Item.Sender.Sent + 1;
         if Item.Line_Taken then
            Item.Silence := 0;
         else
            Item.Line_Taken := True;
         end if;
         pragma Assert
           (Item.Sender = Advanced
              (Before.Sender, Blocks.Slots (Before.Sender.Source).Data,
               Before.Transmit_Length));
         pragma Assert (Item = Spoken (Before, Blocks));
         pragma Assert (Is_Sound (Item));
         pragma Assert (Holds (Blocks, Item));
         pragma Assert (Fits (Item, Blocks));
      elsif Is_Waiting (Item) then
         Send := False;
         Data := 0;
         pragma Assert (Prepared (Before, Blocks) = Before);
         pragma Assert (Spoken (Before, Blocks) = Before);
      else
         Begin_Or_Reply (Item, Blocks, Send, Data);
      end if;
   end Speak;

   procedure Next_Character
     (This : in out Board;
      Send : out Boolean;
      Data : out Byte) is
   begin
      Speak (This.Control, This.Transmit_Pair, Send, Data);
   end Next_Character;

   procedure Judge (This : in out Board) is
      Before  : constant Turns.Control := This.Control with Ghost;
      Target  : constant Slot    := This.Control.Receiver.Target;
      Damaged : constant Boolean := This.Control.Receiver.Damaged;
   begin
      This.Receive_Pair.Slots (Target).Busy := False;
      This.Receive_Pair.Slots (Target).Full := not Damaged;
      if not Damaged then
         This.Receive_Pair.Newest := Target;
      end if;
      Judge_Message (This.Control, This.Receive_Pair);
      pragma Assert (not Has_Block_Out (Before));
      pragma Assert (Holds (This.Transmit_Pair, This.Control));
   end Judge;

   procedure Break_Off (This : in out Board; Time : Character_Times) is
      Before : constant Turns.Control := This.Control with Ghost;
      Block  : constant Delivery := Delivery_In_Reset (This.Control);
   begin
      Reset_Control (This.Control, This.Transmit_Pair);
      pragma Assert
        (This.Control = Elapsed (Before, Time, This.Transmit_Pair));
      Release (This.Receive_Pair);
      Settle (This.Transmit_Pair, This.Control.Sender.Source, Block);
   end Break_Off;

   procedure Elapse_Otherwise (This : in out Board; Time : Character_Times)
   is
   begin
      if not Is_Over_After (This.Control, Time) then
         if Is_Waiting (This.Control) then
            This.Control.Silence := This.Control.Silence + Time;
         end if;
      elsif This.Control.Receiver.State = At_End then
         Judge (This);
      else
         Break_Off (This, Time);
      end if;
   end Elapse_Otherwise;

   procedure Elapse (This : in out Board; Time : Character_Times) is
   begin
      --  A board with a character of its own on the line does not wait. Within
      --  a message it waits for the next character.
      if This.Control.Line_Taken then
         null;
      elsif This.Control.Receiver.State = In_Data
        and then This.Control.Silence + Time
                 < Dead_Space_On (This.Control.Round_Trip)
      then
         This.Control.Silence := This.Control.Silence + Time;
      else
         Elapse_Otherwise (This, Time);
      end if;
   end Elapse;

   procedure Take
     (This          : in out Board;
      Data          : out Block_Data;
      Fresh         : out Boolean;
      Ever_Received : out Boolean)
   is
      Before : constant Buffer_Pair := This.Receive_Pair with Ghost;
   begin
      Copy_Contents (This.Receive_Pair, Data);
      Fresh := Any_Full (This.Receive_Pair);
      Ever_Received := This.Control.Messages > 0;
      Take_All (This.Receive_Pair);
      Checksum.Same_Bytes_Same_Sum
        (Data_Header (This.Control.Receive_Length),
         Before.Slots (This.Control.Receiver.Target).Data,
         This.Receive_Pair.Slots (This.Control.Receiver.Target).Data,
         This.Control.Receiver.Received);
   end Take;

   procedure Put
     (This      : in out Board;
      Data      : Block_Data;
      Overwrote : out Boolean)
   is
      Before : constant Board := This with Ghost;
      Source : constant Slot  := This.Control.Sender.Source with Ghost;
   begin
      Overwrote := Both_Full (This.Transmit_Pair);
      Fill (This.Transmit_Pair, Data);
      pragma Assert (Holds (This.Transmit_Pair, This.Control));
      if This.Control.State = Sending and then This.Control.Sender.Sent > 0
      then
         Checksum.Same_Bytes_Same_Sum
           (Data_Header (This.Control.Transmit_Length),
            Before.Transmit_Pair.Slots (Source).Data,
            This.Transmit_Pair.Slots (Source).Data,
            Byte_Count (This.Control.Sender.Sent - 1));
      end if;
   end Put;

   procedure Clear_Transmit_Half (This : in out Board) is
   begin
      This.Control := Turns.Starts.Cleared (This.Control);
      This.Transmit_Pair := Empty_Pair;
   end Clear_Transmit_Half;

   procedure Start (This : in out Board) is
      Before : constant Turns.Control := This.Control;
   begin
      This.Control := Turns.Starts.Started (Before, This.Transmit_Pair);
      This.Receive_Pair := Empty_Pair;
      This.Transmit_Pair :=
        Settled
          (This.Transmit_Pair, Before.Sender.Source,
           Delivery_In_Reset (Before));
   end Start;

end Telemetry.Boards;
