--  SPDX-License-Identifier: Apache-2.0

package body Telemetry.Boards with SPARK_Mode is

   procedure Count_One (Value : in out Count)
   with
     Global => null,
     Post   => Value = Incremented (Value'Old);

   --  The block in one buffer was not confirmed. After its second
   --  transmission it is scrapped (LNK-6).
   procedure Refuse
     (Pair     : in out Buffer_Pair;
      Which    : Slot;
      Scrapped : in out Count)
   with
     Global => null,
     Post   =>
       Pair = Refused (Pair'Old, Which)
       and then Scrapped = Counted
         (Scrapped'Old,
          Pair'Old.Slots (Which).Attempts = Attempt_Count'Last);

   --  The block on its way was not confirmed.
   procedure End_Attempt (Item : in out Board)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item) and then Item.State in Sending | Awaiting_Status,
     Post   =>
       Is_Sound (Item)
       and then Item = (Item'Old with delta
         Transmit_Pair => Pair_Given_Up (Item'Old),
         State         => Ready,
         Tally         => (Item'Old.Tally with delta
           Scrapped =>
             Counted (Item'Old.Tally.Scrapped, Is_Scrapped (Item'Old))));

   --  Gives up waiting (LNK-9).
   procedure Reset (Item : in out Board)
   with
     Global => null,
     Pre    => Is_Sound (Item) and then not Is_Talking (Item),
     Post   => Is_Sound (Item) and then Item = Reset_Board (Item'Old);

   --  The block on its way was answered.
   procedure Accept_Status
     (Item           : in out Board;
      Confirmed      : Boolean;
      Wants_Downlink : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item) and then Item.State = Awaiting_Status,
     Post   =>
       Is_Sound (Item)
       and then Item = (Item'Old with delta
         Transmit_Pair  => Pair_Answered (Item'Old, Confirmed),
         State          => Ready,
         Downlink_Turns => Turns_Given (Item'Old, Wants_Downlink),
         Tally          => (Item'Old.Tally with delta
           Scrapped => Counted
             (Item'Old.Tally.Scrapped,
              not Confirmed and then Is_Scrapped (Item'Old))));

   --  A character brought this. The receiver has it already; where it makes
   --  no sense to the ground the receiver is back at the start.
   procedure Act_On (Item : in out Board; What : Event)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then not Is_Talking (Item)
       and then Item.State /= Idling
       and then Item.Silence = 0
       and then
         (if What.Kind in Command | Block_Begun
          then Item.Role = Ground or else Item.State /= Awaiting_Status)
       and then
         (if What.Kind = Lost_Step and then Item.Role = Ground
          then Item.Receiver.State = At_Start)
       and then
         (if What.Kind in Block_Good | Block_Bad
          then Item.Receiver.State = At_Start
            and then Item.State =
              (if Item.Role = Ground then Awaiting_Data else Ready))
       and then
         (if What.Kind = Block_Good
          then Item.Receive_Pair.Slots (Item.Receiver.Target).Full),
     Post   => Is_Sound (Item) and then Item = Informed (Item'Old, What);

   --  A ground that speaks of other things has given up our last block.
   function Is_Overtaken (Item : Board; What : Event) return Boolean is
     (Item.Role = Aircraft
      and then Item.State = Awaiting_Status
      and then What.Kind in Command | Block_Begun)
   with
     Ghost,
     Global => null;

   --  A board that has given its block up before it acts ends as one that
   --  gives it up then.
   procedure Prove_Same_End
     (Before, Middle : Board;
      What           : Event)
   with
     Ghost,
     Global => null,
     Pre    =>
       Middle = (Before with delta
         Receiver      => Middle.Receiver,
         Receive_Pair  => Middle.Receive_Pair,
         Transmit_Pair =>
           (if Is_Overtaken (Before, What)
            then Pair_Given_Up (Before) else Before.Transmit_Pair),
         State         =>
           (if Is_Overtaken (Before, What) then Ready else Before.State),
         Silence       => 0,
         Tally         => (Before.Tally with delta
           Scrapped => Counted
             (Before.Tally.Scrapped,
              Is_Overtaken (Before, What) and then Is_Scrapped (Before))))
       and then
         (if What.Kind = Block_Good
          then Middle.Receiver.Target = Before.Receiver.Target
            and then Middle.Receive_Pair.Slots
                       (Other (Before.Receiver.Target)).Full =
                     Before.Receive_Pair.Slots
                       (Other (Before.Receiver.Target)).Full),
     Post   => Informed (Middle, What) =
       (Informed (Before, What) with delta
          Receiver     => Middle.Receiver,
          Receive_Pair => Middle.Receive_Pair);

   --  It does not matter which of two equal events is acted upon.
   procedure Prove_Same_Event
     (Item        : Board;
      What, Other : Event)
   with
     Ghost,
     Global => null,
     Pre    => What = Other,
     Post   => Informed (Item, What) = Informed (Item, Other);

   --  Nothing that a character brings is put into a transmit buffer.
   procedure Prove_Nothing_Put (Item : Board; What : Event)
   with
     Ghost,
     Global => null,
     Post   =>
       (for all Which in Slot =>
          Informed (Item, What).Transmit_Pair.Slots (Which).Data =
            Item.Transmit_Pair.Slots (Which).Data
          and then
            (if Informed (Item, What).Transmit_Pair.Slots (Which).Full
             then Item.Transmit_Pair.Slots (Which).Full
               and then
                 Informed (Item, What).Transmit_Pair.Slots (Which).Attempts =
                   Item.Transmit_Pair.Slots (Which).Attempts));

   --  Begins to send the newest block and clears the other (LNK-7).
   procedure Begin_Block (Item : in out Board)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then Item.State = Ready
       and then Item.Owed = None
       and then Item.Receiver.State = At_Start
       and then Any_Full (Item.Transmit_Pair),
     Post   =>
       Is_Sound (Item)
       and then Item = (Item'Old with delta
         Transmit_Pair => Begun
           (Item'Old.Transmit_Pair, Newest_Full (Item'Old.Transmit_Pair)),
         Sender        =>
           (Source => Newest_Full (Item'Old.Transmit_Pair),
            Sent   => 0,
            Sum    => 0),
         State         => Sending,
         Tally         => (Item'Old.Tally with delta
           Sent    => Incremented (Item'Old.Tally.Sent),
           Cleared => Counted
             (Item'Old.Tally.Cleared, Both_Full (Item'Old.Transmit_Pair))));

   --  Sends the next character of the block on its way.
   procedure Continue_Block (Item : in out Board; Data : out Byte)
   with
     Global => null,
     Pre    => Is_Sound (Item) and then Item.State = Sending,
     Post   =>
       Is_Sound (Item)
       and then Data = Message_Byte
         (Item'Old.Transmit_Pair.Slots (Item'Old.Sender.Source).Data,
          Item.Transmit_Length,
          Item'Old.Sender.Sent + 1)
       and then Item = (Item'Old with delta
         Sender => Advanced
           (Item'Old.Sender,
            Item'Old.Transmit_Pair.Slots (Item'Old.Sender.Source).Data,
            Item.Transmit_Length),
         State  =>
           (if Item'Old.Sender.Sent + 1 = Message_Length (Item.Transmit_Length)
            then Awaiting_Status else Sending));

   procedure Count_One (Value : in out Count) is
   begin
      Value := Incremented (Value);
   end Count_One;

   procedure Refuse
     (Pair     : in out Buffer_Pair;
      Which    : Slot;
      Scrapped : in out Count)
   is
   begin
      Pair.Slots (Which).Busy := False;
      if Pair.Slots (Which).Attempts = Attempt_Count'Last then
         Pair.Slots (Which).Full := False;
         Pair.Slots (Which).Attempts := 0;
         Count_One (Scrapped);
      end if;
   end Refuse;

   procedure End_Attempt (Item : in out Board) is
   begin
      Refuse (Item.Transmit_Pair, Item.Sender.Source, Item.Tally.Scrapped);
      Item.State := Ready;
   end End_Attempt;

   procedure Reset (Item : in out Board) is
      Before : constant Board := Item with Ghost;
   begin
      if Item.Receiver.State = In_Data then
         Count_One (Item.Tally.Bad);
      end if;
      Restart (Item.Receiver, Item.Receive_Pair);

      if Item.State = Awaiting_Status then
         End_Attempt (Item);
      end if;
      pragma Assert (Is_Sound (Item));

      if Item.Role = Aircraft then
         Count_One (Item.Tally.Resets);
      elsif Item.State = Idling then
         Item.State := Ready;
      else
         Item.State := Idling;
         Count_One (Item.Tally.Resets);
      end if;
      Item.Silence := 0;

      pragma Assert (Item.Receiver = Reset_Board (Before).Receiver);
      pragma Assert (Item.Receive_Pair = Released (Before.Receive_Pair));
      pragma Assert (Item.Transmit_Pair = Pair_Given_Up (Before));
      pragma Assert (Item.Tally = Reset_Board (Before).Tally);
   end Reset;

   procedure Accept_Status
     (Item           : in out Board;
      Confirmed      : Boolean;
      Wants_Downlink : Boolean)
   is
      Source : constant Slot := Item.Sender.Source;
   begin
      if Confirmed then
         Item.Transmit_Pair.Slots (Source).Busy := False;
         Item.Transmit_Pair.Slots (Source).Full := False;
         Item.Transmit_Pair.Slots (Source).Attempts := 0;
         Item.State := Ready;
      else
         End_Attempt (Item);
      end if;

      if Item.Role = Ground then
         Item.Downlink_Turns :=
           (if Wants_Downlink then Turn_Count'Last else 0);
      end if;
   end Accept_Status;

   procedure Act_On (Item : in out Board; What : Event) is
      Before : constant Board := Item with Ghost;
   begin
      case What.Kind is
         when Nothing | Block_Begun =>
            null;

         when Lost_Step =>
            --  The aircraft waits for silence as it is; the ground leaves
            --  at once for its idle time.
            if Item.Role = Ground then
               Reset (Item);
            end if;

         when Command =>
            --  The ground needs no permission and disregards it (LNK-3).
            if Item.Role = Aircraft then
               Item.Clear_To_Send := True;
            end if;

         when Receivers.Status =>
            if Item.State = Awaiting_Status then
               Accept_Status (Item, What.Good, What.Wants_Downlink);
            end if;

         when Block_Good =>
            Item.State := Ready;
            Item.Owed := Good;
            Item.Downlink_Turns := 0;
            Count_One (Item.Messages);
            Count_One (Item.Tally.Received);
            if Both_Full (Item.Receive_Pair) then
               Count_One (Item.Tally.Not_Taken);
            end if;

         when Block_Bad =>
            Item.State := Ready;
            Item.Owed := Bad;
            Count_One (Item.Tally.Bad);
      end case;

      pragma Assert (Item.Receive_Pair = Before.Receive_Pair);
      pragma Assert
        (Item.Transmit_Pair = Informed (Before, What).Transmit_Pair);
      pragma Assert (Item.State = Informed (Before, What).State);
      pragma Assert (Item.Tally = Informed (Before, What).Tally);
   end Act_On;

   procedure Prove_Same_End
     (Before, Middle : Board;
      What           : Event)
   is
   begin
      pragma Assert
        (Informed (Middle, What).Transmit_Pair =
           Informed (Before, What).Transmit_Pair);
      pragma Assert
        (Informed (Middle, What).State = Informed (Before, What).State);
      if Is_Overtaken (Before, What) then
         pragma Assert (Is_Refusal (Before, What));
         pragma Assert (not Is_Refusal (Middle, What));
         pragma Assert
           (Informed (Middle, What).Tally.Scrapped = Middle.Tally.Scrapped);
      else
         pragma Assert (Is_Scrapped (Middle) = Is_Scrapped (Before));
         pragma Assert
           (Is_Refusal (Middle, What) = Is_Refusal (Before, What));
         pragma Assert (Middle.Tally.Scrapped = Before.Tally.Scrapped);
      end if;
      pragma Assert
        (Informed (Middle, What).Tally.Scrapped =
           Informed (Before, What).Tally.Scrapped);
      pragma Assert
        (Informed (Middle, What).Tally.Not_Taken =
           Informed (Before, What).Tally.Not_Taken);
      pragma Assert
        (Informed (Middle, What).Tally = Informed (Before, What).Tally);
   end Prove_Same_End;

   procedure Prove_Same_Event
     (Item        : Board;
      What, Other : Event)
   is null;

   procedure Prove_Nothing_Put (Item : Board; What : Event) is null;

   procedure Accept_Character
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
      Before  : constant Board := Item with Ghost;
      What    : constant Event := Heard (Before, Data, Parity_Error)
      with Ghost;
      Outcome : Event;
   begin
      if Is_Talking (Item) then
         return;
      end if;

      Item.Silence := 0;
      if Item.State = Idling then
         pragma Assert (Item = (Before with delta Silence => 0));
         return;
      end if;

      --  A ground that speaks of other things has given up our last block.
      if Item.Role = Aircraft
        and then Item.State = Awaiting_Status
        and then Item.Receiver.State = At_Start
        and then Meaning
          (Data, Parity_Error, Item.Receive_Length, Wants_Data => True).Kind
            in Command | Block_Begun
      then
         Refuse (Item.Transmit_Pair, Item.Sender.Source, Item.Tally.Scrapped);
         Item.State := Ready;
         pragma Assert (Is_Overtaken (Before, What));
         pragma Assert (Item.Transmit_Pair = Pair_Given_Up (Before));
      else
         pragma Assert (not Is_Overtaken (Before, What));
      end if;
      pragma Assert
        (Item.Tally = (Before.Tally with delta
           Scrapped => Counted
             (Before.Tally.Scrapped,
              Is_Overtaken (Before, What) and then Is_Scrapped (Before))));

      Accept_Character
        (Item         => Item.Receiver,
         Pair         => Item.Receive_Pair,
         Length       => Item.Receive_Length,
         Wants_Data   => Item.Role = Aircraft
                           or else Item.State = Awaiting_Data,
         Data         => Data,
         Parity_Error => Parity_Error,
         Outcome      => Outcome);

      pragma Assert (Outcome = What);
      pragma Assert
        (Item.Receiver = Receiver_After
           (Before.Receiver, Before.Receive_Pair,
            What.Kind, Data, Parity_Error));
      pragma Assert
        (if Outcome.Kind = Block_Good
         then not Parity_Error
           and then Before.Receiver.State = In_Data
           and then Before.Receiver.Received = Item.Receive_Length
           and then not Before.Receiver.Damaged
           and then Item.Receiver.Target = Before.Receiver.Target);
      pragma Assert
        (for all Which in Slot =>
           (if Item.Receive_Pair.Slots (Which).Full
              and then not Before.Receive_Pair.Slots (Which).Full
            then Outcome.Kind = Block_Good
              and then Which = Before.Receiver.Target
              and then Item.Receive_Pair.Newest = Which));
      pragma Assert
        (for all Which in Slot =>
           (if Before.Receive_Pair.Slots (Which).Full
              and then not Item.Receive_Pair.Slots (Which).Full
            then Outcome.Kind = Block_Begun
              and then Which = To_Fill (Before.Receive_Pair)));
      pragma Assert
        (if Outcome.Kind = Block_Begun
         then not Before.Receive_Pair.Slots (First).Busy
           and then not Before.Receive_Pair.Slots (Second).Busy);

      if Outcome.Kind = Lost_Step and then Item.Role = Ground then
         Item.Receiver.State := At_Start;
      end if;

      declare
         Middle : constant Board := Item with Ghost;
      begin
         Act_On (Item, Outcome);

         Prove_Same_Event (Middle, Outcome, What);
         Prove_Same_End (Before, Middle, What);
         pragma Assert
           (Middle.Receiver = Receiver_Informed
              (Before, What, Data, Parity_Error));
         pragma Assert
           (Middle.Receive_Pair = Pair_After
              (Before.Receiver, Before.Receive_Pair, What.Kind, Data));
         pragma Assert (Item = Informed (Middle, What));
         pragma Assert
           (Item = (Informed (Before, What) with delta
                      Receiver     => Middle.Receiver,
                      Receive_Pair => Middle.Receive_Pair));
         pragma Assert
           (Board_After (Before, What, Data, Parity_Error) =
              (Informed (Before, What) with delta
                 Receiver     => Middle.Receiver,
                 Receive_Pair => Middle.Receive_Pair));
         pragma Assert
           (Item = Board_After (Before, What, Data, Parity_Error));

         pragma Assert (Item.Receive_Pair = Middle.Receive_Pair);
         Checksum.Same_Bytes_Same_Sum
           (Data_Header (Item.Receive_Length),
            Middle.Receive_Pair.Slots (Item.Receiver.Target).Data,
            Item.Receive_Pair.Slots (Item.Receiver.Target).Data,
            Item.Receive_Length);
         pragma Assert
           (for all Which in Slot =>
              Item.Receive_Pair.Slots (Which).Full =
                Middle.Receive_Pair.Slots (Which).Full);
      end;
      Prove_Nothing_Put (Before, What);
   end Accept_Character;

   procedure Begin_Block (Item : in out Board) is
      Source : constant Slot := Newest_Full (Item.Transmit_Pair);
   begin
      if Item.Transmit_Pair.Slots (Other (Source)).Full then
         Item.Transmit_Pair.Slots (Other (Source)).Full := False;
         Item.Transmit_Pair.Slots (Other (Source)).Attempts := 0;
         Count_One (Item.Tally.Cleared);
      end if;
      Item.Transmit_Pair.Slots (Source).Busy := True;
      Item.Transmit_Pair.Slots (Source).Attempts :=
        Item.Transmit_Pair.Slots (Source).Attempts + 1;
      Item.Sender := (Source => Source, Sent => 0, Sum => 0);
      Item.State := Sending;
      Count_One (Item.Tally.Sent);
   end Begin_Block;

   procedure Continue_Block (Item : in out Board; Data : out Byte) is
   begin
      Send_Next
        (Item.Sender,
         Item.Transmit_Pair.Slots (Item.Sender.Source).Data,
         Item.Transmit_Length,
         Data);
      if Item.Sender.Sent = Message_Length (Item.Transmit_Length) then
         Item.State := Awaiting_Status;
      end if;
   end Continue_Block;

   procedure Next_Character
     (Item : in out Board;
      Send : out Boolean;
      Data : out Byte)
   is
      Before : constant Board := Item with Ghost;
   begin
      --  Dead space begins when our last character has left.
      if Item.Line_Taken then
         Item.Silence := 0;
      end if;

      Send := False;
      Data := 0;

      if Item.Owed /= None then
         Data := Encode
           ((Kind           => Headers.Status,
             Good           => Item.Owed = Good,
             Wants_Downlink => Item.Role = Aircraft
                                 and then Any_Full (Item.Transmit_Pair)));
         Send := True;
         Item.Owed := None;

      elsif Item.State = Ready and then Item.Receiver.State = At_Start then
         if (Item.Role = Ground or else Item.Clear_To_Send)
           and then Any_Full (Item.Transmit_Pair)
         then
            Begin_Block (Item);
         elsif Item.Downlink_Turns > 0 then
            Data := Encode ((Kind => Command_To_Downlink));
            Send := True;
            Item.Downlink_Turns := Item.Downlink_Turns - 1;
            Item.State := Awaiting_Data;
         end if;
         Item.Clear_To_Send := False;
      end if;

      if Item.State = Sending then
         Continue_Block (Item, Data);
         Send := True;
         pragma Assert
           (if May_Begin_Block (Before)
            then Data = Data_Header (Item.Transmit_Length));
         pragma Assert
           (if May_Begin_Block (Before)
            then Item.Sender =
              (Source => Newest_Full (Before.Transmit_Pair),
               Sent   => 1,
               Sum    => Checksum.Next (Checksum.First_Value, Data)));
         pragma Assert
           (if May_Begin_Block (Before) then Item.State = Sending);
      end if;

      Item.Line_Taken := Send;
   end Next_Character;

   procedure Elapse (Item : in out Board; Time : Character_Times) is
   begin
      if Is_Talking (Item) or else not Is_Waiting (Item) then
         return;
      end if;

      if Time >= Patience (Item)
        or else Item.Silence >= Patience (Item) - Time
      then
         Reset (Item);
      else
         Item.Silence := Item.Silence + Time;
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
      Take (Item.Receive_Pair, Data, Fresh);
      Checksum.Same_Bytes_Same_Sum
        (Data_Header (Item.Receive_Length),
         Before.Slots (Item.Receiver.Target).Data,
         Item.Receive_Pair.Slots (Item.Receiver.Target).Data,
         Item.Receiver.Received);
      Ever_Received := Item.Messages > 0;
   end Take;

   procedure Put
     (Item      : in out Board;
      Data      : Block_Data;
      Overwrote : out Boolean)
   is
      Before : constant Buffer_Pair := Item.Transmit_Pair with Ghost;
   begin
      Put (Item.Transmit_Pair, Data, Overwrote);
      if Item.State = Sending and then Item.Sender.Sent > 0 then
         Checksum.Same_Bytes_Same_Sum
           (Data_Header (Item.Transmit_Length),
            Before.Slots (Item.Sender.Source).Data,
            Item.Transmit_Pair.Slots (Item.Sender.Source).Data,
            Byte_Count (Item.Sender.Sent - 1));
      end if;
      pragma Assert
        (if Item.State in Sending | Awaiting_Status
         then Item.Transmit_Pair.Newest /= Item.Sender.Source);
      pragma Assert
        (if Item.State in Sending | Awaiting_Status
         then Item.Transmit_Pair.Slots (Item.Sender.Source) =
           Before.Slots (Item.Sender.Source));
      pragma Assert
        (for all Which in Slot =>
           (if Item.State in Sending | Awaiting_Status
              and then Which = Item.Sender.Source
            then Item.Transmit_Pair.Slots (Which).Busy
              and then Item.Transmit_Pair.Slots (Which).Full
              and then Item.Transmit_Pair.Slots (Which).Attempts > 0
            else not Item.Transmit_Pair.Slots (Which).Busy
              and then Item.Transmit_Pair.Slots (Which).Attempts < 2));
   end Put;

   procedure Clear_Transmit_Half (Item : in out Board) is
   begin
      if Item.State in Sending | Awaiting_Status then
         Item.State := (if Item.Role = Ground then Idling else Ready);
         Item.Silence := 0;
      end if;
      Item.Transmit_Pair := Empty_Pair;
   end Clear_Transmit_Half;

   procedure Start (Item : in out Board) is
   begin
      if Item.State in Sending | Awaiting_Status then
         End_Attempt (Item);
      end if;
      Item.Receive_Pair := Empty_Pair;
      Item.Receiver := (others => <>);
      Item.State := (if Item.Role = Ground then Idling else Ready);
      Item.Owed := None;
      Item.Line_Taken := False;
      Item.Silence := 0;
      Item.Downlink_Turns := 0;
      Item.Clear_To_Send := False;
      Item.Messages := 0;
   end Start;

end Telemetry.Boards;
