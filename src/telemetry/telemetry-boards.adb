--  SPDX-License-Identifier: Apache-2.0

with Telemetry.Checksum;
with Telemetry.Senders; use Telemetry.Senders;

package body Telemetry.Boards with SPARK_Mode is

   --  A message that has come to its end went no further: it is good or bad.
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

   --  What is rare stands apart, so that the compiler makes short work of
   --  what comes with every character.

   --  A character has come that is no byte of a block: see Accept_Character.
   procedure Accept_Other
     (This         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     No_Inline,
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
               Fate_After
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

   --  The next character of a board that neither sends a block nor waits: see
   --  Next_Character.
   procedure Begin_Or_Reply
     (This : in out Board;
      Send : out Boolean;
      Data : out Byte)
   with
     No_Inline,
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

   --  The board has waited for too long, and resets itself.
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
          Fate_In_Reset (Control_Of (This'Old)));

   procedure Accept_Other
     (This         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
      Before : constant Turns.Control := This.Control with Ghost;
      Heard  : Receivers.Receiver with Ghost;
      Block  : Fate;
      What   : Event;
   begin
      if Is_Listening (This.Control) then
         Accept_Character
           (This.Control.Receiver, This.Receive_Pair,
            This.Control.Receive_Length, Wants_Data (This.Control),
            Data, Parity_Error, What);
         Heard := This.Control.Receiver;
         Block := Fate_After (This.Control, What);
         This.Control :=
           Informed (This.Control, What, This.Transmit_Pair);
         pragma Assert (Is_Sound (This.Control));
         pragma Assert
           (Has_Block_Out (This.Control) =
              (Has_Block_Out (Before) and then Block = Open));
         if Block /= Open then
            This.Transmit_Pair :=
              Settled
                (This.Transmit_Pair, This.Control.Sender.Source, Block);
         end if;
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
      if Takes_Byte (This.Control.Receiver, This.Control.Receive_Length)
        and then Is_Listening (This.Control)
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
     (This : in out Board;
      Send : out Boolean;
      Data : out Byte)
   is
      Before : constant Turns.Control := This.Control;
   begin
      This.Control := Prepared (Before, This.Transmit_Pair);
      if May_Begin_Block (Before, This.Transmit_Pair) then
         This.Transmit_Pair :=
           Begun (This.Transmit_Pair, This.Control.Sender.Source);
      end if;
      pragma Assert (This.Control.Receiver = Before.Receiver);
      pragma Assert (Holds (This.Transmit_Pair, This.Control));
      pragma Assert (Fits (This.Control, This.Transmit_Pair));
      Data := Output (This.Control, This.Transmit_Pair);
      This.Control := Spoken (This.Control, This.Transmit_Pair);
      pragma Assert (Holds (This.Transmit_Pair, This.Control));
      Send := This.Control.Line_Taken;
   end Begin_Or_Reply;

   procedure Next_Character
     (This : in out Board;
      Send : out Boolean;
      Data : out Byte)
   is
      Before : constant Turns.Control := This.Control with Ghost;
   begin
      if This.Control.State = Sending then
         pragma Assert (Prepared (Before, This.Transmit_Pair) = Before);
         Send := True;
         Data :=
           Next_Byte
             (This.Control.Sender,
              This.Transmit_Pair.Slots (This.Control.Sender.Source).Data,
              This.Control.Transmit_Length);
         This.Control.Sender :=
           Advanced
             (This.Control.Sender,
              This.Transmit_Pair.Slots (This.Control.Sender.Source).Data,
              This.Control.Transmit_Length);
         if This.Control.Sender.Sent =
           Message_Length (This.Control.Transmit_Length)
         then
            This.Control.State := Awaiting_Status;
         end if;
         if This.Control.Line_Taken then
            This.Control.Silence := 0;
         end if;
         This.Control.Line_Taken := True;
         pragma Assert (This.Control = Spoken (Before, This.Transmit_Pair));
         pragma Assert (Is_Sound (This.Control));
         pragma Assert (Holds (This.Transmit_Pair, This.Control));
         pragma Assert (Fits (This.Control, This.Transmit_Pair));
      elsif Is_Waiting (This.Control) then
         Send := False;
         Data := 0;
         pragma Assert (Prepared (Before, This.Transmit_Pair) = Before);
         pragma Assert (Spoken (Before, This.Transmit_Pair) = Before);
      else
         Begin_Or_Reply (This, Send, Data);
      end if;
   end Next_Character;

   procedure Judge (This : in out Board) is
      Before : constant Turns.Control := This.Control;
   begin
      This.Receive_Pair := Pair_Judged (Before.Receiver, This.Receive_Pair);
      This.Control := Judged (Before, This.Receive_Pair);
      pragma Assert (not Has_Block_Out (Before));
      pragma Assert (Holds (This.Transmit_Pair, This.Control));
   end Judge;

   procedure Break_Off (This : in out Board; Time : Character_Times) is
      Before : constant Turns.Control := This.Control;
   begin
      This.Control := Elapsed (Before, Time, This.Transmit_Pair);
      This.Receive_Pair := Released (This.Receive_Pair);
      This.Transmit_Pair :=
        Settled
          (This.Transmit_Pair, Before.Sender.Source, Fate_In_Reset (Before));
   end Break_Off;

   procedure Elapse (This : in out Board; Time : Character_Times) is
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
   end Elapse;

   procedure Take
     (This          : in out Board;
      Data          : out Block_Data;
      Fresh         : out Boolean;
      Ever_Received : out Boolean)
   is
      Before : constant Buffer_Pair := This.Receive_Pair with Ghost;
   begin
      Data := Contents (This.Receive_Pair);
      Fresh := Any_Full (This.Receive_Pair);
      Ever_Received := This.Control.Messages > 0;
      This.Receive_Pair := Taken (This.Receive_Pair);
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
   begin
      Overwrote := Both_Full (This.Transmit_Pair);
      This.Transmit_Pair := Filled (This.Transmit_Pair, Data);
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
          (This.Transmit_Pair, Before.Sender.Source, Fate_In_Reset (Before));
   end Start;

end Telemetry.Boards;
