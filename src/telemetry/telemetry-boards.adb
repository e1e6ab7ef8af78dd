--  SPDX-License-Identifier: Apache-2.0

with Telemetry.Checksum;
with Telemetry.Senders; use Telemetry.Senders;

package body Telemetry.Boards with SPARK_Mode is

   --  A message that has come to its end went no further: it is good or bad.
   procedure Judge (Item : in out Board)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then Control_Of (Item).Receiver.State = At_End,
     Post   =>
       Is_Sound (Item)
       and then Control_Of (Item) =
         Judged (Control_Of (Item'Old), Receive_Pair (Item))
       and then Receive_Pair (Item) = Pair_Judged
         (Control_Of (Item'Old).Receiver, Receive_Pair (Item'Old))
       and then Transmit_Pair (Item) = Transmit_Pair (Item'Old);

   --  What is rare stands apart, so that the compiler makes short work of
   --  what comes with every character.

   --  A character has come that is no byte of a block: see Accept_Character.
   procedure Accept_Other
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     No_Inline,
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

   --  The next character of a board that neither sends a block nor waits: see
   --  Next_Character.
   procedure Begin_Or_Reply
     (Item : in out Board;
      Send : out Boolean;
      Data : out Byte)
   with
     No_Inline,
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

   --  The board has waited for too long, and resets itself.
   procedure Break_Off (Item : in out Board; Time : Character_Times)
   with
     No_Inline,
     Global => null,
     Pre    =>
       Is_Sound (Item) and then Is_Reset_After (Control_Of (Item), Time),
     Post   =>
       Is_Sound (Item)
       and then Control_Of (Item) = Elapsed
         (Control_Of (Item'Old), Time, Transmit_Pair (Item'Old))
       and then Receive_Pair (Item) = Released (Receive_Pair (Item'Old))
       and then Transmit_Pair (Item) = Settled
         (Transmit_Pair (Item'Old),
          Control_Of (Item'Old).Sender.Source,
          Fate_In_Reset (Control_Of (Item'Old)));

   procedure Accept_Other
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
      Before : constant Turns.Control := Item.Control with Ghost;
      Heard  : Receivers.Receiver with Ghost;
      Block  : Fate;
      What   : Event;
   begin
      if Is_Listening (Item.Control) then
         Accept_Character
           (Item.Control.Receiver, Item.Receive_Pair,
            Item.Control.Receive_Length, Wants_Data (Item.Control),
            Data, Parity_Error, What);
         Heard := Item.Control.Receiver;
         Block := Fate_After (Item.Control, What);
         Item.Control :=
           Informed (Item.Control, What, Item.Transmit_Pair);
         pragma Assert (Is_Sound (Item.Control));
         pragma Assert
           (Has_Block_Out (Item.Control) =
              (Has_Block_Out (Before) and then Block = Open));
         if Block /= Open then
            Item.Transmit_Pair :=
              Settled
                (Item.Transmit_Pair, Item.Control.Sender.Source, Block);
         end if;
         pragma Assert (Holds (Item.Transmit_Pair, Item.Control));
         pragma Assert (Fits (Item.Control, Item.Transmit_Pair));
         pragma Assert
           (if Has_Message (Item.Control.Receiver)
            then Item.Control.Receiver = Heard);
         pragma Assert
           (Fits
              (Item.Control.Receiver, Item.Receive_Pair,
               Item.Control.Receive_Length));
      elsif not Is_Talking (Item.Control) then
         Item.Control.Silence := 0;
      end if;
   end Accept_Other;

   procedure Accept_Character
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean) is
   begin
      if Takes_Byte (Item.Control.Receiver, Item.Control.Receive_Length)
        and then Is_Listening (Item.Control)
      then
         Store_Byte
           (Item.Control.Receiver, Item.Receive_Pair,
            Item.Control.Receive_Length, Data, Parity_Error);
         Item.Control.Silence := 0;
         pragma Assert (Holds (Item.Transmit_Pair, Item.Control));
         pragma Assert (Fits (Item.Control, Item.Transmit_Pair));
      else
         Accept_Other (Item, Data, Parity_Error);
      end if;
   end Accept_Character;

   procedure Begin_Or_Reply
     (Item : in out Board;
      Send : out Boolean;
      Data : out Byte)
   is
      Before : constant Turns.Control := Item.Control;
   begin
      Item.Control := Prepared (Before, Item.Transmit_Pair);
      if May_Begin_Block (Before, Item.Transmit_Pair) then
         Item.Transmit_Pair :=
           Begun (Item.Transmit_Pair, Item.Control.Sender.Source);
      end if;
      pragma Assert (Item.Control.Receiver = Before.Receiver);
      pragma Assert (Holds (Item.Transmit_Pair, Item.Control));
      pragma Assert (Fits (Item.Control, Item.Transmit_Pair));
      Data := Output (Item.Control, Item.Transmit_Pair);
      Item.Control := Spoken (Item.Control, Item.Transmit_Pair);
      pragma Assert (Holds (Item.Transmit_Pair, Item.Control));
      Send := Item.Control.Line_Taken;
   end Begin_Or_Reply;

   procedure Next_Character
     (Item : in out Board;
      Send : out Boolean;
      Data : out Byte)
   is
      Before : constant Turns.Control := Item.Control with Ghost;
   begin
      if Item.Control.State = Sending then
         pragma Assert (Prepared (Before, Item.Transmit_Pair) = Before);
         Send := True;
         Data :=
           Next_Byte
             (Item.Control.Sender,
              Item.Transmit_Pair.Slots (Item.Control.Sender.Source).Data,
              Item.Control.Transmit_Length);
         Item.Control.Sender :=
           Advanced
             (Item.Control.Sender,
              Item.Transmit_Pair.Slots (Item.Control.Sender.Source).Data,
              Item.Control.Transmit_Length);
         if Item.Control.Sender.Sent =
           Message_Length (Item.Control.Transmit_Length)
         then
            Item.Control.State := Awaiting_Status;
         end if;
         if Item.Control.Line_Taken then
            Item.Control.Silence := 0;
         end if;
         Item.Control.Line_Taken := True;
         pragma Assert (Item.Control = Spoken (Before, Item.Transmit_Pair));
         pragma Assert (Is_Sound (Item.Control));
         pragma Assert (Holds (Item.Transmit_Pair, Item.Control));
         pragma Assert (Fits (Item.Control, Item.Transmit_Pair));
      elsif Is_Waiting (Item.Control) then
         Send := False;
         Data := 0;
         pragma Assert (Prepared (Before, Item.Transmit_Pair) = Before);
         pragma Assert (Spoken (Before, Item.Transmit_Pair) = Before);
      else
         Begin_Or_Reply (Item, Send, Data);
      end if;
   end Next_Character;

   procedure Judge (Item : in out Board) is
      Before : constant Turns.Control := Item.Control;
   begin
      Item.Receive_Pair := Pair_Judged (Before.Receiver, Item.Receive_Pair);
      Item.Control := Judged (Before, Item.Receive_Pair);
      pragma Assert (not Has_Block_Out (Before));
      pragma Assert (Holds (Item.Transmit_Pair, Item.Control));
   end Judge;

   procedure Break_Off (Item : in out Board; Time : Character_Times) is
      Before : constant Turns.Control := Item.Control;
   begin
      Item.Control := Elapsed (Before, Time, Item.Transmit_Pair);
      Item.Receive_Pair := Released (Item.Receive_Pair);
      Item.Transmit_Pair :=
        Settled
          (Item.Transmit_Pair, Before.Sender.Source, Fate_In_Reset (Before));
   end Break_Off;

   procedure Elapse (Item : in out Board; Time : Character_Times) is
   begin
      if not Is_Over_After (Item.Control, Time) then
         if Is_Waiting (Item.Control) then
            Item.Control.Silence := Item.Control.Silence + Time;
         end if;
      elsif Item.Control.Receiver.State = At_End then
         Judge (Item);
      else
         Break_Off (Item, Time);
      end if;
   end Elapse;

   procedure Take
     (Item          : in out Board;
      Data          : out Block_Data;
      Fresh         : out Boolean;
      Ever_Received : out Boolean)
   is
      Before : constant Buffer_Pair := Item.Receive_Pair with Ghost;
   begin
      Data := Contents (Item.Receive_Pair);
      Fresh := Any_Full (Item.Receive_Pair);
      Ever_Received := Item.Control.Messages > 0;
      Item.Receive_Pair := Taken (Item.Receive_Pair);
      Checksum.Same_Bytes_Same_Sum
        (Data_Header (Item.Control.Receive_Length),
         Before.Slots (Item.Control.Receiver.Target).Data,
         Item.Receive_Pair.Slots (Item.Control.Receiver.Target).Data,
         Item.Control.Receiver.Received);
   end Take;

   procedure Put
     (Item      : in out Board;
      Data      : Block_Data;
      Overwrote : out Boolean)
   is
   begin
      Overwrote := Both_Full (Item.Transmit_Pair);
      Item.Transmit_Pair := Filled (Item.Transmit_Pair, Data);
   end Put;

   procedure Clear_Transmit_Half (Item : in out Board) is
   begin
      Item.Control := Turns.Starts.Cleared (Item.Control);
      Item.Transmit_Pair := Empty_Pair;
   end Clear_Transmit_Half;

   procedure Start (Item : in out Board) is
      Before : constant Turns.Control := Item.Control;
   begin
      Item.Control := Turns.Starts.Started (Before, Item.Transmit_Pair);
      Item.Receive_Pair := Empty_Pair;
      Item.Transmit_Pair :=
        Settled
          (Item.Transmit_Pair, Before.Sender.Source, Fate_In_Reset (Before));
   end Start;

end Telemetry.Boards;
