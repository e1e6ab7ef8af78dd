with URVOS.Task_Trees; use URVOS.Task_Trees;

package body Theorems.Results with SPARK_Mode is

   procedure Of_Move
     (Row      : Arrangement;
      From, To : Arrangements.Place;
      Same     : out Boolean)
   is
      One, Other : Arrangement := Row;
   begin
      Move (One, From, To);
      Move (Other, From, To);
      Same :=
        (for all Which in TCB_Number =>
           Place_Of (One, Which) = Place_Of (Other, Which))
        and then (for all Where in Arrangements.Place =>
             TCB_At (One, Where) = TCB_At (Other, Where));
   end Of_Move;

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
      Item : Word;
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
      Item, Its_Like : Word;
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

   procedure Of_Receive
     (Box  : Mailbox;
      Same : out Boolean)
   is
      One, Other     : Mailbox := Box;
      Item, Its_Like : Word;
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

   procedure Of_Take_Byte
     (Item : Check;
      Data : Byte;
      Same : out Boolean)
   is
      One, Other        : Check := Item;
      Outcome, Its_Like : Outcome_Kind;
   begin
      Take_Byte (One, Data, Outcome);
      Take_Byte (Other, Data, Its_Like);
      Same :=
        One = Other
        and then Outcome = Its_Like;
   end Of_Take_Byte;

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

   procedure Of_Take
     (Pair : Buffer_Pair;
      Same : out Boolean)
   is
      One, Other     : Buffer_Pair := Pair;
      Data, Its_Like : Block_Data;
      Fresh, As_Well : Boolean;
   begin
      Take (One, Data, Fresh);
      Take (Other, Its_Like, As_Well);
      Same :=
        One = Other
        and then Data = Its_Like
        and then Fresh = As_Well;
   end Of_Take;

   procedure Of_Put
     (Pair : Buffer_Pair;
      Data : Block_Data;
      Same : out Boolean)
   is
      One, Other         : Buffer_Pair := Pair;
      Overwrote, As_Well : Boolean;
   begin
      Put (One, Data, Overwrote);
      Put (Other, Data, As_Well);
      Same :=
        One = Other
        and then Overwrote = As_Well;
   end Of_Put;

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

end Theorems.Results;
