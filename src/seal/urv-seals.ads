--  SPDX-License-Identifier: Apache-2.0

--  The life of a block on a sealed link (SEC-1 to SEC-5, FRM-7). TELOUT closes
--  each block; TELIN opens each one received. Pass, Open and Close assign the
--  results of the functions here. Configure and Restart are in place: a copy
--  of a seal on a stack would be a copy of its keys (SEC-5).

with Telemetry;        use Telemetry;
with URVOS;            use URVOS;
with URV.Frame_Times;  use URV.Frame_Times;
with URV.Handshakes;   use URV.Handshakes;
with URV.Plain_Blocks; use URV.Plain_Blocks;
with URV.Seal_Blocks;  use URV.Seal_Blocks;
with URV.Sessions;     use URV.Sessions;

package URV.Seals with Pure, SPARK_Mode is

   procedure Configure
     (This   : in out Seal;
      Format : Format_Number;
      Keys   : Key_List;
      Start  : Nonce)
   with
     Global => null,
     Post   => This = New_Seal (This'Old.Role, Format, Keys, Start);

   procedure Restart (This : in out Seal)
   with
     Global => null,
     Post   => This = Restarted (This'Old);

   --  The first pending session that a sealed block opens, or 0.
   type Pending_Count is range 0 .. Pending_Place'Last;

   function Opened_Place (This : Seal; Block : Block_Data)
     return Pending_Count
   is
     (if Opens (Block, Other (This.Role), This.Pending (1)) then 1
      elsif Opens (Block, Other (This.Role), This.Pending (2)) then 2
      elsif Opens (Block, Other (This.Role), This.Pending (3)) then 3
      elsif Opens (Block, Other (This.Role), This.Pending (4)) then 4
      else 0)
   with Global => null;

   --  The outcome of any block. Format 1 takes all blocks except those with a
   --  mark of format 2.
   function Outcome_Of
     (This    : Seal;
      Block   : Block_Data;
      Arrived : Boolean) return Outcome
   is
     (if not Arrived then Nothing_Came
      elsif This.Format = 1
      then (if Mark_Of (Block) in Sealed_Mark | Hello_Mark then Wrong_Format
            else Opened)
      elsif Mark_Of (Block) = Sealed_Mark
      then (if Opens (Block, Other (This.Role), This.Active) then Opened
            elsif Opened_Place (This, Block) > 0 then Opened_New_Session
            elsif Is_Sealed (Block, Other (This.Role), This.Active)
            then Too_Late
            else Not_Opened)
      elsif Block (1) = Hello_Mark then Outcome_Of_Hello (This, Block)
      else Wrong_Format)
   with Global => null;

   --  A block of the active session does not clear the pending ones: an answer
   --  may be on its way to a ground that gives this session up.
   function With_Active (This : Seal; Item : Session; Pending : Pending_List)
     return Seal
   is
     ((This with delta
         Active   => Item,
         Pending  => Pending,
         In_Doubt => False,
         Silence  => 0))
   with Ghost, Global => null;

   function After
     (This   : Seal;
      Block  : Block_Data;
      Result : Outcome) return Seal
   is
     (if This.Format = 1 then This
      else
        (case Result is
            when Opened      =>
              With_Active
                (This, With_Newest (This.Active, Block, Other (This.Role)),
                 This.Pending),
            when Opened_New_Session =>
              With_Active
                (This,
                 With_Newest
                   (This.Pending
                      (Pending_Place (Opened_Place (This, Block))),
                    Block, Other (This.Role)),
                 None_Pending),
            when Hello_Taken => After_Hello (This, Block),
            when others      => This))
   with
     Ghost,
     Global => null,
     Pre    => Result = Outcome_Of (This, Block, True)
       or else Result = Nothing_Came;

   --  A node that has a session and must also send a hello alternates between
   --  them. It answers no call in a frame in which a block of the session came

   function To_Answer (This : Seal) return Pending_Place is
     (if Is_Answered (This.Pending (This.Turn)) then This.Turn
      elsif Is_Answered (This.Pending (Next_Place (This.Turn)))
      then Next_Place (This.Turn)
      elsif Is_Answered (This.Pending (Next_Place (Next_Place (This.Turn))))
      then Next_Place (Next_Place (This.Turn))
      else Next_Place (Next_Place (Next_Place (This.Turn))))
   with Global => null;

   function Answers (This : Seal) return Boolean is
     (Is_Answered (This.Pending (To_Answer (This))))
   with Global => null;

   function Sends_Hello (This : Seal) return Boolean is
     (not This.Active.Is_Present
      or else
        (This.Active.Age mod 2 = 0
         and then
           (This.In_Doubt or else (Answers (This) and then This.Silence > 0))))
   with Global => null;

   --  Frames pass; in the first of them the node has sent its block. The
   --  ground gives up a session without a block for 0.5 s, and the aircraft
   --  its pending sessions. The aircraft gives up its active session after a
   --  minute without a block

   Handshake_Lasts : constant := 5 * Frames_Per_Tenth;

   function Is_Over (Item : Session) return Boolean is
     (Item.Newest = 0 and then Item.Age > Handshake_Lasts)
   with Global => null;

   function Kept (Item : Session) return Session is
     (if Is_Over (Item) then No_Session else Item)
   with Global => null;

   function Silence_After (This : Seal; Frames : Counter) return Frame_Count
   is
     (if Frames >= Longest_Silence - This.Silence then Longest_Silence
      else This.Silence + Frames)
   with Global => null;

   function After_Frames (This : Seal; Frames : Counter) return Seal is
     ((This with delta
         Active  =>
           (if This.Role = Aircraft
              and then Silence_After (This, Frames) = Longest_Silence
            then No_Session
            else Kept (Older (This.Active, Frames))),
         Pending =>
           [for Each in Pending_Place =>
              Kept (Older (This.Pending (Each), Frames))],
         Turn    =>
           (if Frames > 0 and then Sends_Hello (This)
            then Next_Place (To_Answer (This)) else This.Turn),
         Silence => Silence_After (This, Frames)))
   with Global => null;

   procedure Pass (This : in out Seal; Frames : Counter)
   with
     Global => null,
     Post   => This = After_Frames (This'Old, Frames);

   --  The words of a block that is taken.
   function Words_In (This : Seal; Block : Block_Data) return Block_Words is
     (if This.Format = 1 then Decode (Block, Words_Of (Other (This.Role)))
      else Unpacked (Block, Other (This.Role)))
   with Global => null;

   --  Opens a block, if one came in this frame. Words are those of a block
   --  that is taken, or zeros.
   procedure Open
     (This    : in out Seal;
      Block   : Block_Data;
      Arrived : Boolean;
      Words   : out Block_Words;
      Result  : out Outcome)
   with
     Global => null,
     Post   =>
       Result = Outcome_Of (This'Old, Block, Arrived)
       and then This = After (This'Old, Block, Result)
       and then This.Format = This'Old.Format
       and then This.Role = This'Old.Role
       and then Words =
         (if Result in Taken then Words_In (This'Old, Block)
          else Block_Words'[others => 0]);

   --  A block to send

   function Own_Hello (This : Seal) return Block_Data is
     (if Answers (This)
      then Hello (This.Pending (To_Answer (This)).Number,
                  This.Pending (To_Answer (This)).Aircraft_Nonce,
                  This.Pending (To_Answer (This)).Ground_Nonce)
      else Hello (This.Keys (First).Number, This.Own, 0))
   with Global => null;

   function Closed_Hello (This : Seal) return Block_Data is
     (With_Tag
        (Own_Hello (This), This.Role,
         Tag_Of
           (Own_Hello (This), This.Role, 0, 0,
            Found_Hello_Key
              (This, Hello_Number (Own_Hello (This)), This.Role))))
   with Global => null;

   function Sealed
     (Data   : Block_Words;
      Sender : Station;
      Number : Counter;
      Echo   : Counter;
      Inside : Session) return Block_Data
   is
     (With_Tag
        (Packed (Data, Sender, Number, Echo), Sender,
         Tag_Of
           (Packed (Data, Sender, Number, Echo), Sender, Number, Echo,
            Key_Of (Inside, Sender))))
   with Global => null;

   --  Renews the state before a block is sent if the session's numbers are
   --  used up.
   function Renewed (This : Seal) return Seal is
     (if This.Active.Is_Present and then This.Active.Age = Last_Age
      then Restarted (This)
      else This)
   with Ghost, Global => null;

   function Closed (This : Seal; Data : Block_Words) return Block_Data is
     (if This.Format = 1 then Encode (Data, Words_Of (This.Role))
      elsif Sends_Hello (This) then Closed_Hello (This)
      else Sealed
        (Data, This.Role, This.Active.Age, Echo_Now (This.Active),
         This.Active))
   with Global => null;

   procedure Close
     (This : in out Seal; Data : Block_Words; Block : out Block_Data)
   with
     Global => null,
     Post   =>
       Block = Closed (Renewed (This'Old), Data)
       and then This = Renewed (This'Old);

end URV.Seals;
