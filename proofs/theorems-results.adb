--  SPDX-License-Identifier: Apache-2.0

with Telemetry.Turns; use Telemetry.Turns;

with URVOS.Task_Trees; use URVOS.Task_Trees;

package body Theorems.Results with SPARK_Mode is

   procedure Of_Add
     (Log       : Error_Log;
      Which     : Kind;
      Now       : Clock_Tick;
      Detail    : Word;
      How_Often : Positive_Count;
      Same      : out Boolean)
   is
      One, Other : Error_Log := Log;
   begin
      Add (One, Which, Now, Detail, How_Often);
      Add (Other, Which, Now, Detail, How_Often);
      Same :=
        (for all Each in Kind =>
           History_Of (One, Each) = History_Of (Other, Each))
        and then Total (One) = Total (Other)
        and then Latest (One) = Latest (Other);
   end Of_Add;

   procedure Of_Send
     (Box  : Mailbox;
      Item : Channel_Words;
      Same : out Boolean)
   is
      One, Other       : Mailbox := Box;
      Success, As_Well : Boolean;
   begin
      Send (One, Item, Success);
      Send (Other, Item, As_Well);
      Same :=
        Contents (One) = Contents (Other)
        and then Produced (One) = Produced (Other)
        and then Consumed (One) = Consumed (Other)
        and then Misses (One) = Misses (Other)
        and then Success = As_Well;
   end Of_Send;

   procedure Of_Look
     (Box  : Mailbox;
      Same : out Boolean)
   is
      One, Other     : Mailbox := Box;
      Item, Its_Like : Channel_Words;
      Fresh, As_Well : Boolean;
   begin
      Look (One, Item, Fresh);
      Look (Other, Its_Like, As_Well);
      Same :=
        Contents (One) = Contents (Other)
        and then Produced (One) = Produced (Other)
        and then Consumed (One) = Consumed (Other)
        and then Misses (One) = Misses (Other)
        and then Item = Its_Like
        and then Fresh = As_Well;
   end Of_Look;

   procedure Of_Look
     (State : Node_State;
      Who   : Seat;
      Same  : out Boolean)
   is
      One, Other     : Node_State := State;
      Item, Its_Like : Order;
   begin
      Look (One, Who, Item);
      Look (Other, Who, Its_Like);
      Same := One = Other and then Item = Its_Like;
   end Of_Look;

   procedure Of_Receive
     (Box  : Mailbox;
      Same : out Boolean)
   is
      One, Other     : Mailbox := Box;
      Item, Its_Like : Channel_Words;
      Fresh, As_Well : Boolean;
   begin
      Receive (One, Item, Fresh);
      Receive (Other, Its_Like, As_Well);
      Same :=
        Contents (One) = Contents (Other)
        and then Produced (One) = Produced (Other)
        and then Consumed (One) = Consumed (Other)
        and then Misses (One) = Misses (Other)
        and then Item = Its_Like
        and then Fresh = As_Well;
   end Of_Receive;

   procedure Of_Take_Long
     (Item : Check;
      Data : URVOS.Memories.Long;
      Same : out Boolean)
   is
      One, Other        : Check := Item;
      Outcome, Its_Like : Outcome_Kind;
   begin
      Take_Long (One, Data, Outcome);
      Take_Long (Other, Data, Its_Like);
      Same :=
        One = Other
        and then Outcome = Its_Like;
   end Of_Take_Long;

   procedure Of_Try_Claim
     (Item   : Semaphore;
      Caller : Claimant;
      Same   : out Boolean)
   is
      One, Other       : Semaphore := Item;
      Claimed, As_Well : Boolean;
      Holder, Its_Like : Claimant;
   begin
      Try_Claim (One, Caller, Claimed, Holder);
      Try_Claim (Other, Caller, As_Well, Its_Like);
      Same :=
        Owner (One) = Owner (Other)
        and then Claimed = As_Well
        and then Holder = Its_Like;
   end Of_Try_Claim;

   procedure Of_Release
     (Item   : Semaphore;
      Caller : Claimant;
      Same   : out Boolean)
   is
      One, Other        : Semaphore := Item;
      Released, As_Well : Boolean;
      Holder, Its_Like  : Task_Id;
   begin
      Release (One, Caller, Released, Holder);
      Release (Other, Caller, As_Well, Its_Like);
      Same :=
        Owner (One) = Owner (Other)
        and then Released = As_Well
        and then Holder = Its_Like;
   end Of_Release;

   procedure Of_Note_Look
     (Item : Wait;
      Now  : Clock_Tick;
      Same : out Boolean)
   is
      One, Other : Wait := Item;
   begin
      Note_Look (One, Now);
      Note_Look (Other, Now);
      Same :=
        Ticks_Left (One) = Ticks_Left (Other)
        and then Last_Seen (One) = Last_Seen (Other)
        and then Looks (One) = Looks (Other);
   end Of_Note_Look;

   procedure Of_Store_Byte
     (Item         : Receiver;
      Pair         : Buffer_Pair;
      Length       : Block_Length;
      Data         : Byte;
      Parity_Error : Boolean;
      Same         : out Boolean)
   is
      One, Other        : Receiver := Item;
      One_Pair, As_Well : Buffer_Pair := Pair;
   begin
      Store_Byte (One, One_Pair, Length, Data, Parity_Error);
      Store_Byte (Other, As_Well, Length, Data, Parity_Error);
      Same := One = Other and then One_Pair = As_Well;
   end Of_Store_Byte;

   procedure Of_Accept_Character
     (Item         : Receiver;
      Pair         : Buffer_Pair;
      Length       : Block_Length;
      Wants_Data   : Boolean;
      Data         : Byte;
      Parity_Error : Boolean;
      Same         : out Boolean)
   is
      One, Other        : Receiver := Item;
      One_Pair, As_Well : Buffer_Pair := Pair;
      Outcome, Its_Like : Event;
   begin
      Accept_Character
        (One, One_Pair, Length, Wants_Data, Data, Parity_Error, Outcome);
      Accept_Character
        (Other, As_Well, Length, Wants_Data, Data, Parity_Error, Its_Like);
      Same :=
        One = Other
        and then One_Pair = As_Well
        and then Outcome = Its_Like;
   end Of_Accept_Character;

   --  Two pairs equal to a third are equal.
   procedure Prove_Same_Pair (One, Other, What : Buffer_Pair)
   with
     Global => null,
     Pre    => One = What and then Other = What,
     Post   => One = Other;

   --  Boards with equal pairs are equal except for their control.
   procedure Prove_Same_Pairs
     (One, Other     : Board;
      Received, Sent : Buffer_Pair)
   with
     Global => null,
     Pre    =>
       Receive_Pair (One) = Received
       and then Receive_Pair (Other) = Received
       and then Transmit_Pair (One) = Sent
       and then Transmit_Pair (Other) = Sent,
     Post   =>
       Receive_Pair (One) = Receive_Pair (Other)
       and then Transmit_Pair (One) = Transmit_Pair (Other);

   procedure Prove_Same_Pair (One, Other, What : Buffer_Pair) is null;

   procedure Prove_Same_Pairs
     (One, Other     : Board;
      Received, Sent : Buffer_Pair)
   is
   begin
      Prove_Same_Pair (Receive_Pair (One), Receive_Pair (Other), Received);
      Prove_Same_Pair (Transmit_Pair (One), Transmit_Pair (Other), Sent);
   end Prove_Same_Pairs;

   --  Boards with equal parts are equal.
   procedure Prove_Same_Board (One, Other : Board)
   with
     Global => null,
     Pre    =>
       Control_Of (One) = Control_Of (Other)
       and then Receive_Pair (One) = Receive_Pair (Other)
       and then Transmit_Pair (One) = Transmit_Pair (Other),
     Post   => One = Other;

   procedure Prove_Same_Judged
     (Item       : Control;
      One, Other : Buffer_Pair)
   with
     Global => null,
     Pre    => One = Other,
     Post   => Judged (Item, One) = Judged (Item, Other);

   procedure Prove_Same_Said
     (Item       : Control;
      One, Other : Buffer_Pair)
   with
     Global => null,
     Pre    =>
       One = Other
       and then Fits (Item, One)
       and then Fits (Item, Other),
     Post   =>
       Output (Item, One) = Output (Item, Other)
       and then Spoken (Item, One) = Spoken (Item, Other);

   procedure Prove_Same_Board (One, Other : Board) is null;

   procedure Prove_Same_Judged
     (Item       : Control;
      One, Other : Buffer_Pair)
   is
      pragma Unreferenced (Item);
   begin
      pragma Assert (Both_Full (One) = Both_Full (Other));
   end Prove_Same_Judged;

   procedure Prove_Same_Said
     (Item       : Control;
      One, Other : Buffer_Pair)
   is
   begin
      pragma Assert (Any_Full (One) = Any_Full (Other));
      pragma Assert
        (One.Slots (Item.Sender.Source).Data =
           Other.Slots (Item.Sender.Source).Data);
   end Prove_Same_Said;

   procedure Of_Accept_Character
     (Item         : Board;
      Data         : Byte;
      Parity_Error : Boolean;
      Same         : out Boolean)
   is
      Was        : constant Control := Control_Of (Item);
      What       : constant Event   := Heard (Item, Data, Parity_Error);
      One, Other : Board := Item;
   begin
      Accept_Character (One, Data, Parity_Error);
      Accept_Character (Other, Data, Parity_Error);
      if Is_Listening (Was) then
         Prove_Same_Pairs
           (One, Other,
            (if Is_Stored (Was.Receiver, What.Kind)
             then Pair_With_Byte (Was.Receiver, Receive_Pair (Item), Data)
             else Pair_After (Receive_Pair (Item), What.Kind)),
            Settled
              (Transmit_Pair (Item), Was.Sender.Source,
               Delivery_After (Was, What)));
      else
         Prove_Same_Pairs
           (One, Other, Receive_Pair (Item), Transmit_Pair (Item));
      end if;
      Prove_Same_Board (One, Other);
      Same := One = Other;
   end Of_Accept_Character;

   procedure Of_Next_Character
     (Item : Board;
      Same : out Boolean)
   is
      One, Other     : Board := Item;
      Send, As_Well  : Boolean;
      Data, Its_Like : Byte;
   begin
      Next_Character (One, Send, Data);
      Next_Character (Other, As_Well, Its_Like);
      Prove_Same_Pairs
        (One, Other, Receive_Pair (Item),
         (if May_Begin_Block (Control_Of (Item), Transmit_Pair (Item))
          then Begun
            (Transmit_Pair (Item), Newest_Full (Transmit_Pair (Item)))
          else Transmit_Pair (Item)));
      Prove_Same_Said
        (Prepared (Control_Of (Item), Transmit_Pair (Item)),
         Transmit_Pair (One), Transmit_Pair (Other));
      Prove_Same_Board (One, Other);
      pragma Assert (Data = Its_Like);
      pragma Assert (Send = As_Well);
      Same :=
        One = Other
        and then Send = As_Well
        and then Data = Its_Like;
   end Of_Next_Character;

   procedure Of_Elapse
     (Item : Board;
      Time : Character_Times;
      Same : out Boolean)
   is
      Was        : constant Control := Control_Of (Item);
      One, Other : Board := Item;
   begin
      Elapse (One, Time);
      Elapse (Other, Time);
      if Is_Judged_After (Was, Time) then
         Prove_Same_Pairs
           (One, Other, Pair_Judged (Was.Receiver, Receive_Pair (Item)),
            Transmit_Pair (Item));
         Prove_Same_Judged
           (Was, Receive_Pair (One), Receive_Pair (Other));
      elsif Is_Reset_After (Was, Time) then
         Prove_Same_Pairs
           (One, Other, Released (Receive_Pair (Item)),
            Settled
              (Transmit_Pair (Item), Was.Sender.Source,
               Delivery_In_Reset (Was)));
      else
         Prove_Same_Pairs
           (One, Other, Receive_Pair (Item), Transmit_Pair (Item));
      end if;
      Prove_Same_Board (One, Other);
      Same := One = Other;
   end Of_Elapse;

   procedure Of_Take
     (Item : Board;
      Same : out Boolean)
   is
      One, Other            : Board := Item;
      Data, Its_Like        : Block_Data;
      Fresh, As_Well        : Boolean;
      Received, As_Received : Boolean;
   begin
      Take (One, Data, Fresh, Received);
      Take (Other, Its_Like, As_Well, As_Received);
      Prove_Same_Pairs
        (One, Other, Taken (Receive_Pair (Item)), Transmit_Pair (Item));
      Same :=
        One = Other
        and then Data = Its_Like
        and then Fresh = As_Well
        and then Received = As_Received;
   end Of_Take;

   procedure Of_Put
     (Item : Board;
      Data : Block_Data;
      Same : out Boolean)
   is
      One, Other         : Board := Item;
      Overwrote, As_Well : Boolean;
   begin
      Put (One, Data, Overwrote);
      Put (Other, Data, As_Well);
      Prove_Same_Pairs
        (One, Other, Receive_Pair (Item),
         Filled (Transmit_Pair (Item), Data));
      Same :=
        One = Other
        and then Overwrote = As_Well;
   end Of_Put;

   procedure Of_Clear_Transmit_Half
     (Item : Board;
      Same : out Boolean)
   is
      One, Other : Board := Item;
   begin
      Clear_Transmit_Half (One);
      Clear_Transmit_Half (Other);
      Prove_Same_Pairs (One, Other, Receive_Pair (Item), Empty_Pair);
      Same := One = Other;
   end Of_Clear_Transmit_Half;

   procedure Of_Set_Round_Trip
     (Item : Board;
      Time : Round_Trip_Time;
      Same : out Boolean)
   is
      One, Other : Board := Item;
   begin
      Set_Round_Trip (One, Time);
      Set_Round_Trip (Other, Time);
      Prove_Same_Pairs
        (One, Other, Receive_Pair (Item), Transmit_Pair (Item));
      Prove_Same_Board (One, Other);
      Same := One = Other;
   end Of_Set_Round_Trip;

   procedure Of_Start
     (Item : Board;
      Same : out Boolean)
   is
      One, Other : Board := Item;
   begin
      Start (One);
      Start (Other);
      Prove_Same_Pairs
        (One, Other, Empty_Pair,
         Settled
           (Transmit_Pair (Item), Control_Of (Item).Sender.Source,
            Delivery_In_Reset (Control_Of (Item))));
      Same := One = Other;
   end Of_Start;

   procedure Of_Store
     (Item  : Scan;
      Value : Word;
      Same  : out Boolean)
   is
      One, Other     : Scan := Item;
      Next, Its_Like : Next_Step;
   begin
      Store (One, Value, Next);
      Store (Other, Value, Its_Like);
      Same :=
        One = Other
        and then Next = Its_Like;
   end Of_Store;

   procedure Of_Take
     (Item : URV.Log_Pieces.Receiver;
      What : URV.Log_Pieces.Piece;
      Same : out Boolean)
   is
      use type URV.Log_Pieces.Receiver;

      One, Other        : URV.Log_Pieces.Receiver := Item;
      Complete, As_Well : Boolean;
   begin
      URV.Log_Pieces.Take (One, What, Complete);
      URV.Log_Pieces.Take (Other, What, As_Well);
      Same :=
        One = Other
        and then Complete = As_Well;
   end Of_Take;

end Theorems.Results;
