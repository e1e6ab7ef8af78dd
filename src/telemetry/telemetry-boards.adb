--  SPDX-License-Identifier: Apache-2.0

with Telemetry.Checksum;

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

   procedure Accept_Character
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
   end Accept_Character;

   procedure Next_Character
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
   end Next_Character;

   procedure Judge (Item : in out Board) is
      Before : constant Turns.Control := Item.Control;
   begin
      Item.Receive_Pair := Pair_Judged (Before.Receiver, Item.Receive_Pair);
      Item.Control := Judged (Before, Item.Receive_Pair);
      pragma Assert (not Has_Block_Out (Before));
      pragma Assert (Holds (Item.Transmit_Pair, Item.Control));
   end Judge;

   procedure Elapse (Item : in out Board; Time : Character_Times) is
      Before : constant Turns.Control := Item.Control;
   begin
      if Is_Judged_After (Before, Time) then
         Judge (Item);
         return;
      end if;

      Item.Control := Elapsed (Before, Time, Item.Transmit_Pair);
      if Is_Reset_After (Before, Time) then
         Item.Receive_Pair := Released (Item.Receive_Pair);
         Item.Transmit_Pair :=
           Settled
             (Item.Transmit_Pair, Before.Sender.Source,
              Fate_In_Reset (Before));
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
