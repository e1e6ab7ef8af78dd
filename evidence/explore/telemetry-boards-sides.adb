--  SPDX-License-Identifier: Apache-2.0

with Ada.Containers.Hashed_Maps;
with Ada.Containers.Vectors;
with Ada.Numerics.Discrete_Random;
with Interfaces;          use Interfaces;
with Telemetry.Checksum;
with Telemetry.Memory;    use Telemetry.Memory;
with Telemetry.Receivers; use Telemetry.Receivers;
with Telemetry.Senders;   use Telemetry.Senders;

package body Telemetry.Boards.Sides is

   pragma Suppress (Tampering_Check);

   Peer : constant Station := (if Role = Ground then Aircraft else Ground);

   function Fresh_Board return Board;

   function Fresh_Board return Board is
   begin
      return Result : Board :=
        New_Board (Role, Length_Of (Role), Length_Of (Peer))
      do
         Set_Round_Trip (Result, Round_Trip);
      end return;
   end Fresh_Board;

   --  The first character of a message of ours, and of one to us.
   function Our_Header return Byte is (Data_Header (Length_Of (Role)));
   function Their_Header return Byte is (Data_Header (Length_Of (Peer)));

   --  A number that identifies a normal board.
   type Key is new Unsigned_64;

   function Hash (Value : Key) return Ada.Containers.Hash_Type is
     (Ada.Containers.Hash_Type'Mod
        (Shift_Right (Value * 16#9E37_79B9_7F4A_7C15#, 32)));

   type Board_Number is new Natural;

   --  A followed block has this first byte. A message that was received from
   --  its first character on, after the last fault, is marked in the receive
   --  buffer that it does not go to.
   Mark_Place : constant Byte_Index := 1;
   Mark       : constant Byte := 16#A5#;

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
   Places       : constant := (Symbol'Pos (Symbol'Last) + 1) * 4;
   Begins, Ends : Number_Vectors.Vector;

   function Normal (This : Board; Is_Aligned : Boolean) return Board;
   function Key_Of (This : Board) return Key;
   function Number_Of (This : Board; Is_Aligned : Boolean)
     return Board_Number;
   function Side_Of (Item : Way) return Side;
   function With_Block (This : Board; Fresh : Boolean) return Board;

   --  The possible results when a normal board hears this, on a line without
   --  faults.
   type Hearing_Result is record
      To         : Board;
      Is_Aligned : Boolean;
   end record;
   package Result_Vectors is new Ada.Containers.Vectors
     (Positive, Hearing_Result);
   function Hearings (This : Board; Heard : Symbol)
     return Result_Vectors.Vector;

   --  A unit of the board's timer. Good reports that an aligned message was
   --  taken.
   procedure Let_Pass
     (This : in out Board; Is_Aligned : Boolean; Good : out Boolean);

   procedure Poll (This : in out Board; Output : out Symbol);

   function Is_On_Its_Way (This : Board) return Boolean is
     (This.Control.State in Sending | Awaiting_Status);

   --  A normal board that receives a message of which it has heard all.
   function Is_Aligned (This : Board) return Boolean is
     (Has_Message (This.Control.Receiver)
      and then This.Receive_Pair.Slots (Second).Data (Mark_Place) = Mark);

   function Normal (This : Board; Is_Aligned : Boolean) return Board is
      Result : Board := This;
      Source : constant Slot :=
        (if Is_On_Its_Way (This) then This.Control.Sender.Source
         elsif Any_Full (This.Transmit_Pair)
         then Newest_Full (This.Transmit_Pair)
         else First);

      --  A buffer without what nobody reads.
      function Bare (Which : Slot) return Buffer;

      function Bare (Which : Slot) return Buffer is
         From : Buffer renames This.Transmit_Pair.Slots (Which);
      begin
         return Bared : Buffer do
            if From.Full then
               Bared.Full := True;
               Bared.Busy := From.Busy;
               Bared.Attempts := From.Attempts;
               if From.Data (Mark_Place) = Mark then
                  Bared.Data (Mark_Place) := Mark;
               end if;
            end if;
         end return;
      end Bare;
   begin
      Result.Control.Messages := 0;
      Result.Control.Tally := (others => 0);
      if not Is_Waiting (This.Control) then
         Result.Control.Silence := 0;
      end if;

      --  At the end of its idle time the ground forgets what it has sent.
      if This.Control.State = Idling then
         Result.Control.In_A_Row := 0;
      end if;

      --  The controller has taken what came. A message that is not aligned
      --  may have the right checksum or not, whatever it was till now.
      Result.Receive_Pair := (Newest => Second, others => <>);
      Result.Control.Receiver :=
        (State => This.Control.Receiver.State, others => <>);
      if Has_Message (This.Control.Receiver) then
         Result.Receive_Pair.Slots (First).Busy := True;
         if Is_Aligned then
            Result.Receive_Pair.Slots (Second).Data (Mark_Place) := Mark;
         end if;
         Result.Control.Receiver.Received := This.Control.Receiver.Received;
         Result.Control.Receiver.Damaged :=
           This.Control.Receiver.State = At_End
           and then This.Control.Receiver.Damaged;
         Result.Control.Receiver.Sum := Checksum.Of_Message
           (Their_Header, Result.Receive_Pair.Slots (First).Data,
            This.Control.Receiver.Received);
      end if;

      --  The block on its way, or the newest, first.
      Result.Transmit_Pair := Empty_Pair;
      Result.Transmit_Pair.Slots (First) := Bare (Source);
      if Is_On_Its_Way (This) then
         Result.Transmit_Pair.Slots (Second) := Bare (Other (Source));
         if Result.Transmit_Pair.Slots (Second).Full then
            Result.Transmit_Pair.Newest := Second;
         end if;
      end if;
      Result.Control.Sender := (others => <>);
      if This.Control.State = Sending then
         Result.Control.Sender.Sent := This.Control.Sender.Sent;
         if This.Control.Sender.Sent > 0 then
            Result.Control.Sender.Sum := Checksum.Of_Message
              (Our_Header, Result.Transmit_Pair.Slots (First).Data,
               Byte_Count (This.Control.Sender.Sent - 1));
         end if;
      end if;
      return Result;
   end Normal;

   function Key_Of (This : Board) return Key is
      Result : Key := 0;

      procedure Add (Value : Natural; Values : Natural);

      procedure Add (Value : Natural; Values : Natural) is
      begin
         Result := Result * Key (Values) + Key (Value);
      end Add;
   begin
      Add (Turn'Pos (This.Control.State), 5);
      Add (Reply'Pos (This.Control.Owed), 3);
      Add (Boolean'Pos (This.Control.Line_Taken), 2);
      Add (Natural (This.Control.Silence), 128);
      Add (Natural (This.Control.Downlink_Turns), 3);
      Add (Boolean'Pos (This.Control.Clear_To_Send), 2);
      Add (Natural (This.Control.In_A_Row), Natural (Row_Count'Last) + 1);
      Add (Receiver_State'Pos (This.Control.Receiver.State), 4);
      Add (Natural (This.Control.Receiver.Received), Longest_Block + 1);
      Add (Boolean'Pos (This.Control.Receiver.Damaged), 2);
      Add (Boolean'Pos (Is_Aligned (This)), 2);
      Add
        ((if This.Control.State = Sending
          then Natural (This.Control.Sender.Sent) else 0),
         Longest_Block + 3);
      for Which in Slot loop
         declare
            From : Buffer renames This.Transmit_Pair.Slots (Which);
         begin
            Add (Boolean'Pos (From.Full), 2);
            Add (Natural (From.Attempts), 3);
            Add
              (Boolean'Pos
                 (From.Full and then From.Data (Mark_Place) = Mark),
               2);
         end;
      end loop;
      return Result;
   end Key_Of;

   function Number_Of (This : Board; Is_Aligned : Boolean)
     return Board_Number
   is
      Reduced  : constant Board := Normal (This, Is_Aligned);
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
        (Key (Item.To) * 16 + Symbol'Pos (Item.Output),
         Natural (Sides_List.Length), Position, Is_New);
      if Is_New then
         Sides_List.Append (Item);
         for Index in 1 .. Places loop
            Begins.Append (0);
            Ends.Append (0);
         end loop;
      end if;
      return Side (Key_Maps.Element (Position));
   end Side_Of;

   function With_Block (This : Board; Fresh : Boolean) return Board
   is
      Result    : Board := This;
      Overwrote : Boolean;
   begin
      Calls := Calls + 1;
      Put
        (Result,
         (Mark_Place => (if Fresh then Mark else 0), others => 0),
         Overwrote);
      return Result;
   end With_Block;

   --  A message has come to where its checksum is expected.
   function Expects_Sum (This : Board) return Boolean is
     (This.Control.Receiver.State = In_Data
      and then This.Control.Receiver.Received = This.Control.Receive_Length);

   function Hearings (This : Board; Heard : Symbol)
     return Result_Vectors.Vector
   is
      Result : Result_Vectors.Vector;

      procedure Hear (Data : Byte);

      procedure Hear (Data : Byte) is
         Next : Board := This;
      begin
         Calls := Calls + 1;
         Accept_Character (Next, Data, False);
         Result.Append
           (Hearing_Result'
              (Next,
               (if Has_Message (This.Control.Receiver) then Is_Aligned (This)
                else Heard = Data_Begins)));
      end Hear;

      --  The character that the sender of this has put on the line, if known.
      Data : constant Byte :=
        (case Heard is
            when Data_Begins         => Their_Header,
            when Command        => Encode ((Kind => Command_To_Downlink)),
            when Good           => Encode ((Status, True, False)),
            when Good_And_Wants => Encode ((Status, True, True)),
            when Bad            => Encode ((Status, False, False)),
            when Bad_And_Wants  => Encode ((Status, False, True)),
            when others         => 0);
   begin
      if Expects_Sum (This) then
         if Is_Aligned (This) then
            if Heard /= Data_Ends then
               raise Program_Error with "a message ends somewhere else";
            end if;
         else
            Hear (not This.Control.Receiver.Sum);
         end if;
         Hear (This.Control.Receiver.Sum);
      elsif Heard in Wild_Symbol
        and then Is_Listening (This.Control)
        and then This.Control.Receiver.State = At_Start
      then
         --  Any byte at all.
         for Value in Byte loop
            if Value = 0 or else Is_Valid (Value) then
               Hear (Value);
            end if;
         end loop;
      else
         Hear (Data);
      end if;
      return Result;
   end Hearings;

   procedure Let_Pass
     (This : in out Board; Is_Aligned : Boolean; Good : out Boolean)
   is
      Before : constant Count := This.Control.Messages;
   begin
      Calls := Calls + 1;
      Elapse (This, 1);
      Good := Is_Aligned and then This.Control.Messages > Before;
   end Let_Pass;

   procedure Poll (This : in out Board; Output : out Symbol) is
      Owes : constant Boolean := This.Control.Owed /= None;
      Send : Boolean;
      Data : Byte;
      Says : Telemetry.Headers.Header;
   begin
      Calls := Calls + 1;
      Next_Character (This, Send, Data);
      Output := Silence;
      if not Send then
         return;
      elsif not Owes and then This.Control.State = Sending then
         Output :=
           (if This.Control.Sender.Sent = 1 then Data_Begins
            else Data_Goes_On);
      elsif not Owes and then This.Control.State = Awaiting_Status then
         Output := Data_Ends;
      elsif Is_Valid (Data) then
         Says := Decode (Data);
         Output :=
           (case Says.Kind is
               when Command_To_Downlink => Command,
               when Headers.Status      =>
                 (if Says.Good
                  then (if Says.Wants_Downlink then Good_And_Wants else Good)
                  else (if Says.Wants_Downlink then Bad_And_Wants else Bad)),
               when Headers.Data        => Silence);
      end if;
      if Output = Silence
        or else (Output = Data_Begins and then Data /= Our_Header)
      then
         raise Program_Error with "a character sent makes no sense";
      end if;
   end Poll;

   procedure Explore_Alone is
      Next   : Natural := 0;
      Unused : Side;

      --  It is a state; so it is with something of ours on the line.
      procedure Note (This : Board; Output : Symbol := Silence);

      procedure Note (This : Board; Output : Symbol := Silence) is
         Number : constant Board_Number := Number_Of (This, False);
      begin
         Unused := Side_Of ((Number, Silence));
         if Output /= Silence then
            Unused := Side_Of ((Number, Output));
         end if;
      end Note;

      Output  : Symbol;
      Cut_Off : Symbol;
      Result  : Board;
   begin
      Note (Fresh_Board);
      while Next < Natural (Boards_List.Length) loop
         declare
            Here : constant Board := Boards_List (Next);
         begin
            Result := Here;
            Elapse (Result, 1);
            Note (Result);

            Result := Here;
            Elapse (Result, Character_Times'Last);
            Note (Result);

            Note (With_Block (Here, False));

            Result := Here;
            Start (Result);
            Note (Result);

            Result := Here;
            Clear_Transmit_Half (Result);
            Note (Result);

            for Data in Byte loop
               for Parity_Error in Boolean loop
                  if Data = 0
                    or else Expects_Sum (Here)
                    or else Here.Control.Receiver.State = At_Start
                  then
                     Calls := Calls + 1;
                     Result := Here;
                     Accept_Character (Result, Data, Parity_Error);
                     Note (Result);
                  end if;
               end loop;
            end loop;

            Result := Here;
            Poll (Result, Output);
            Note (Result, Output);
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
               Note (Result, Here.Output);
               Note (With_Block (From, False), Here.Output);

               --  A first character of a message may now be its last one.
               Cut_Off := (if Here.Output = Data_Begins then Data_Goes_On
                           else Here.Output);
               Result := From;
               Clear_Transmit_Half (Result);
               Note (Result, Cut_Off);
               Result := From;
               Start (Result);
               Note (Result, Cut_Off);
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
        and then not Here.Control.Clear_To_Send
        and then
          (Here.Control.State = Idling or else not Is_Waiting (Here.Control));
   end Is_Quiet;

   function Ends_Block (Item : Side; Fresh : Boolean) return Boolean is
      Here : Board renames
        Boards_List (Natural (Sides_List (Natural (Item)).To));
   begin
      return On_Line (Item) = Data_Ends
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

   --  The events of a character time: a unit of the board's timer, a character
   --  heard, a block put. In any order, and the board polls between them or
   --  not, but once at least in the end. It puts one character on the line at
   --  most.
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
         From    : constant Board := Boards_List (Natural (Here));
         Aligned : constant Boolean := Is_Aligned (From);
         Result  : Board := From;
         Now     : Symbol;
         Is_Good : Boolean;
      begin
         if Left = (Happening => False)
           and then (Output /= Silence or else Polled)
         then
            Add ((Side_Of ((Here, Output)), Good));
            return;
         end if;

         if Output = Silence and then not Polled then
            Poll (Result, Now);
            Go (Number_Of (Result, Aligned), Left, Now, Good, True);
         end if;

         for What in Happening loop
            if Left (What) then
               Result := From;
               case What is
                  when Timer   =>
                     Let_Pass (Result, Aligned, Is_Good);
                     Go
                       (Number_Of (Result, Aligned),
                        (Left with delta What => False),
                        Output, Good or Is_Good, False);
                  when Hearing =>
                     for Item of Hearings (From, Heard) loop
                        Go
                          (Number_Of (Item.To, Item.Is_Aligned),
                           (Left with delta What => False),
                           Output, Good, False);
                     end loop;
                  when Putting =>
                     Go
                       (Number_Of (With_Block (From, Fresh), Aligned),
                        (Left with delta What => False),
                        Output, Good, False);
               end case;
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
        Natural (From) * Places + Symbol'Pos (Heard) * 4
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

      function Blocks return String;

      function Blocks return String is
        ((if Here.Transmit_Pair.Slots (First).Full
          then " full" & Here.Transmit_Pair.Slots (First).Attempts'Image
          else "")
         & (if Here.Transmit_Pair.Slots (Second).Full then " newer" else ""));
   begin
      return On_Line (Item)'Image
        & " " & Here.Control.State'Image
        & (if Here.Control.State = Sending
           then Here.Control.Sender.Sent'Image else "")
        & " " & Here.Control.Receiver.State'Image
        & (if Here.Control.Receiver.State = In_Data
           then Here.Control.Receiver.Received'Image else "")
        & (if Is_Aligned (Here) then " aligned" else "")
        & " silence" & Here.Control.Silence'Image
        & (if Here.Control.Owed /= None
           then " owes " & Here.Control.Owed'Image else "")
        & (if Here.Control.Downlink_Turns > 0
           then " turns" & Here.Control.Downlink_Turns'Image else "")
        & (if Here.Control.In_A_Row > 0
           then " sent" & Here.Control.In_A_Row'Image else "")
        & (if Here.Control.Clear_To_Send then " clear" else "")
        & Blocks;
   end Image;

   package Byte_Chance is new Ada.Numerics.Discrete_Random (Byte);

   procedure Check_Normal
     (Trials : Positive; Calls : out Natural; Is_Exact : out Boolean)
   is
      Chance : Byte_Chance.Generator;

      function Some_Byte return Byte is (Byte_Chance.Random (Chance));
      function Either return Boolean is (Some_Byte < 128);
      function Either_Slot return Slot is (if Either then First else Second);

      --  A block by chance, of which many bytes look like first characters.
      function Some_Block return Block_Data;

      --  A board whose normal form Item is.
      function Full_Board (This : Board) return Board;

      --  The board is now one of those.
      procedure Compare (Now : Board; Options : Result_Vectors.Vector);
      procedure Compare (Now : Board; Aligned : Boolean; Option : Board);

      procedure Try (This : Board);

      function Some_Block return Block_Data is
         Result : Block_Data;
      begin
         for Value of Result loop
            loop
               Value := Some_Byte;
               exit when Is_Valid (Value)
                 or else (Either and then Value /= Mark);
            end loop;
         end loop;
         return Result;
      end Some_Block;

      function Full_Board (This : Board) return Board is
         Result : Board := This;
         Source : constant Slot := Either_Slot;
      begin
         Result.Control.Messages := Count (Some_Byte);
         Result.Control.Tally := (others => Count (Some_Byte));
         if not Is_Waiting (This.Control) then
            Result.Control.Silence := Character_Times (Some_Byte);
         end if;

         if This.Control.State = Idling then
            Result.Control.In_A_Row := Row_Count (Some_Byte mod 3);
         end if;

         Result.Control.Receiver.Target := Either_Slot;
         Result.Receive_Pair.Newest := Either_Slot;
         for Which in Slot loop
            Result.Receive_Pair.Slots (Which) :=
              (Full => Either, Data => Some_Block, others => <>);
         end loop;
         if Has_Message (This.Control.Receiver) then
            Result.Receive_Pair.Slots (Result.Control.Receiver.Target) :=
              (Busy => True, Data => Some_Block, others => <>);
            Result.Control.Receiver.Sum := Checksum.Of_Message
              (Their_Header,
               Result.Receive_Pair.Slots
                 (Result.Control.Receiver.Target).Data,
               This.Control.Receiver.Received);
            if This.Control.Receiver.State = In_Data then
               Result.Control.Receiver.Damaged :=
                 Either and then not Is_Aligned (This);
            end if;
         else
            Result.Control.Receiver.Received :=
              Byte_Count (Some_Byte mod Longest_Block);
            Result.Control.Receiver.Sum := Some_Byte;
            Result.Control.Receiver.Damaged := Either;
         end if;

         Result.Transmit_Pair.Slots (Source) :=
           This.Transmit_Pair.Slots (First);
         Result.Transmit_Pair.Slots (Other (Source)) :=
           This.Transmit_Pair.Slots (Second);
         Result.Transmit_Pair.Newest :=
           (if This.Transmit_Pair.Slots (Second).Full then Other (Source)
            else Either_Slot);
         for Which in Slot loop
            Result.Transmit_Pair.Slots (Which).Data := Some_Block;
         end loop;
         if not Is_On_Its_Way (This) and then Any_Full (This.Transmit_Pair)
           and then Either
         then
            Result.Transmit_Pair.Newest := Source;
            Result.Transmit_Pair.Slots (Other (Source)).Full := True;
            Result.Transmit_Pair.Slots (Other (Source)).Attempts :=
              Boolean'Pos (Either);
         end if;
         Result.Control.Sender.Source := Source;
         if This.Control.State = Sending then
            if This.Control.Sender.Sent > 0 then
               Result.Control.Sender.Sum := Checksum.Of_Message
                 (Our_Header, Result.Transmit_Pair.Slots (Source).Data,
                  Byte_Count (This.Control.Sender.Sent - 1));
            end if;
         else
            Result.Control.Sender.Sent :=
              Character_Count (Some_Byte mod Longest_Block);
            Result.Control.Sender.Sum := Some_Byte;
         end if;
         return Result;
      end Full_Board;

      procedure Compare (Now : Board; Options : Result_Vectors.Vector) is
      begin
         Calls := Calls + 1;
         Is_Exact := Is_Exact
           and then Is_Sound (Now)
           and then
             (for some Option of Options =>
                Normal (Option.To, Option.Is_Aligned) =
                  Normal (Now, Option.Is_Aligned));
      end Compare;

      procedure Compare (Now : Board; Aligned : Boolean; Option : Board) is
      begin
         Compare
           (Now, Result_Vectors.To_Vector ((Option, Aligned), 1));
      end Compare;

      procedure Try (This : Board) is
         Aligned    : constant Boolean := Is_Aligned (This);
         Full       : constant Board := Full_Board (This);
         L, R       : Board;
         Of_L, Of_R : Boolean;
         S, T       : Symbol;
         Taken      : Block_Data;
      begin
         Compare (Full, Aligned, This);

         for Time in Character_Times range 1 .. 2 loop
            L := Full;
            R := This;
            Elapse (L, Time);
            Elapse (R, Time);
            Compare (L, Aligned, R);
            Is_Exact := Is_Exact
              and then
                (L.Control.Messages > Full.Control.Messages) =
                  (R.Control.Messages > 0);
         end loop;

         L := Full;
         R := This;
         Start (L);
         Start (R);
         Compare (L, False, R);

         L := Full;
         R := This;
         Clear_Transmit_Half (L);
         Clear_Transmit_Half (R);
         Compare (L, Aligned, R);

         L := Full;
         Put (L, Some_Block, Of_L);
         Compare (L, Aligned, With_Block (This, False));

         --  The controller takes what came. Nobody else notices.
         L := Full;
         Take (L, Taken, Of_L, Of_R);
         Compare (L, Aligned, This);

         L := Full;
         R := This;
         Poll (L, S);
         Poll (R, T);
         Compare (L, Aligned, R);
         Is_Exact := Is_Exact and then S = T;

         for Heard in Data_Begins .. Symbol'Last loop
            if not Aligned
              or else Heard =
                (if This.Control.Receiver.State = At_End then Silence
                 elsif Expects_Sum (This) then Data_Ends
                 else Data_Goes_On)
            then
               declare
                  Options : constant Result_Vectors.Vector :=
                    Hearings (This, Heard);
               begin
                  for Data in Byte loop
                     if (case Heard is
                           when Data_Begins         => Data = Their_Header,
                           when Data_Goes_On | Data_Ends  => not Aligned
                             or else not Expects_Sum (This)
                             or else Data = Full.Control.Receiver.Sum,
                           when Command        => Data =
                             Encode ((Kind => Command_To_Downlink)),
                           when Good           =>
                             Data = Encode ((Status, True, False)),
                           when Good_And_Wants =>
                             Data = Encode ((Status, True, True)),
                           when Bad            =>
                             Data = Encode ((Status, False, False)),
                           when Bad_And_Wants  =>
                             Data = Encode ((Status, False, True)))
                     then
                        L := Full;
                        Accept_Character (L, Data, False);
                        Compare (L, Options);
                     end if;
                  end loop;
               end;
            end if;
         end loop;
      end Try;
   begin
      Calls := 0;
      Is_Exact := True;
      Byte_Chance.Reset (Chance, 1);
      for This of Boards_List loop
         for Trial in 1 .. Trials loop
            Try (This);
            if Has_Message (This.Control.Receiver)
              and then not This.Control.Receiver.Damaged
            then
               Try (Normal (This, True));
            end if;
         end loop;
      end loop;
   end Check_Normal;

end Telemetry.Boards.Sides;
