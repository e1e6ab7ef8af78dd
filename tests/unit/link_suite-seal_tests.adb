--  SPDX-License-Identifier: Apache-2.0

with Interfaces; use Interfaces;

with Checks;           use Checks;
with Expectations;     use Expectations;
with Expect_Value;
with Published_Tags;   use Published_Tags;
with Telemetry;        use Telemetry;
with URV.Seal_Blocks;  use URV.Seal_Blocks;
with URV.Handshakes;   use URV.Handshakes;
with URV.Seals;        use URV.Seals;
with URV.Plain_Blocks; use URV.Plain_Blocks;
with URV.Sessions;     use URV.Sessions;
with URV.Sip_Hash;     use URV.Sip_Hash;
with URVOS;            use URVOS;

separate (Link_Suite)
package body Seal_Tests is

   procedure Expect_Tag is new Expect_Value (Unsigned_64);
   procedure Expect_Outcome is new Expect_Value (Outcome);

   --  The tests, in order.
   procedure Known_Tags;
   procedure Places_On_The_Wire;
   procedure Words_Come_Through;
   procedure Three_Steps;
   procedure Taken_Once;
   procedure Losses;
   procedure Late_Blocks;
   procedure A_Growing_Delay;
   procedure Every_Bit_Counts;
   procedure Other_Direction;
   procedure Other_Session;
   procedure Other_Key;
   procedure Key_Change;
   procedure Key_Of_The_Call;
   procedure Answer_To_Another;
   procedure Ground_Restarts;
   procedure Aircraft_Restarts;
   procedure Hellos_Are_Disregarded;
   procedure Hellos_Lock_Nobody_Out;
   procedure Long_Silence;
   procedure A_Node_Stands_Still;
   procedure One_Format;
   procedure Numbers_Used_Up;

   Keys_1  : constant Key_List :=
     (First  => (True, 1, Count_Key),
      Second => (others => <>));
   Keys_2  : constant Key_List :=
     (First  => (True, 2, (K0 => 22, K1 => 23)),
      Second => (others => <>));
   Keys_12 : constant Key_List := (Keys_1 (First), Keys_2 (First));
   Keys_21 : constant Key_List := (Keys_2 (First), Keys_1 (First));

   --  Both ends of a link with which a test may do anything.
   type Link is array (Station) of Seal;

   function New_Link
     (Ground_Keys   : Key_List := Keys_1;
      Aircraft_Keys : Key_List := Keys_1;
      Start         : Nonce    := 1_000) return Link
   is
     (Ground   => New_Seal (Ground, 2, Ground_Keys, Start),
      Aircraft => New_Seal (Aircraft, 2, Aircraft_Keys, Start + 500));

   --  Word n is 100h + n + Mark; the last one is 5.
   function Data_Of (From : Station; Mark : Word) return Block_Words;

   function Closed (Both : in out Link; From : Station; Mark : Word := 0)
                    return Block_Data;

   --  Makes a session, with a sealed block each way.
   procedure Shake_Hands (Both : in out Link);

   procedure Expect_Opening
     (What     : String;
      Both     : in out Link;
      By       : Station;
      Block    : Block_Data;
      Expected : Outcome);

   --  Passes frames at both ends.
   procedure Pass (Both : in out Link; Frames : Counter := 1);

   --  Passes a frame; then one end sends a block to the other.
   procedure Expect_Next
     (What     : String;
      Both     : in out Link;
      From     : Station;
      Expected : Outcome;
      Mark     : Word := 0);

   --  Passes frames in which both ends send, until both have taken a sealed
   --  block of the other. This must happen within the given number of frames.
   procedure Expect_Session
     (What   : String;
      Both   : in out Link;
      Within : Positive);

   function Data_Of (From : Station; Mark : Word) return Block_Words is
      Result : Block_Words := (others => 0);
   begin
      for Which in Word_Place range 1 .. Words_Of (From) loop
         Result (Which) :=
           (if Which = Words_Of (From) then 5
            else 16#100# + Word (Which) + Mark);
      end loop;
      return Result;
   end Data_Of;

   function Closed (Both : in out Link; From : Station; Mark : Word := 0)
                    return Block_Data
   is
      Result : Block_Data;
   begin
      Close (Both (From), Data_Of (From, Mark), Result);
      return Result;
   end Closed;

   procedure Expect_Opening
     (What     : String;
      Both     : in out Link;
      By       : Station;
      Block    : Block_Data;
      Expected : Outcome)
   is
      Words : Block_Words;
      Found : Outcome;
   begin
      Open (Both (By), Block, True, Words, Found);
      Expect_Outcome (What, Found, Expected);
      Expect
        (What & ", words are there", (for some Each of Words => Each /= 0),
         Found in Taken);
   end Expect_Opening;

   procedure Pass (Both : in out Link; Frames : Counter := 1) is
   begin
      for Node of Both loop
         Pass (Node, Frames);
      end loop;
   end Pass;

   procedure Expect_Next
     (What     : String;
      Both     : in out Link;
      From     : Station;
      Expected : Outcome;
      Mark     : Word := 0) is
   begin
      Pass (Both);
      Expect_Opening
        (What, Both, Other (From), Closed (Both, From, Mark), Expected);
   end Expect_Next;

   procedure Expect_Session
     (What   : String;
      Both   : in out Link;
      Within : Positive)
   is
      Opens : array (Station) of Boolean := (others => False);
      Words : Block_Words;
      Found : Outcome;
   begin
      for Frame in 1 .. Within loop
         Pass (Both);
         for From in Station loop
            Open
              (Both (Other (From)), Closed (Both, From), True, Words, Found);
            Opens (Other (From)) := Found in Taken;
         end loop;
         exit when Opens (Ground) and then Opens (Aircraft);
      end loop;
      Expect
        (What & " within" & Within'Image,
         Opens (Ground) and then Opens (Aircraft), True);
   end Expect_Session;

   procedure Shake_Hands (Both : in out Link) is
   begin
      Expect_Next ("call", Both, Ground, Hello_Taken);
      Expect_Next ("answer", Both, Aircraft, Hello_Taken);
      Expect_Next ("first up", Both, Ground, Opened_New_Session);
      Expect_Next ("first down", Both, Aircraft, Opened);
   end Shake_Hands;

   procedure Known_Tags is
      Item : Message;
   begin
      for Length in Message_Length loop
         Item.Length := Length;
         Expect_Tag
           ("of" & Length'Image & " bytes", Tag (Item, Count_Key),
            Published (Length));

         --  Bytes after the message have no effect.
         if Length < Message_Length'Last then
            Item.Bytes (Length + 1) := 16#FF#;
            Expect_Tag
              ("with something behind", Tag (Item, Count_Key),
               Published (Length));
            Item.Bytes (Length + 1) := Byte (Length);
         end if;
      end loop;
   end Known_Tags;

   procedure Places_On_The_Wire is
      Up   : constant Block_Data :=
        Packed (Data_Of (Ground, 0), Ground, Number => 74, Echo => 68);
      Down : constant Block_Data :=
        Packed
          (Data_Of (Aircraft, 0), Aircraft,
           Number => 16#234567#, Echo => 100);
   begin
      Expect ("mark and flags up", Up (1), 16#A5#);
      Expect ("word 1", Up (2), 16#10#);
      Expect ("words 1 and 2", Up (3), 16#11#);
      Expect ("word 2", Up (4), 16#02#);
      Expect ("word 13", Up (20), 16#10#);
      Expect ("word 13 and number", Up (21), 16#D2#);
      Expect ("number and echo", Up (22), 16#85#);
      for Where in Byte_Index range 23 .. Byte_Index'Last loop
         Expect ("behind", Up (Where), 0);
      end loop;
      Expect ("mark and flags down", Down (1), 16#A5#);
      Expect ("word 25", Down (38), 16#11#);
      Expect ("words 25 and 26", Down (39), 16#91#);
      Expect ("word 26", Down (40), 16#1A#);
      Expect ("echo down", Down (Downlink_Length - 12), 37);
      Expect ("no card", Down (Downlink_Length - 11), 0);
      Expect ("number's high byte", Down (Downlink_Length - 10), 16#23#);
      Expect ("number's low byte", Down (Downlink_Length - 8), 16#67#);
      Expect ("tag's first byte", Down (Downlink_Length - 7), 0);
      Expect_Number
        ("number", Integer (Number_At (Down)), 16#234567#);
   end Places_On_The_Wire;

   procedure Words_Come_Through is
      Both  : Link := New_Link;
      Given : Block_Words;
      Block : Block_Data;
      Came  : Block_Words;
      Found : Outcome;

      --  The spare bits of a word that comes down: a mark, the number, and
      --  the card and phase as they were sent (FTI-12).
      function Spare_Of (Sent : Block_Words; Place : Word_Place) return Word is
        (case Place is
            when 1      => 6,
            when 2      => Word (Both (Aircraft).Active.Age / 256 mod 16),
            when 3      => Word (Both (Aircraft).Active.Age / 16 mod 16),
            when 4      => Word (Both (Aircraft).Active.Age mod 16),
            when 5 | 6  => Sent (Place) / 16#1000#,
            when others => 0);

   begin
      Shake_Hands (Both);

      --  All values of 16 bits, each at every place.
      for Value in Word loop
         for From in Station loop
            Given := Data_Of (From, Value);
            declare
               Which : constant Word_Place :=
                 Byte_Count (Value mod Word (Words_Of (From))) + 1;
            begin
               Given (Which) := Value;
               Pass (Both);
               Close (Both (From), Given, Block);
               Open (Both (Other (From)), Block, True, Came, Found);
               Expect_Outcome ("sealed", Found, Opened);
               for Place in Word_Place range 1 .. Words_Of (From) loop
                  Expect
                    ("word" & Place'Image & " from " & From'Image,
                     Came (Place),
                     (if Place < Words_Of (From) and then From = Ground
                      then Word'Min (Given (Place), 16#FFF#)
                      elsif Place < Words_Of (From)
                      then Given (Place) mod 16#1000#
                        + 16#1000# * Spare_Of (Given, Place)
                      elsif From = Ground
                      then Given (Place) mod 16
                      else Given (Place)));
               end loop;
            end;
         end loop;
      end loop;
   end Words_Come_Through;

   procedure Three_Steps is
      Both : Link := New_Link;
   begin
      --  No block is taken before both have exchanged their nonces.
      Expect_Next ("an answer to nothing", Both, Aircraft, Hello_Repeated);
      Shake_Hands (Both);
      for Number in Word range 1 .. 10 loop
         Expect_Next ("up", Both, Ground, Opened, Number);
         Expect_Next ("down", Both, Aircraft, Opened, Number);
      end loop;

      --  A repeated or late answer changes nothing.
      Both := New_Link;
      Expect_Next ("call", Both, Ground, Hello_Taken);
      Expect_Next ("call again", Both, Ground, Hello_Repeated);
      Expect_Next ("answer", Both, Aircraft, Hello_Taken);
      Expect_Next ("answer again", Both, Aircraft, Hello_Repeated);
      Expect_Next ("up", Both, Ground, Opened_New_Session);
      Expect_Next ("down", Both, Aircraft, Opened);
   end Three_Steps;

   procedure Taken_Once is
      Both  : Link := New_Link;
      Older : Block_Data;
      Newer : Block_Data;
   begin
      Shake_Hands (Both);
      for From in Station loop
         Older := Closed (Both, From, 1);
         Pass (Both);
         Newer := Closed (Both, From, 2);
         Expect_Opening
           ("the newer", Both, Other (From), Newer, Opened);
         Expect_Opening
           ("the same again", Both, Other (From), Newer, Not_Opened);
         Expect_Opening
           ("the older", Both, Other (From), Older, Not_Opened);
         Expect_Next ("the next", Both, From, Opened);
      end loop;
   end Taken_Once;

   procedure Losses is
      Lasts : constant := Longest_Silence - 10;
      Both  : Link;
   begin
      for From in Station loop
         for Lost in Counter range 1 .. Lasts loop
            if Lost in 1 .. 3 | 62 .. 66 | Lasts - 2 .. Lasts then
               Both := New_Link;
               Shake_Hands (Both);
               Pass (Both, Lost);
               Expect_Next
                 ("after" & Lost'Image & " were lost from " & From'Image,
                  Both, From, Opened);
            end if;
         end loop;
      end loop;
   end Losses;

   procedure Late_Blocks is
      Both  : Link;
      Block : Block_Data;
      Words : Block_Words;
      Found : Outcome;
   begin
      for From in Station loop
         for Late in Counter range 1 .. 200 loop
            Both := New_Link;
            Shake_Hands (Both);
            Expect_Session ("goes on", Both, 1);
            Pass (Both);
            Block := Closed (Both, From);
            Pass (Both, Late);
            Open (Both (Other (From)), Block, True, Words, Found);
            if Late <= 6 or else Late > Most_Age then
               Expect_Outcome
                 (Late'Image & " frames late from " & From'Image, Found,
                  (if Late <= 6 then Opened
                   elsif Late < 60 then Too_Late
                   else Found));
            end if;
            if Late > Most_Age then
               Expect ("refused", Found in Refused, True);
               Expect
                 ("nothing of it is left",
                  (for all Each of Words => Each = 0), True);
            end if;
         end loop;
      end loop;
   end Late_Blocks;

   --  One block in three arrives, always the oldest that has not: the delay of
   --  every line that has more blocks than it can carry.
   procedure A_Growing_Delay is
      Frames  : constant := 600;
      Both    : Link := New_Link;
      Waiting : array (1 .. Frames) of Block_Data;
      First   : Positive;
      Found   : Outcome;
      Words   : Block_Words;
      Taken_Blocks : Natural;
   begin
      for From in Station loop
         Both := New_Link;
         Shake_Hands (Both);
         First := 1;
         Taken_Blocks := 0;
         for Frame in 1 .. Frames loop
            Pass (Both);
            Waiting (Frame) := Closed (Both, From);
            if Frame mod 3 = 0 then
               Open
                 (Both (Other (From)), Waiting (First), True, Words, Found);
               if Found in Taken then
                  Taken_Blocks := Taken_Blocks + 1;
                  Expect_Number
                    ("age of a block taken from " & From'Image,
                     Integer'Max (Frame - First, Most_Age), Most_Age);
               end if;
               First := First + 1;
            end if;
            Open
              (Both (From), Closed (Both, Other (From)), True, Words, Found);
         end loop;
         Expect ("some were young", Taken_Blocks > 0, True);
      end loop;
   end A_Growing_Delay;

   procedure Every_Bit_Counts is
      Both    : Link := New_Link;
      Block   : Block_Data;
      Altered : Block_Data;
      Length  : Byte_Count;
   begin
      for Kind in 1 .. 2 loop
         for From in Station loop
            Pass (Both);
            Block := Closed (Both, From);
            Length := Covered (From) + Tag_Bytes (From);
            for Where in 1 .. Length loop
               for Bit in 0 .. 7 loop
                  Altered := Block;
                  Altered (Where) :=
                    Altered (Where) xor Byte (2 ** Bit);
                  declare
                     Copy   : Link := Both;
                     Found  : Outcome;
                     Unused : Block_Words;
                  begin
                     Open (Copy (Other (From)), Altered, True, Unused, Found);
                     Expect
                       ("byte" & Where'Image & ", bit" & Bit'Image
                        & " is refused",
                        Found in Refused, True);
                  end;
               end loop;
            end loop;
         end loop;
         Both := New_Link;
         Shake_Hands (Both);
      end loop;
   end Every_Bit_Counts;

   procedure Other_Direction is
      Both : Link := New_Link;
   begin
      Expect_Opening
        ("own hello", Both, Ground, Closed (Both, Ground), Not_Opened);
      Expect_Opening
        ("own hello", Both, Aircraft, Closed (Both, Aircraft), Not_Opened);
      Both := New_Link;
      Shake_Hands (Both);
      Pass (Both);
      Expect_Opening
        ("own block", Both, Ground, Closed (Both, Ground), Not_Opened);
      Expect_Opening
        ("own block", Both, Aircraft, Closed (Both, Aircraft), Not_Opened);
   end Other_Direction;

   procedure Other_Session is
      This : Link := New_Link;
      That : Link := New_Link (Start => 7_000);
   begin
      Shake_Hands (This);
      Shake_Hands (That);
      for From in Station loop
         Pass (This);
         Pass (That);
         Expect_Opening
           ("of another session", This, Other (From), Closed (That, From),
            Not_Opened);
      end loop;
   end Other_Session;

   procedure Other_Key is
      Both : Link := New_Link (Keys_1, Keys_2);
   begin
      Expect_Next ("another number", Both, Ground, Unknown_Key);
      Expect_Next ("another number", Both, Aircraft, Unknown_Key);

      Both := New_Link
        (Keys_1,
         (First  => (True, 1, (K0 => Count_Key.K0, K1 => Count_Key.K1 + 1)),
          Second => (others => <>)));
      Expect_Next ("another key", Both, Ground, Not_Opened);
      Expect_Next ("another key", Both, Aircraft, Not_Opened);
   end Other_Key;

   procedure Key_Change is
      Both : Link;
   begin
      --  First the old key; then both in the aircraft; then the ground has the
      --  new one first; then the new one alone.
      for Step in 1 .. 4 loop
         Both :=
           (case Step is
               when 1      => New_Link (Keys_1, Keys_12),
               when 2      => New_Link (Keys_12, Keys_12),
               when 3      => New_Link (Keys_21, Keys_12),
               when others => New_Link (Keys_2, Keys_12));
         Shake_Hands (Both);
         Expect_Number
           ("key in step" & Step'Image, Integer (Both (Ground).Active.Number),
            (if Step < 3 then 1 else 2));
      end loop;
   end Key_Change;

   procedure Key_Of_The_Call is
      Both   : Link := New_Link (Keys_12, Keys_12);
      Other  : Link := New_Link (Keys_21, Keys_12);
   begin
      --  Another ground calls with the same nonce and the other key.
      Expect_Next ("call", Other, Ground, Hello_Taken);
      Expect_Opening
        ("answer under another key", Both, Ground, Closed (Other, Aircraft),
         Hello_Repeated);
      Expect_Next ("call", Both, Ground, Hello_Taken);
      Expect_Next ("call again", Both, Ground, Hello_Repeated);
      Other := New_Link (Keys_21, Keys_12);
      Expect_Opening
        ("call under another key", Both, Aircraft, Closed (Other, Ground),
         Hello_Taken);

      --  The second key may be the only one.
      Expect
        ("it is known",
         Is_Known ((First => (others => <>), Second => Keys_2 (First)), 2),
         True);
      Expect
        ("and found",
         Found ((First => (others => <>), Second => Keys_2 (First)), 2)
         = Keys_2 (First).Value,
         True);
   end Key_Of_The_Call;

   procedure Answer_To_Another is
      Both : Link := New_Link;
      That : Link := New_Link (Start => 7_000);
   begin
      --  The aircraft's nonce is that of the session; the ground's is not.
      Shake_Hands (Both);
      That (Aircraft) := New_Link (Aircraft);
      Expect_Next ("call", That, Ground, Hello_Taken);
      Expect_Opening
        ("answer to another ground", Both, Ground, Closed (That, Aircraft),
         Hello_Out_Of_Turn);
      Expect_Next ("the session goes on", Both, Aircraft, Opened);
   end Answer_To_Another;

   procedure Ground_Restarts is
      Both : Link := New_Link;
      Old  : Block_Data;
   begin
      Shake_Hands (Both);
      Old := Closed (Both, Ground);
      Both (Ground) := New_Seal (Ground, 2, Keys_1, 9_000);

      --  The aircraft has just received a block of its session, and waits.
      Expect_Next ("too early", Both, Ground, Hello_Out_Of_Turn);
      Expect_Session ("again", Both, 6);
      Expect_Opening
        ("of before the start", Both, Aircraft, Old, Not_Opened);
   end Ground_Restarts;

   procedure Aircraft_Restarts is
      Both    : Link := New_Link;
      Called  : Block_Data;
      Old     : Block_Data;
   begin
      Called := Closed (Both, Ground);
      Shake_Hands (Both);
      Old := Closed (Both, Ground);
      Both (Aircraft) := New_Seal (Aircraft, 2, Keys_1, 9_000);
      Expect_Opening ("no session", Both, Aircraft, Old, Not_Opened);
      Expect_Opening
        ("the hello of before", Both, Aircraft, Called, Hello_Taken);
      Expect_Opening
        ("and the block", Both, Aircraft, Old, Not_Opened);

      --  Its hellos are accepted after its blocks have stopped.
      Expect_Next ("too early", Both, Aircraft, Hello_Out_Of_Turn);
      Expect_Session ("again", Both, 9);
   end Aircraft_Restarts;

   procedure Hellos_Are_Disregarded is
      Both : Link := New_Link;
      Hello_Up, Hello_Down : Block_Data;
   begin
      --  Hellos of a session, and then another one.
      Hello_Up := Closed (Both, Ground);
      Expect_Next ("call", Both, Ground, Hello_Taken);
      Hello_Down := Closed (Both, Aircraft);
      Expect_Session ("first", Both, 3);
      Both (Ground) := Restarted (Both (Ground));
      Expect_Session ("second", Both, 8);

      Expect_Opening
        ("call of before", Both, Aircraft, Hello_Up, Hello_Out_Of_Turn);
      Expect_Opening
        ("answer of before", Both, Ground, Hello_Down, Hello_Out_Of_Turn);

      --  In a gap the call is answered, but the session is kept.
      Pass (Both, 5);
      Expect_Opening
        ("call of before", Both, Aircraft, Hello_Up, Hello_Taken);
      Expect_Next ("up", Both, Ground, Opened);
      Expect_Next ("down", Both, Aircraft, Opened);
   end Hellos_Are_Disregarded;

   --  One recorded call follows every block of the ground, which has
   --  restarted.
   procedure Hellos_Lock_Nobody_Out is
      Both     : Link := New_Link;
      Recorded : array (1 .. 3) of Block_Data;
      Unused   : Block_Words;
      Found    : Outcome;
      Needed   : Natural := 0;
   begin
      for Each of Recorded loop
         Each := Closed (Both, Ground);
         Both (Ground) := Restarted (Both (Ground));
      end loop;
      Shake_Hands (Both);
      Both (Ground) := Restarted (Both (Ground));
      for Frame in 1 .. 20 loop
         Needed := Frame;
         Pass (Both);
         Open (Both (Aircraft), Closed (Both, Ground), True, Unused, Found);
         exit when Found = Opened_New_Session;
         Open
           (Both (Aircraft), Recorded (Frame mod 3 + 1), True, Unused, Found);
         Open (Both (Ground), Closed (Both, Aircraft), True, Unused, Found);
      end loop;
      Expect ("a session within 10 frames", Needed <= 10, True);
   end Hellos_Lock_Nobody_Out;

   procedure Long_Silence is
      Both : Link := New_Link;
      Old  : Block_Data;
   begin
      Shake_Hands (Both);
      Pass (Both, Longest_Silence);
      Old := Closed (Both, Ground);
      Expect_Opening ("given up", Both, Aircraft, Old, Not_Opened);
      Expect_Session ("a new one", Both, 8);
   end Long_Silence;

   --  Its clock continues when it does.
   procedure A_Node_Stands_Still is
      Stopped : constant Counter := 4_250;
      Both    : Link;
   begin
      for Still in Station loop
         Both := New_Link;
         Shake_Hands (Both);
         for Frame in 1 .. Stopped loop
            Pass (Both (Other (Still)), 1);
         end loop;
         Pass (Both (Still), Stopped);
         Expect_Session (Still'Image & " stood still", Both, 8);
      end loop;
   end A_Node_Stands_Still;

   procedure One_Format is
      Both : Link := New_Link;
      Old  : Link := New_Link;
   begin
      Old (Ground).Format := 1;
      Old (Aircraft).Format := 1;
      for Kind in 1 .. 2 loop
         for From in Station loop
            Expect_Opening
              ("format 2 to 1", Old, Other (From), Closed (Both, From),
               Wrong_Format);
            Expect_Opening
              ("format 1 to 2", Both, Other (From), Closed (Old, From),
               Wrong_Format);
            Expect_Opening
              ("format 1 to 1", Old, Other (From), Closed (Old, From),
               Opened);
         end loop;
         Both := New_Link;
         Shake_Hands (Both);
      end loop;
   end One_Format;

   procedure Numbers_Used_Up is
      Both   : Link := New_Link;
      Before : constant Counter := Last_Age - 2;
   begin
      for From in Station loop
         Both := New_Link;
         Shake_Hands (Both);
         Both (From).Active.Age := Before;
         Both (Other (From)).Active :=
           (Both (Other (From)).Active with delta
              Newest     => Before,
              Reference  => Before,
              Taken_At   => Both (Other (From)).Active.Age,
              Not_Before => Both (Other (From)).Active.Age);
         Expect_Next ("the last", Both, From, Opened);
         Expect_Session ("a new one", Both, 12);
         Expect ("it is young", Both (From).Active.Age < 20, True);
      end loop;
   end Numbers_Used_Up;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "SEC-2 SipHash-2-4 gives the published tags",
         Known_Tags'Access);
      Add
        (Suite, "SEC-1 mark, fields and number are where they belong",
         Places_On_The_Wire'Access);
      Add
        (Suite, "SEC-1 FTI-12 D-98 D-11 words come through a seal in 12 bits",
         Words_Come_Through'Access);
      Add
        (Suite, "SEC-3 three blocks make a session",
         Three_Steps'Access);
      Add
        (Suite, "SEC-4 a block is taken once, and none older",
         Taken_Once'Access);
      Add
        (Suite, "SEC-4 a number goes on after losses", Losses'Access);
      Add
        (Suite, "SEC-4 a block that comes late is refused",
         Late_Blocks'Access);
      Add
        (Suite, "SEC-4 blocks of a growing delay are refused",
         A_Growing_Delay'Access);
      Add
        (Suite, "SEC-1 a block with any one bit altered is refused",
         Every_Bit_Counts'Access);
      Add
        (Suite, "SEC-3 a block of the other direction is refused",
         Other_Direction'Access);
      Add
        (Suite, "SEC-3 a block of another session is refused",
         Other_Session'Access);
      Add (Suite, "SEC-5 another key opens nothing", Other_Key'Access);
      Add
        (Suite, "SEC-5 while a key is changed two are good",
         Key_Change'Access);
      Add
        (Suite, "SEC-5 an answer has the key of its call",
         Key_Of_The_Call'Access);
      Add
        (Suite, "SEC-3 an answer to another ground ends no session",
         Answer_To_Another'Access);
      Add
        (Suite, "SEC-3 after a start of the ground they shake hands",
         Ground_Restarts'Access);
      Add
        (Suite, "SEC-3 after a start of the aircraft they shake hands",
         Aircraft_Restarts'Access);
      Add
        (Suite, "SEC-3 hellos of before end no session",
         Hellos_Are_Disregarded'Access);
      Add
        (Suite, "SEC-3 recorded hellos lock no node out",
         Hellos_Lock_Nobody_Out'Access);
      Add
        (Suite, "SEC-4 a session that was silent for a minute is renewed",
         Long_Silence'Access);
      Add
        (Suite, "SEC-4 a node that stood still has a session at once",
         A_Node_Stands_Still'Access);
      Add
        (Suite, "SEC-1 a node takes only its configured format",
         One_Format'Access);
      Add
        (Suite, "SEC-4 a session whose numbers are used up is renewed",
         Numbers_Used_Up'Access);
   end Add_To;

end Seal_Tests;
