--  SPDX-License-Identifier: Apache-2.0

with Ada.Containers.Hashed_Maps;
with Ada.Containers.Vectors;
with Interfaces;          use Interfaces;
with Telemetry.Memory;    use Telemetry.Memory;
with Telemetry.Receivers; use Telemetry.Receivers;
with Telemetry.Senders;   use Telemetry.Senders;

package body Telemetry.Boards.Sides is

   pragma Suppress (Tampering_Check);

      Fresh_Board : constant Board := New_Board (Role, Length, Length);

   --  A number that tells boards apart that differ in more than counts and
   --  data nobody reads.
   type Key is new Unsigned_64;

   function Hash (Value : Key) return Ada.Containers.Hash_Type is
     (Ada.Containers.Hash_Type'Mod
        (Shift_Right (Value * 16#9E37_79B9_7F4A_7C15#, 32)));

   type Board_Number is new Natural;

   --  A followed block is marked behind its data, where nobody looks.
   Mark_Place : constant Byte_Index := 2;
   Mark       : constant Byte := 1;

   type Way is record
      To     : Board_Number;
      Output : Symbol;
   end record;

   package Board_Vectors is new Ada.Containers.Vectors (Natural, Board);
   package Way_Vectors is new Ada.Containers.Vectors (Natural, Way);
   package Outcome_Vectors is new Ada.Containers.Vectors (Positive, Outcome);
   package Number_Vectors is new Ada.Containers.Vectors
     (Natural, Integer);
   package Key_Maps is new Ada.Containers.Hashed_Maps
     (Key, Natural, Hash, "=");

   Boards_List : Board_Vectors.Vector;
   Boards_Map  : Key_Maps.Map;
   Sides_List  : Way_Vectors.Vector;
   Sides_Map   : Key_Maps.Map;
   Calls       : Natural := 0;

   --  Outcomes by side, character heard and act: where they begin, and in
   --  Ends where they end; 0 for those not yet found.
   All_Outcomes : Outcome_Vectors.Vector;
   Symbols_Used : constant := 40;
   Begins, Ends : Number_Vectors.Vector;

   type Symbol_Place is range 0 .. Symbols_Used - 1;
   Places       : array (Symbol) of Symbol_Place := (others => 0);

   Other_Sum : constant Byte := Unlike_All;
   Contents  : array (Byte) of Boolean;
   Sums_Kept : array (Byte) of Boolean;
   Bytes_Of  : array (Byte) of Byte;

   function Normal (Item : Board) return Board;
   function Key_Of (Item : Board) return Key;
   function Number_Of (Item : Board) return Board_Number;
   function Side_Of (Item : Way) return Side;
   function With_Block (Item : Board; Fresh : Boolean) return Board;
   procedure Hear
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean);

   --  A unit of the board's timer. Good tells that a message was taken.
   procedure Let_Pass (Item : in out Board; Good : out Boolean);

   --  The next character for one choice of the block's content.
   procedure Poll
     (Item    : in out Board;
      Content : Byte;
      Output  : out Symbol);

   --  The content of the block is not yet read, and the next poll does.
   function Content_Is_Open (Item : Board) return Boolean is
     (Item.Control.State = Sending and then Item.Control.Sender.Sent = 1);

   function Is_On_Its_Way (Item : Board) return Boolean is
     (Item.Control.State in Sending | Awaiting_Status);

   function Normal (Item : Board) return Board is
      Result : Board := Item;
      Source : constant Slot :=
        (if Is_On_Its_Way (Item) then Item.Control.Sender.Source
         elsif Any_Full (Item.Transmit_Pair)
         then Newest_Full (Item.Transmit_Pair)
         else First);
      Sum    : Byte;

      --  A buffer without what nobody reads.
      function Bare (Which : Slot; Keep : Boolean) return Buffer;

      function Bare (Which : Slot; Keep : Boolean) return Buffer is
         From : Buffer renames Item.Transmit_Pair.Slots (Which);
      begin
         return Bared : Buffer do
            if From.Full then
               Bared.Full := True;
               Bared.Busy := From.Busy;
               Bared.Attempts := From.Attempts;
               Bared.Data (Mark_Place) := From.Data (Mark_Place);
               if Keep then
                  Bared.Data (1) := From.Data (1);
               end if;
            end if;
         end return;
      end Bare;
   begin
      Result.Control.Messages := 0;
      Result.Control.Tally := (others => 0);
      if not Is_Waiting (Item.Control) then
         Result.Control.Silence := 0;
      end if;

      --  The controller has taken what came.
      Result.Receive_Pair := (Newest => Second, others => <>);
      Result.Control.Receiver :=
        (State => Item.Control.Receiver.State, others => <>);
      if Has_Message (Item.Control.Receiver) then
         Result.Receive_Pair.Slots (First).Busy := True;
         Result.Control.Receiver.Received := Item.Control.Receiver.Received;
         Result.Control.Receiver.Damaged := Item.Control.Receiver.Damaged;
         Sum := Item.Control.Receiver.Sum;
         if Item.Control.Receiver.Received = 1 then
            if Item.Control.Receiver.State = At_End
              or else Item.Control.Receiver.Damaged
              or else not Sums_Kept (Sum)
            then
               Sum := Other_Sum;
            end if;
            Result.Receive_Pair.Slots (First).Data (1) := Bytes_Of (Sum);
         end if;
         Result.Control.Receiver.Sum := Sum;
      end if;

      --  The block on its way, or the newest, first.
      Result.Transmit_Pair := Empty_Pair;
      Result.Transmit_Pair.Slots (First) :=
        Bare
          (Source,
           Item.Control.State = Sending and then Item.Control.Sender.Sent = 2);
      if Is_On_Its_Way (Item) then
         Result.Transmit_Pair.Slots (Second) := Bare (Other (Source), False);
         if Result.Transmit_Pair.Slots (Second).Full then
            Result.Transmit_Pair.Newest := Second;
         end if;
      end if;
      Result.Control.Sender := (others => <>);
      if Item.Control.State = Sending then
         Result.Control.Sender.Sent := Item.Control.Sender.Sent;
         Result.Control.Sender.Sum := Item.Control.Sender.Sum;
      end if;
      return Result;
   end Normal;

   function Key_Of (Item : Board) return Key is
      Result : Key := 0;

      procedure Add (Value : Natural; Values : Natural);

      procedure Add (Value : Natural; Values : Natural) is
      begin
         Result := Result * Key (Values) + Key (Value);
      end Add;
   begin
      Add (Turn'Pos (Item.Control.State), 5);
      Add (Reply'Pos (Item.Control.Owed), 3);
      Add (Boolean'Pos (Item.Control.Line_Taken), 2);
      Add (Natural (Item.Control.Silence), 128);
      Add (Natural (Item.Control.Downlink_Turns), 3);
      Add (Boolean'Pos (Item.Control.Clear_To_Send), 2);
      Add (Receiver_State'Pos (Item.Control.Receiver.State), 4);
      Add (Natural (Item.Control.Receiver.Received), 2);
      Add (Boolean'Pos (Item.Control.Receiver.Damaged), 2);
      Add
        ((if Has_Message (Item.Control.Receiver)
          then Natural (Item.Control.Receiver.Sum) else 0),
         256);
      Add (Slot'Pos (Item.Control.Receiver.Target), 2);
      Add (Slot'Pos (Item.Receive_Pair.Newest), 2);
      Add (Slot'Pos (Item.Transmit_Pair.Newest), 2);
      Add (Slot'Pos (Item.Control.Sender.Source), 2);
      Add
        ((if Item.Control.State = Sending
          then Natural (Item.Control.Sender.Sent) else 0),
         3);
      Add
        ((if Item.Control.State = Sending and then Item.Control.Sender.Sent = 2
          then Natural (Item.Control.Sender.Sum) else 0),
         256);
      for Which in Slot loop
         Add (Boolean'Pos (Item.Receive_Pair.Slots (Which).Full), 2);
         declare
            From : Buffer renames Item.Transmit_Pair.Slots (Which);
         begin
            Add (Boolean'Pos (From.Full), 2);
            Add (Natural (From.Attempts), 3);
            Add
              ((if From.Full then Natural (From.Data (Mark_Place)) else 0),
               2);
         end;
      end loop;
      return Result;
   end Key_Of;

   function Number_Of (Item : Board) return Board_Number is
      Reduced  : constant Board := Normal (Item);
      Position : Key_Maps.Cursor;
      Is_New   : Boolean;
   begin
      Boards_Map.Insert
        (Key_Of (Reduced), Natural (Boards_List.Length), Position, Is_New);
      if Is_New then
         if not Is_Sound (Reduced) then
            raise Program_Error with "a board does not hold together";
         end if;
         Boards_List.Append (Reduced);
      end if;
      return Board_Number (Key_Maps.Element (Position));
   end Number_Of;

   function Side_Of (Item : Way) return Side is
      Position : Key_Maps.Cursor;
      Is_New   : Boolean;
   begin
      Sides_Map.Insert
        (Key (Item.To) * 512 + Key (Item.Output),
         Natural (Sides_List.Length), Position, Is_New);
      if Is_New then
         Sides_List.Append (Item);
         for Index in 1 .. Symbols_Used * 4 loop
            Begins.Append (0);
            Ends.Append (0);
         end loop;
      end if;
      return Side (Key_Maps.Element (Position));
   end Side_Of;

   function With_Block (Item : Board; Fresh : Boolean) return Board
   is
      Result    : Board := Item;
      Overwrote : Boolean;
   begin
      Calls := Calls + 1;
      Put
        (Result,
         (Mark_Place => (if Fresh then Mark else 0), others => 0),
         Overwrote);
      return Result;
   end With_Block;

   procedure Hear
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
   begin
      Calls := Calls + 1;
      Accept_Character (Item, Data, Parity_Error);
   end Hear;

   procedure Let_Pass (Item : in out Board; Good : out Boolean) is
      Before : constant Count := Item.Control.Messages;
   begin
      Calls := Calls + 1;
      Elapse (Item, 1);
      Good := Item.Control.Messages > Before;
   end Let_Pass;

   procedure Poll
     (Item    : in out Board;
      Content : Byte;
      Output  : out Symbol)
   is
      Send : Boolean;
      Data : Byte;
   begin
      Calls := Calls + 1;
      if Content_Is_Open (Item) then
         Item.Transmit_Pair.Slots (Item.Control.Sender.Source).Data (1) :=
           Content;
      end if;
      Next_Character (Item, Send, Data);
      Output := (if Send then To_Symbol (Data) else Silence);
      if Send and then not Sums_Kept (Data) then
         raise Program_Error with "a character sent is not in the list";
      end if;
   end Poll;

   procedure Explore_Alone is
      Next   : Natural := 0;
      Ignore : Board_Number;
      Unused : Side;
      Output : Symbol;
      Result : Board := Fresh_Board;
   begin
      Ignore := Number_Of (Result);
      while Next < Natural (Boards_List.Length) loop
         declare
            Here : constant Board := Boards_List (Next);
         begin
            Result := Here;
            Elapse (Result, 1);
            Ignore := Number_Of (Result);

            Result := Here;
            Elapse (Result, Character_Times'Last);
            Ignore := Number_Of (Result);

            Ignore := Number_Of (With_Block (Here, False));

            Result := Here;
            Start (Result);
            Ignore := Number_Of (Result);

            Result := Here;
            Clear_Transmit_Half (Result);
            Ignore := Number_Of (Result);

            for Data in Byte loop
               for Parity_Error in Boolean loop
                  Result := Here;
                  Hear (Result, Data, Parity_Error);
                  Ignore := Number_Of (Result);
               end loop;
            end loop;

            for Content in Byte loop
               if Contents (Content)
                 and then (Content = 0 or else Content_Is_Open (Here))
               then
                  Result := Here;
                  Poll (Result, Content, Output);
                  --  The character may be lost.
                  Unused := Side_Of ((Number_Of (Result), Output));
                  Unused := Side_Of ((Number_Of (Result), Silence));
               end if;
            end loop;
         end;
         Next := Next + 1;
      end loop;

      --  While its character is on the line, other things happen.
      Next := 0;
      while Next < Natural (Sides_List.Length) loop
         declare
            Here : constant Way := Sides_List (Next);
            From : constant Board := Boards_List (Natural (Here.To));
         begin
            if Here.Output /= Silence then
               Result := From;
               Elapse (Result, 1);
               Unused := Side_Of ((Number_Of (Result), Here.Output));
               Unused := Side_Of
                 ((Number_Of (With_Block (From, False)), Here.Output));
               Result := From;
               Clear_Transmit_Half (Result);
               Unused := Side_Of ((Number_Of (Result), Here.Output));
               Result := From;
               Start (Result);
               Unused := Side_Of ((Number_Of (Result), Here.Output));
            end if;
         end;
         Next := Next + 1;
      end loop;
   end Explore_Alone;

   function Boards_Found return Natural is (Natural (Boards_List.Length));
   function Sides_Found return Natural is (Natural (Sides_List.Length));
   function Calls_Made return Natural is (Calls);

   function On_Line (Item : Side) return Symbol is
     (Sides_List (Natural (Item)).Output);

   function Is_Quiet (Item : Side) return Boolean is
      Here : Board renames
        Boards_List (Natural (Sides_List (Natural (Item)).To));
   begin
      return On_Line (Item) = Silence
        and then not Is_Talking (Here.Control)
        and then
          (Here.Control.State = Idling or else not Is_Waiting (Here.Control));
   end Is_Quiet;

   function Ends_Block (Item : Side; Fresh : Boolean) return Boolean is
      Here : Board renames
        Boards_List (Natural (Sides_List (Natural (Item)).To));
   begin
      return On_Line (Item) /= Silence
        and then Here.Control.Line_Taken
        and then Here.Control.State = Awaiting_Status
        and then
          (not Fresh
           or else Here.Transmit_Pair.Slots (Here.Control.Sender.Source).Data
                     (Mark_Place) = Mark);
   end Ends_Block;

   function Waits_At_End (Item : Side) return Boolean is
      Here : Board renames
        Boards_List (Natural (Sides_List (Natural (Item)).To));
   begin
      return Here.Control.Receiver.State = At_End;
   end Waits_At_End;

   --  What happens in a character time: a unit of the board's timer, a
   --  character heard, a block put. In any order, and the board polls
   --  between them or not, but once at least in the end. It puts one
   --  character on the line at most.
   type Happening is (Timer, Hearing, Putting);
   type Happenings is array (Happening) of Boolean;

   procedure Find_Outcomes
     (From  : Board_Number;
      Heard : Symbol;
      Acts  : Happenings;
      Fresh : Boolean;
      Found : in out Outcome_Vectors.Vector);

   procedure Find_Outcomes
     (From  : Board_Number;
      Heard : Symbol;
      Acts  : Happenings;
      Fresh : Boolean;
      Found : in out Outcome_Vectors.Vector)
   is
      procedure Add (Item : Outcome);

      procedure Go
        (Here   : Board_Number;
         Left   : Happenings;
         Output : Symbol;
         Good   : Boolean;
         Polled : Boolean);

      procedure Add (Item : Outcome) is
      begin
         if not Found.Contains (Item) then
            Found.Append (Item);
         end if;
      end Add;

      procedure Go
        (Here   : Board_Number;
         Left   : Happenings;
         Output : Symbol;
         Good   : Boolean;
         Polled : Boolean)
      is
         Result : Board := Fresh_Board;
         Now    : Symbol;
         Is_Good : Boolean;
         Is_Open : constant Boolean :=
           Content_Is_Open (Boards_List (Natural (Here)));
      begin
         if Left = (Happening => False)
           and then (Output /= Silence or else Polled)
         then
            Add ((Side_Of ((Here, Output)), Good));
            return;
         end if;

         if Output = Silence and then not Polled then
            for Content in Byte loop
               if Contents (Content) and then (Content = 0 or else Is_Open)
               then
                  Result := Boards_List (Natural (Here));
                  Poll (Result, Content, Now);
                  Go (Number_Of (Result), Left, Now, Good, True);
               end if;
            end loop;
         end if;

         for What in Happening loop
            if Left (What) then
               Result := Boards_List (Natural (Here));
               Is_Good := Good;
               case What is
                  when Timer   =>
                     Let_Pass (Result, Is_Good);
                     Is_Good := Is_Good or Good;
                  when Hearing =>
                     Hear (Result, To_Byte (Heard), False);
                  when Putting =>
                     Result := With_Block (Result, Fresh);
               end case;
               Go
                 (Number_Of (Result),
                  (Left with delta What => False),
                  Output, Is_Good, False);
            end if;
         end loop;
      end Go;
   begin
      Go (From, Acts, Silence, False, False);
   end Find_Outcomes;

   procedure Step
     (From        : Side;
      Heard       : Symbol;
      Controller  : Controller_Act;
      First, Last : out Natural)
   is
      Place : constant Natural :=
        (Natural (From) * Symbols_Used + Natural (Places (Heard))) * 4
        + Controller_Act'Pos (Controller);
      Start : constant Board_Number := Sides_List (Natural (From)).To;
      Found : Outcome_Vectors.Vector;
      Acts  : Happenings :=
        (Timer => True, Hearing => Heard /= Silence, Putting => False);
   begin
      if Begins (Place) = 0 then
         if Controller /= Puts_Old and then Controller /= Puts_Fresh then
            Find_Outcomes (Start, Heard, Acts, False, Found);
         end if;
         if Controller /= Waits then
            Acts (Putting) := True;
            Find_Outcomes
              (Start, Heard, Acts, Controller = Puts_Fresh, Found);
         end if;
         Begins (Place) := Natural (All_Outcomes.Length) + 1;
         All_Outcomes.Append (Found);
         Ends (Place) := Natural (All_Outcomes.Length);
      end if;
      First := Begins (Place);
      Last := Ends (Place);
   end Step;

   function Nth (Index : Positive) return Outcome is (All_Outcomes (Index));

   function Image (Item : Side) return String is
      Here : Board renames
        Boards_List (Natural (Sides_List (Natural (Item)).To));
      Digit  : constant String := "0123456789ABCDEF";
      Output : constant Symbol := On_Line (Item);

      function Blocks return String;

      function Blocks return String is
        ((if Here.Transmit_Pair.Slots (First).Full
          then " full" & Here.Transmit_Pair.Slots (First).Attempts'Image
          else "")
         & (if Here.Transmit_Pair.Slots (Second).Full then " newer" else ""));
   begin
      return (if Output = Silence then "--"
              else Digit (Natural (To_Byte (Output) / 16) + 1)
                   & Digit (Natural (To_Byte (Output) mod 16) + 1))
        & " " & Here.Control.State'Image
        & " " & Here.Control.Receiver.State'Image
        & " silence" & Here.Control.Silence'Image
        & (if Here.Control.Owed /= None
           then " owes " & Here.Control.Owed'Image else "")
        & (if Here.Control.Downlink_Turns > 0
           then " turns" & Here.Control.Downlink_Turns'Image else "")
        & Blocks;
   end Image;

   procedure Check_Normal (States : out Natural; Is_Exact : out Boolean) is
      Seen : Board_Vectors.Vector;
      Map  : Key_Maps.Map;
      Next : Natural := 0;

      --  Everything stays, but for counts, and data in buffers that are
      --  neither full nor being filled.
      procedure Note (Item : Board);

      --  The same happened to a board and to its normal form.
      procedure Compare
        (Left, Right : Board; Left_Output, Right_Output : Integer);

      procedure Note (Item : Board) is
         Kept     : Board := Item;
         Position : Key_Maps.Cursor;
         Is_New   : Boolean;
      begin
         Kept.Control.Messages := 0;
         Kept.Control.Tally := (others => 0);
         Map.Insert (Key_Of (Kept), 0, Position, Is_New);
         if Is_New then
            Seen.Append (Kept);
         end if;
      end Note;

      procedure Compare
        (Left, Right : Board; Left_Output, Right_Output : Integer) is
      begin
         Note (Left);
         if Left_Output /= Right_Output
           or else Key_Of (Normal (Left)) /= Key_Of (Normal (Right))
         then
            Is_Exact := False;
         end if;
      end Compare;

      --  A character that is neither sent by a board nor the checksum of one
      --  that is.
      function Is_Foreign (Data : Byte) return Boolean is
        (not Sums_Kept (Data)
         and then Data /= Other_Sum
         and then not Sums_Kept (Bytes_Of (Data))
         and then Bytes_Of (Data) /= Data);

      Foreign : Byte := 0;
   begin
      while not Is_Foreign (Foreign) loop
         Foreign := Foreign + 1;
      end loop;
      Is_Exact := True;
      Note (Fresh_Board);
      while Next < Natural (Seen.Length) loop
         declare
            Here    : constant Board := Seen (Next);
            Reduced : constant Board := Normal (Here);
            L, R    : Board;
            Of_L, Of_R : Boolean;
            S, T    : Symbol;
            Taken   : Block_Data;
            Ignore  : Boolean;
         begin
            L := Here;
            R := Reduced;
            Let_Pass (L, Of_L);
            Let_Pass (R, Of_R);
            Compare (L, R, Boolean'Pos (Of_L), Boolean'Pos (Of_R));

            L := Here;
            R := Reduced;
            Start (L);
            Start (R);
            Compare (L, R, 0, 0);

            L := Here;
            R := Reduced;
            Clear_Transmit_Half (L);
            Clear_Transmit_Half (R);
            Compare (L, R, 0, 0);

            Compare
              (With_Block (Here, False), With_Block (Reduced, False), 0, 0);

            --  The controller takes what came. Nobody else notices.
            L := Here;
            Take (L, Taken, Of_L, Ignore);
            Compare (L, Reduced, 0, 0);

            for Content in Byte loop
               if Contents (Content)
                 and then (Content = 0 or else Content_Is_Open (Here))
               then
                  L := Here;
                  R := Reduced;
                  Poll (L, Content, S);
                  Poll (R, Content, T);
                  Compare (L, R, Integer (S), Integer (T));
               end if;
            end loop;

            --  The characters that a board may send, and one unlike them.
            for Data in Byte loop
               if Sums_Kept (Data) or else Data = Foreign then
                  for Parity_Error in Boolean loop
                     L := Here;
                     R := Reduced;
                     Hear (L, Data, Parity_Error);
                     Hear (R, Data, Parity_Error);
                     Compare (L, R, 0, 0);
                  end loop;
               end if;
            end loop;
         end;
         Next := Next + 1;
      end loop;
      States := Next;
   end Check_Normal;

   Used : Symbol_Place := 0;
begin
   for Value in Byte loop
      Contents (Value) := Is_Content (Value);
      Sums_Kept (Value) := Is_Sent (Value);
      Bytes_Of (Value) := Byte_Of (Value);
      if Is_Sent (Value) then
         Used := Used + 1;
         Places (To_Symbol (Value)) := Used;
      end if;
   end loop;
end Telemetry.Boards.Sides;
