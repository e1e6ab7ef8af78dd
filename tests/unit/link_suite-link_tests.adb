--  SPDX-License-Identifier: Apache-2.0

with Checks;           use Checks;
with Expect_Value;
with Expectations;     use Expectations;
with Link_Rig;         use Link_Rig;
with URVOS;            use URVOS;
with Telemetry;        use Telemetry;
with Telemetry.Boards; use Telemetry.Boards;
with Telemetry.Checksum;
with Telemetry.Headers;
with Telemetry.Memory; use Telemetry.Memory;
with Telemetry.Turns;  use Telemetry.Turns;

separate (Link_Suite)
package body Link_Tests is

   --  The tests, in order.
   procedure Sequence;
   procedure Bandwidth;
   procedure Any_Phase;
   procedure At_Once;
   procedure Good_Status;
   procedure Retry;
   procedure No_Answer;
   procedure Scrap;
   procedure Scrap_Downlink;
   procedure Ask_Twice;
   procedure Two_Full;
   procedure Not_Taken;
   procedure Busy_Meanwhile;
   procedure Permission;
   procedure Permission_Kept;
   procedure Priority;
   procedure Retry_Priority;
   procedure Nothing_To_Send;
   procedure Idles;
   procedure Puts_Always;
   procedure Told_Before;
   procedure Messages;
   procedure Every_Fault;
   procedure One_More;
   procedure Cuts;
   procedure Storm;
   procedure Restarts;
   procedure Clearings;

   type Byte_List is array (Positive range <>) of Byte;

   procedure Expect is new Expect_Value (Station);
   procedure Expect is new Expect_Value (Character_Times);

   --  The turns of the line so far: the sender and the number of characters.
   type Turns is array (Positive range <>) of Transmission;
   procedure Expect_Turns (Item : Link; Expected : Turns);

   --  Expects the block that a station takes.
   procedure Expect_Block
     (Item       : in out Link;
      At_Station : Station;
      Expected   : Byte);

   --  After two frames to recover, three frames must deliver each block, once,
   --  without a reset.
   procedure Expect_Recovered (What : String; Item : in out Link);

   --  The fault under test, for the library-level procedures below.
   Spoilt_Sender : Station;
   First_Spoilt  : Natural;
   Last_Spoilt   : Natural;
   Spoilt_How    : Arrival;
   Spoilt_Mask   : Byte;

   --  Spoils the characters chosen above.
   procedure Spoil
     (Sender : Station;
      Number : Positive;
      What   : out Arrival;
      Mask   : out Byte);

   --  Loses every character.
   procedure Cut
     (Sender : Station;
      Number : Positive;
      What   : out Arrival;
      Mask   : out Byte);

   procedure Expect_Turns (Item : Link; Expected : Turns) is
   begin
      for I in Expected'Range loop
         Expect
           ("sender of turn" & I'Image, Item.Trace (I).Sender,
            Expected (I).Sender);
         Expect_Number
           ("characters of turn" & I'Image, Item.Trace (I).Length,
            Expected (I).Length);
      end loop;
      Expect_Number ("turns", Item.Turns, Expected'Length);
   end Expect_Turns;

   procedure Expect_Block
     (Item       : in out Link;
      At_Station : Station;
      Expected   : Byte)
   is
      Mark : Byte;
   begin
      Take (Item, At_Station, Mark);
      Expect ("block at the " & At_Station'Image, Mark, Expected);
   end Expect_Block;

   procedure Spoil
     (Sender : Station;
      Number : Positive;
      What   : out Arrival;
      Mask   : out Byte) is
   begin
      What :=
        (if Sender = Spoilt_Sender and then Number >= First_Spoilt
           and then Number <= Last_Spoilt
         then Spoilt_How else Whole);
      Mask := Spoilt_Mask;
   end Spoil;

   procedure Cut
     (Sender : Station;
      Number : Positive;
      What   : out Arrival;
      Mask   : out Byte)
   is
      pragma Unreferenced (Sender, Number);
   begin
      What := Lost;
      Mask := 0;
   end Cut;

   procedure Expect_Recovered (What : String; Item : in out Link) is
      Up, Down : Count;
      Before   : Count;
      Mark     : Byte;
   begin
      Fly (Item, 2, 101, Phase => 40);
      Before := Resets (Item);
      Up     := Control_Of (Item.Aircraft_Board).Messages;
      Down   := Control_Of (Item.Ground_Board).Messages;
      for Number in Byte range 103 .. 105 loop
         Give (Item, Ground, Number);
         Give (Item, Aircraft, Number);
         Run (Item, Frame);
         Take (Item, Aircraft, Mark);
         Expect (What & ": block up", Mark, Number);
         Take (Item, Ground, Mark);
         Expect (What & ": block down", Mark, Number);
      end loop;
      Expect
        (What & ": blocks up",
         Control_Of (Item.Aircraft_Board).Messages - Up, 3);
      Expect
        (What & ": blocks down",
         Control_Of (Item.Ground_Board).Messages - Down, 3);
      Expect (What & ": resets", Resets (Item), Before);
   end Expect_Recovered;

   procedure Sequence is
      Item : Link;
   begin
      Give (Item, Ground, 1);
      Give (Item, Aircraft, 2);
      Run (Item, Frame);
      Expect_Turns
        (Item,
         ((Ground, Up_Data),       --  data
          (Aircraft, 1),     --  status
          (Ground, 1),       --  command to downlink
          (Aircraft, Down_Data),   --  data
          (Ground, 1)));     --  status
      Expect_Block (Item, Aircraft, 1);
      Expect_Block (Item, Ground, 2);
   end Sequence;

   procedure Bandwidth is
      Ticks  : constant := 10;
      Before : Character_Counts;
   begin
      for Phase in 0 .. Ticks - 1 loop
         declare
            Item : Link;
         begin
            Fly (Item, 2, 1, Phase * Frame / Ticks);
            for Number in Byte range 3 .. 10 loop
               Before := Item.Sent;
               Fly (Item, 1, Number, Phase * Frame / Ticks);
               Expect_Number
                 ("phase" & Phase'Image & ", characters up",
                  Item.Sent (Ground) - Before (Ground), Up_Data + 2);
               Expect_Number
                 ("phase" & Phase'Image & ", characters down",
                  Item.Sent (Aircraft) - Before (Aircraft), Down_Data + 1);
            end loop;
         end;
      end loop;
   end Bandwidth;

   procedure Any_Phase is
      Frames : constant := 8;
   begin
      --  In some phase the aircraft's block comes just after the request. Two
      --  frames then make one message.
      for Phase in 0 .. Frame - 1 loop
         declare
            Item : Link;
         begin
            Fly (Item, Frames, 1, Phase);
            Expect
              ("phase" & Phase'Image & ", blocks up",
               Control_Of (Item.Aircraft_Board).Messages, Frames);
            Expect
              ("phase" & Phase'Image & ", less than half the blocks down",
               Control_Of (Item.Ground_Board).Messages < Frames / 2, False);
            Expect ("phase" & Phase'Image & ", resets", Resets (Item), 0);
         end;
      end loop;
   end Any_Phase;

   procedure At_Once is
      Item : Link;
   begin
      Give (Item, Ground, 1);
      Run (Item, Up_Data + 1);
      Expect
        ("too early", Control_Of (Item.Aircraft_Board).Messages, 0);
      Run (Item, 1);
      Expect_Number ("before the status", Item.Sent (Aircraft), 0);
      Expect ("block received", Control_Of (Item.Aircraft_Board).Messages, 1);
      Run (Item, 1);
      Expect_Number ("with the status", Item.Sent (Aircraft), 1);
   end At_Once;

   procedure Good_Status is
      Item : Link;
   begin
      Give (Item, Ground, 1);
      Expect ("full", Any_Full (Transmit_Pair (Item.Ground_Board)), True);
      Run (Item, Up_Data + 2);
      Expect
        ("full before the status",
         Any_Full (Transmit_Pair (Item.Ground_Board)), True);
      Run (Item, 1);
      Expect
        ("full after the status", Any_Full (Transmit_Pair (Item.Ground_Board)),
         False);
      for Which in Slot loop
         Expect
           ("busy after the status",
            Transmit_Pair (Item.Ground_Board).Slots (Which).Busy, False);
      end loop;
   end Good_Status;

   procedure Retry is
      Item : Link;
   begin
      --  The first transmission is spoilt, the second is not.
      Spoilt_Sender := Ground;
      First_Spoilt  := 5;
      Last_Spoilt   := 5;
      Spoilt_How    := Changed;
      Spoilt_Mask   := 3;
      Give (Item, Ground, 1);
      Run (Item, Frame, Spoil'Access);
      Expect_Turns
        (Item,
         ((Ground, Up_Data), (Aircraft, 1), (Ground, Up_Data), (Aircraft, 1)));
      Expect_Block (Item, Aircraft, 1);
      Expect ("sent", Tally (Item.Ground_Board).Sent, 2);
      Expect ("scrapped", Tally (Item.Ground_Board).Scrapped, 0);
      Expect ("bad", Tally (Item.Aircraft_Board).Bad, 1);
      Expect ("received", Tally (Item.Aircraft_Board).Received, 1);
   end Retry;

   procedure No_Answer is
      Item : Link;
   begin
      --  The aircraft's first answer is lost: dead space and the ground's idle
      --  time follow, then the same block.
      Spoilt_Sender := Aircraft;
      First_Spoilt  := 1;
      Last_Spoilt   := 1;
      Spoilt_How    := Lost;
      Give (Item, Ground, 1);
      Run (Item, Frame, Spoil'Access);
      Expect_Turns
        (Item,
         ((Ground, Up_Data), (Aircraft, 1), (Ground, Up_Data), (Aircraft, 1)));
      Expect ("sent", Tally (Item.Ground_Board).Sent, 2);
      Expect ("reset", Tally (Item.Ground_Board).Resets, 1);
      Expect ("scrapped", Tally (Item.Ground_Board).Scrapped, 0);
      Expect ("received", Tally (Item.Aircraft_Board).Received, 2);
   end No_Answer;

   procedure Scrap is
      Item : Link;
   begin
      --  Both transmissions are spoilt; there is no third.
      Spoilt_Sender := Ground;
      First_Spoilt  := 5;
      Last_Spoilt   := 35;
      Spoilt_How    := Odd_Parity;
      Spoilt_Mask   := 1;
      Give (Item, Ground, 1);
      Run (Item, Up_Data, Spoil'Access);
      First_Spoilt := Up_Data + 2;
      Run (Item, Frame, Spoil'Access);
      Expect_Turns
        (Item,
         ((Ground, Up_Data), (Aircraft, 1), (Ground, Up_Data), (Aircraft, 1)));
      Expect_Block (Item, Aircraft, 0);
      Expect ("scrapped", Tally (Item.Ground_Board).Scrapped, 1);
      Expect ("full", Any_Full (Transmit_Pair (Item.Ground_Board)), False);

      --  The next block is sent as usual.
      Give (Item, Ground, 2);
      Run (Item, Frame);
      Expect_Block (Item, Aircraft, 2);
      Expect ("sent", Tally (Item.Ground_Board).Sent, 3);
   end Scrap;

   procedure Scrap_Downlink is
      Item : Link;
   begin
      --  Character 1 of the aircraft is its status, the later ones its data.
      Spoilt_Sender := Aircraft;
      First_Spoilt  := 10;
      Last_Spoilt   := 10;
      Spoilt_How    := Changed;
      Spoilt_Mask   := 16#0F#;
      Give (Item, Ground, 1);
      Give (Item, Aircraft, 9);
      Run (Item, Frame, Spoil'Access);
      Expect_Turns
        (Item,
         ((Ground, Up_Data), (Aircraft, 1), (Ground, 1), (Aircraft, Down_Data),
          (Ground, 2),       --  bad status, command again
          (Aircraft, Down_Data), (Ground, 1)));
      Expect_Block (Item, Ground, 9);
      Expect ("scrapped", Tally (Item.Aircraft_Board).Scrapped, 0);

      --  The same twice.
      Give (Item, Ground, 2);
      Give (Item, Aircraft, 10);
      First_Spoilt := Item.Sent (Aircraft) + 10;
      Last_Spoilt  := First_Spoilt + Down_Data;
      Run (Item, Frame, Spoil'Access);
      Expect_Block (Item, Ground, 0);
      Expect ("scrapped", Tally (Item.Aircraft_Board).Scrapped, 1);

      Give (Item, Ground, 3);
      Give (Item, Aircraft, 11);
      Run (Item, Frame);
      Expect_Block (Item, Ground, 11);
   end Scrap_Downlink;

   procedure Ask_Twice is
      Item : Link;
   begin
      Spoilt_Sender := Aircraft;
      First_Spoilt  := 10;
      Last_Spoilt   := 10;
      Spoilt_How    := Changed;
      Spoilt_Mask   := 16#0F#;
      Give (Item, Ground, 1);
      Give (Item, Aircraft, 9);

      --  The second transmission has begun, and will also be bad.
      Run (Item, 96, Spoil'Access);
      First_Spoilt  := 68;
      Last_Spoilt   := 68;
      Run (Item, Frame, Spoil'Access);
      Expect_Turns
        (Item,
         ((Ground, Up_Data), (Aircraft, 1), (Ground, 1), (Aircraft, Down_Data),
          (Ground, 2), (Aircraft, Down_Data),
          (Ground, 1)));     --  bad status, and no command
      Expect ("scrapped", Tally (Item.Aircraft_Board).Scrapped, 1);
      Expect ("resets", Resets (Item), 0);
   end Ask_Twice;

   procedure Two_Full is
      Item : Link;
   begin
      Give (Item, Ground, 1);
      Give (Item, Ground, 2);
      Expect
        ("both full", Both_Full (Transmit_Pair (Item.Ground_Board)), True);
      Run (Item, Frame);
      Expect_Number ("characters", Item.Sent (Ground), Up_Data);
      Expect_Block (Item, Aircraft, 2);
      Expect ("sent", Tally (Item.Ground_Board).Sent, 1);
      Expect ("cleared", Tally (Item.Ground_Board).Cleared, 1);
      Expect ("full", Any_Full (Transmit_Pair (Item.Ground_Board)), False);
   end Two_Full;

   procedure Not_Taken is
      Item : Link;
      Mark : Byte;
   begin
      --  No controller takes the first block, nor the second: each newer one
      --  finds one that will never be taken.
      for Block in Byte range 1 .. 3 loop
         Give (Item, Ground, Block);
         Run (Item, Frame);
         Expect
           ("not taken after block" & Block'Image,
            Tally (Item.Aircraft_Board).Not_Taken, Count (Block) - 1);
      end loop;
      Expect ("received", Tally (Item.Aircraft_Board).Received, 3);
      Take (Item, Aircraft, Mark);
      Expect ("the newest", Mark, 3);

      --  A block that was taken in time is not counted.
      Give (Item, Ground, 4);
      Run (Item, Frame);
      Expect ("not taken", Tally (Item.Aircraft_Board).Not_Taken, 2);
      Expect_Block (Item, Aircraft, 4);
   end Not_Taken;

   procedure Busy_Meanwhile is
      Item : Link;
      Busy : Natural;
   begin
      Give (Item, Ground, 1);
      for Time in 1 .. Up_Data loop
         Run (Item, 1);
         Busy := 0;
         for Each of Transmit_Pair (Item.Ground_Board).Slots loop
            Busy := Busy + (if Each.Busy then 1 else 0);
         end loop;
         Expect_Number ("busy buffers at" & Time'Image, Busy, 1);

         --  The controller's new data is never mixed in.
         Give (Item, Ground, 2);
      end loop;
      Run (Item, 2);
      Expect_Block (Item, Aircraft, 1);
      Run (Item, Frame);
      Expect_Block (Item, Aircraft, 2);
   end Busy_Meanwhile;

   procedure Permission is
      Item : Link;
   begin
      --  Without a message from the ground the aircraft is silent.
      Give (Item, Aircraft, 1);
      Run (Item, 10 * Frame);
      Expect_Number ("characters down", Item.Sent (Aircraft), 0);

      --  With one it asks, gets permission, and sends.
      Give (Item, Ground, 2);
      Run (Item, Frame);
      Expect_Block (Item, Ground, 1);
   end Permission;

   procedure Permission_Kept is
      package Headers renames Telemetry.Headers;

      Up   : constant Byte := Headers.Encode ((Headers.Data, 2));
      Item : Board := New_Board (Aircraft, 4, 2);
      Send : Boolean;
      Data : Byte;
      Lost : Boolean;
   begin
      --  The ground permits a block, but sends a block of its own before the
      --  aircraft uses the permission.
      Put (Item, (others => 0), Lost);
      Accept_Character
        (Item, Headers.Encode ((Kind => Headers.Command_To_Downlink)),
         Parity_Error => False);
      for Each of Byte_List'
        (Up, 0, 0, Checksum.Of_Message (Up, (others => 0), 2))
      loop
         Accept_Character (Item, Each, Parity_Error => False);
      end loop;
      Elapse (Item, Guard_Time);

      --  The aircraft answers first. Then it sends, as permitted.
      Next_Character (Item, Send, Data);
      Expect ("an answer", Send, True);
      Expect ("it is good", Headers.Decode (Data).Good, True);
      Next_Character (Item, Send, Data);
      Expect ("a block", Send, True);
      Expect
        ("its header", Data, Headers.Encode ((Headers.Data, Length => 4)));
   end Permission_Kept;

   procedure Priority is
      Item : Link;
   begin
      --  New data at the ground comes while the aircraft asks to downlink.
      Give (Item, Aircraft, 7);
      Give (Item, Ground, 1);
      Run (Item, Up_Data - 1);
      Give (Item, Ground, 2);
      Run (Item, Frame);
      Expect_Turns
        (Item,
         ((Ground, Up_Data), (Aircraft, 1), (Ground, Up_Data), (Aircraft, 1),
          (Ground, 1), (Aircraft, Down_Data), (Ground, 1)));
      Expect_Block (Item, Aircraft, 2);
      Expect_Block (Item, Ground, 7);
   end Priority;

   procedure Retry_Priority is
      Item : Link;
   begin
      --  The retry precedes the requested downlink.
      Spoilt_Sender := Ground;
      First_Spoilt  := 8;
      Last_Spoilt   := 8;
      Spoilt_How    := Odd_Parity;
      Spoilt_Mask   := 4;
      Give (Item, Aircraft, 7);
      Give (Item, Ground, 1);
      Run (Item, Frame, Spoil'Access);
      Expect_Turns
        (Item,
         ((Ground, Up_Data), (Aircraft, 1), (Ground, Up_Data), (Aircraft, 1),
          (Ground, 1), (Aircraft, Down_Data), (Ground, 1)));
   end Retry_Priority;

   procedure Nothing_To_Send is
      Item : Link;
   begin
      --  A silent link is not an error.
      Run (Item, 100 * Frame);
      Expect_Number ("up", Item.Sent (Ground), 0);
      Expect_Number ("down", Item.Sent (Aircraft), 0);
      Expect ("resets", Resets (Item), 0);
      Expect_Recovered ("after silence", Item);
   end Nothing_To_Send;

   procedure Idles is
      Item : Link;
   begin
      --  The exchange ends with the aircraft's status, after 33 or 34.
      Give (Item, Ground, 1);
      Run (Item, 36);
      Expect
        ("the ground idles", Control_Of (Item.Ground_Board).State = Idling,
         True);
      Run (Item, Positive (Idle_Time) + 2);
      Expect
        ("the ground is ready", Control_Of (Item.Ground_Board).State = Ready,
         True);
      Expect ("it was no reset", Resets (Item), 0);
   end Idles;

   procedure Puts_Always is
      --  Two messages with their answers take at least 66 characters.
      Most : constant Positive :=
        2 * (5 * Frame / (66 + Positive (Idle_Time)) + 1);
      Item : Link;
   begin
      Give (Item, Aircraft, 7);
      for Time in 1 .. 5 * Frame loop
         Give (Item, Ground, Byte (Time mod 250) + 1);
         Run (Item, 1);
      end loop;

      --  Without the silence there would be more messages.
      Expect
        ("messages between idle times",
         Integer (Tally (Item.Ground_Board).Sent) in Most - 4 .. Most, True);
      Expect_Block (Item, Ground, 7);
      Expect ("resets", Resets (Item), 0);
   end Puts_Always;

   procedure Told_Before is
      --  The longest announced waits.
      type Longest_Waits is array (Station) of Character_Times;
      Idle : Character_Times := 0;
      Dead : Longest_Waits   := (others => 0);

      --  Expects that a board keeps the wait that it announced.
      procedure Expect_Kept (What : String; Now : Board);

      procedure Expect_Kept (What : String; Now : Board) is
         Left      : constant Character_Times := Time_Left (Now);
         Before    : constant Control         := Control_Of (Now);
         Then_Item : Board                    := Now;
      begin
         if Left = Character_Times'Last then
            Elapse (Then_Item, 100);
            Expect (What & " stays as it is", Then_Item = Now, True);
            return;
         end if;

         Expect (What & " has time left", Left > 0, True);
         if Before.State = Idling then
            Idle := Character_Times'Max (Idle, Left);
         else
            Dead (Before.Role) :=
              Character_Times'Max (Dead (Before.Role), Left);
         end if;
         Elapse (Then_Item, Left - 1);
         Expect
           (What & " waits", Control_Of (Then_Item).State = Before.State,
            True);
         Expect_Number
           (What & " has been silent",
            Integer (Control_Of (Then_Item).Silence),
            Integer (Before.Silence + Left) - 1);
         Elapse (Then_Item, 1);
         Expect
           (What & " starts afresh", Control_Of (Then_Item).Silence, 0);
      end Expect_Kept;

      Item : Link;
   begin
      Give (Item, Ground, 1);
      Give (Item, Aircraft, 1);
      for Time in 1 .. Frame loop
         --  The line is cut from the middle of the downlink on.
         Run (Item, 1, (if Time > Frame / 3 then Cut'Access else null));
         Expect_Kept ("the ground at" & Time'Image, Item.Ground_Board);
         Expect_Kept ("the aircraft at" & Time'Image, Item.Aircraft_Board);
      end loop;
      Expect ("the ground waits", Dead (Ground), Dead_Space);
      Expect ("the aircraft waits", Dead (Aircraft), Dead_Space);
      Expect ("the ground idles", Idle, Idle_Time);
   end Told_Before;

   procedure Messages is
      Item  : Link;
      Data  : Block_Data;
      Fresh : Boolean;
      Ever  : Boolean;
   begin
      Take (Item.Aircraft_Board, Data, Fresh, Ever);
      Expect ("fresh before the first", Fresh, False);
      Expect ("ever before the first", Ever, False);
      for Number in Count range 1 .. 20 loop
         Give (Item, Ground, Byte (Number));
         Run (Item, Frame);
         Expect
           ("messages", Control_Of (Item.Aircraft_Board).Messages,
            Number);
      end loop;
      Take (Item.Aircraft_Board, Data, Fresh, Ever);
      Expect ("fresh", Fresh, True);
      Take (Item.Aircraft_Board, Data, Fresh, Ever);
      Expect ("fresh twice", Fresh, False);
      Expect ("ever, later", Ever, True);
   end Messages;

   procedure Every_Fault is
      type Mask_List is array (Positive range <>) of Byte;
      Masks : constant Mask_List := (1, 16#C0#, 16#FF#);
   begin
      --  Each character of a frame is spoilt in turn, in each way. It is the
      --  third frame, when the exchange is regular.
      for Sender in Station loop
         for Number in
           1 .. (if Sender = Ground then Up_Data + 2 else Down_Data + 1)
         loop
            for How in Changed .. Doubled loop
               for Mask of Masks
                 when Is_Tried (Number + Arrival'Pos (How) + Natural (Mask))
               loop
                  declare
                     Item : Link;
                  begin
                     Fly (Item, 2, 1, Phase => 40);
                     Spoilt_Sender := Sender;
                     First_Spoilt  := Item.Sent (Sender) + Number;
                     Last_Spoilt   := First_Spoilt;
                     Spoilt_How    := How;
                     Spoilt_Mask   := Mask;
                     Fly (Item, 1, 3, Phase => 40, Fault => Spoil'Access);
                     Expect_Recovered
                       (Sender'Image & Number'Image & " " & How'Image
                         & Mask'Image,
                        Item);
                  end;
               end loop;
            end loop;
         end loop;
      end loop;
   end Every_Fault;

   procedure One_More is
      Tried : Natural := 0;

      --  A message with one extra character, of any value.
      type Byte_Set is array (Byte) of Boolean;
      Every : constant Byte_Set := (others => True);

      --  Contracts distinguish only whether a character is a header or the
      --  checksum. If they are executed, which takes a hundred times as long,
      --  only these changes are tried: no bit, each bit, and all bits.
      Some_Of_Them : constant Byte_Set :=
        (0 | 1 | 2 | 4 | 8 | 16 | 32 | 64 | 128 | 255 => True,
         others                                       => False);
      Masks : constant Byte_Set :=
        (if Contracts_Are_Executed then Some_Of_Them else Every);
   begin
      --  Every character of a data message, either way, is followed by one
      --  more. The block is never taken before it is sent again, and never
      --  wrong (Take checks this).
      for Sender in Station loop
         for Number in
           1 .. (if Sender = Ground then Up_Data else Down_Data)
         loop
            for Mask in Byte when Masks (Mask) loop
               declare
                  Item : Link;
               begin
                  Give (Item, Ground, 1);
                  Give (Item, Aircraft, 1);
                  Spoilt_Sender := Sender;
                  First_Spoilt  := Number + (if Sender = Ground then 0 else 1);
                  Last_Spoilt   := First_Spoilt;
                  Spoilt_How    := Doubled;
                  Spoilt_Mask   := Mask;
                  Run (Item, Frame, Spoil'Access);
                  Tried := Tried + 1;
                  Expect_Block
                    (Item, (if Sender = Ground then Aircraft else Ground), 1);
                  Expect
                    (Sender'Image & Number'Image & Mask'Image & " bad",
                     Tally
                       (if Sender = Ground then Item.Aircraft_Board
                        else Item.Ground_Board).Bad,
                     1);
               end;
            end loop;
         end loop;
      end loop;
      Expect_Number
        ("tried", Tried,
         (Up_Data + Down_Data)
         * (if Contracts_Are_Executed then 10 else 256));
   end One_More;

   procedure Cuts is
      type Length_List is array (Positive range <>) of Positive;
      Lengths : constant Length_List :=
        (1, 2, 20, 24, 40, 300);
   begin
      --  The line is cut at any time of a frame, for a short or a long time.
      for Start in 0 .. Frame - 1 loop
         for Length of Lengths when Is_Tried (Start + Length) loop
            declare
               Item : Link;
            begin
               Fly (Item, 1, 1, Phase => 40);
               Give (Item, Ground, 2);
               Give (Item, Aircraft, 2);
               Run (Item, Start);
               Run (Item, Length, Cut'Access);
               Expect_Recovered
                 ("cut at" & Start'Image & " for" & Length'Image, Item);
            end;
         end loop;
      end loop;
   end Cuts;

   procedure Storm is
   begin
      Start_Rain;
      for Flight in 1 .. 100 when Is_Tried (Flight) loop
         declare
            Item : Link;
         begin
            Fly (Item, 50, 1, Phase => Flight mod Frame,
                 Fault => Rain'Access);
            Expect_Recovered ("storm" & Flight'Image, Item);
         end;
      end loop;
   end Storm;

   procedure Restarts is
   begin
      --  Either board starts again at any time of a frame.
      for Time in 0 .. Frame - 1 loop
         for Who in Station loop
            declare
               Item : Link;
            begin
               Fly (Item, 1, 1, Phase => 40);
               Give (Item, Ground, 2);
               Give (Item, Aircraft, 2);
               Run (Item, Time);
               if Who = Ground then
                  --  A board that starts is silent for its idle time.
                  Elapse (Item.Aircraft_Board, Idle_Time);
                  Start (Item.Ground_Board);
                  Expect
                    ("messages", Control_Of (Item.Ground_Board).Messages,
                     0);
               else
                  Start (Item.Aircraft_Board);
                  Expect
                    ("messages", Control_Of (Item.Aircraft_Board).Messages,
                     0);
               end if;
               Expect_Recovered (Who'Image & " started at" & Time'Image, Item);
            end;
         end loop;
      end loop;
   end Restarts;

   procedure Clearings is
      procedure Clear (What : String; Item : in out Board);

      Broken_Off : Natural := 0;

      procedure Clear (What : String; Item : in out Board) is
         Before : constant Control := Control_Of (Item);
      begin
         Clear_Transmit_Half (Item);
         Expect
           (What & ", empty", Transmit_Pair (Item) = Empty_Pair, True);
         if Has_Block_Out (Before) then
            Broken_Off := Broken_Off + 1;
            Expect
              (What & ", at rest",
               Control_Of (Item).State =
                 (if Before.Role = Ground then Idling else Ready),
               True);
            Expect (What & ", silence", Control_Of (Item).Silence, 0);
         else
            Expect
              (What & ", as before", Control_Of (Item).State = Before.State,
               True);
         end if;
      end Clear;
   begin
      --  Either controller starts again at any time of a frame.
      for Time in 0 .. Frame - 1 loop
         for Who in Station loop
            declare
               What : constant String :=
                 Who'Image & " cleared at" & Time'Image;
               Item : Link;
            begin
               Fly (Item, 1, 1, Phase => 40);
               Give (Item, Ground, 2);
               Give (Item, Aircraft, 2);
               Run (Item, Time);
               if Who = Ground then
                  Clear (What, Item.Ground_Board);
               else
                  Clear (What, Item.Aircraft_Board);
               end if;
               Expect_Recovered (What, Item);
            end;
         end loop;
      end loop;
      Expect ("boards broken off", Broken_Off > 80, True);
   end Clearings;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "LNK-2 data, status, command, data, status: in that order",
         Sequence'Access);
      Add
        (Suite, "D-5 two characters more than data go up and one down",
         Bandwidth'Access);
      Add
        (Suite, "D-12 in any phase blocks go up and down, without a reset",
         Any_Phase'Access);
      Add
        (Suite, "LNK-5 D-27 a data message is answered after the guard time",
         At_Once'Access);
      Add
        (Suite, "LNK-5 D-27 a message with one character more comes bad",
         One_More'Access);
      Add
        (Suite, "LNK-6 good status empties the transmit buffer",
         Good_Status'Access);
      Add
        (Suite, "LNK-6 a block that came bad is sent once more", Retry'Access);
      Add
        (Suite, "LNK-6 D-20 D-22 a block without an answer is sent again",
         No_Answer'Access);
      Add
        (Suite, "LNK-6 a block that came bad twice is scrapped", Scrap'Access);
      Add
        (Suite, "LNK-6 a downlink is repeated and scrapped just so",
         Scrap_Downlink'Access);
      Add
        (Suite, "LNK-8 a downlink that came bad twice is not asked for again",
         Ask_Twice'Access);
      Add
        (Suite, "LNK-7 of two full buffers the newest is sent, no other",
         Two_Full'Access);
      Add
        (Suite, "LNK-4 EXT-1 a block not taken in time is counted",
         Not_Taken'Access);
      Add
        (Suite, "LNK-7 D-18 D-24 a buffer is busy and whole while it is sent",
         Busy_Meanwhile'Access);
      Add
        (Suite, "LNK-8 the aircraft waits for permission", Permission'Access);
      Add
        (Suite, "LNK-8 a permission is kept while an answer is owed",
         Permission_Kept'Access);
      Add
        (Suite, "LNK-8 new data goes up before the downlink", Priority'Access);
      Add
        (Suite, "LNK-8 a retry goes up before the downlink",
         Retry_Priority'Access);
      Add
        (Suite, "LNK-9 silence without data is no error",
         Nothing_To_Send'Access);
      Add
        (Suite, "LNK-9 D-28 after an exchange the ground idles",
         Idles'Access);
      Add
        (Suite, "LNK-9 D-28 a ground with ever new blocks idles after two",
         Puts_Always'Access);
      Add
        (Suite, "LNK-9 D-7 a board reports its restart, and does",
         Told_Before'Access);
      Add
        (Suite, "LNK-10 the board counts the messages received",
         Messages'Access);
      Add
        (Suite, "LNK-9 any spoilt character is overcome in two frames",
         Every_Fault'Access);
      Add
        (Suite, "LNK-9 a cut at any time is overcome in two frames",
         Cuts'Access);
      Add
        (Suite, "LNK-9 a hundred storms: nothing wrong, old or stuck",
         Storm'Access);
      Add
        (Suite, "LNK-9 a board may start again at any time", Restarts'Access);
      Add
        (Suite, "INI-4 a transmit half may be cleared at any time",
         Clearings'Access);
   end Add_To;

end Link_Tests;
