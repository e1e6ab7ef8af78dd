--  SPDX-License-Identifier: Apache-2.0

--  What a node knows of its sealed link, and what becomes of a block (SEC-1
--  to SEC-5). TELOUT closes each block, TELIN opens each one that came.
--
--     ground                                    aircraft
--     hello (G)              ------------>      keeps G, takes a new A
--     both know G and A      <------------      hello (A, in answer to G)
--     sealed blocks 1, 2 ... ------------>      both know that both know
--                            <------------      sealed blocks 1, 2 ...
--
--  A node without a session says hello. One that hears its peer's sealed
--  blocks disregards a hello. The functions are the code: Open and Close
--  assign their results.

with Telemetry;       use Telemetry;
with URVOS;           use URVOS;
with URV.Seal_Blocks; use URV.Seal_Blocks;
with URV.Sessions;    use URV.Sessions;
with URV.Sip_Hash;    use URV.Sip_Hash;

package URV.Seals with Pure, SPARK_Mode is

   type Format_Number is range 1 .. 2;

   function Other (This : Station) return Station is
     (if This = Ground then Aircraft else Ground)
   with Global => null;

   --  The node. Silence is for how many frames no block has opened.

   Patience : constant := 3;

   --  A minute: less than an uplink's number tells.
   Longest_Silence : constant := 3_000;
   type Frame_Count is range 0 .. Longest_Silence;

   type Seal is record
      Role    : Station       := Ground;
      Format  : Format_Number := 1;
      Keys    : Key_List;
      Own     : Nonce         := 0;
      Active  : Session;

      --  The aircraft's: the one that it has answered a hello with.
      Pending : Session;
      Silence : Frame_Count   := 0;
   end record;

   --  As a node is configured before it is switched on. Start is a nonce
   --  that it has never begun with before.
   function New_Seal
     (Role   : Station;
      Format : Format_Number;
      Keys   : Key_List;
      Start  : Nonce) return Seal
   is
     ((Role    => Role,
       Format  => Format,
       Keys    => Keys,
       Own     => Start,
       Active  => No_Session,
       Pending => No_Session,
       Silence => 0))
   with Global => null;

   --  Sessions are forgotten: a cold start, or the end of their numbers.
   function Begun_Anew (This : Seal) return Seal is
     ((This with delta
         Own     => This.Own + 1,
         Active  => No_Session,
         Pending => No_Session))
   with Global => null;

   --  What has become of a block.
   type Outcome is
     (Nothing_Came,
      Opened,
      Opened_Anew,         --  the first of a session
      Hello_Taken,
      Hello_Repeated,      --  known already, or in answer to nothing

      --  Refused
      Wrong_Format,
      Not_Opened,          --  its tag or its number is wrong
      Unknown_Key,
      Hello_Out_Of_Turn);  --  there is a session

   subtype Taken is Outcome range Opened .. Opened_Anew;
   subtype Refused is Outcome range Wrong_Format .. Hello_Out_Of_Turn;

   --  A hello that came

   function Hello_Number (Block : Block_Data) return Key_Number is
     (Key_Number (Block (2)))
   with Global => null;

   function Hello_Key (From : Key; Sender : Station) return Key is
     (Derived
        (From, (if Sender = Ground then Hello_Up else Hello_Down), 0, 0))
   with Global => null;

   function Is_True (This : Seal; Block : Block_Data) return Boolean is
     (Has_Tag
        (Block, Other (This.Role),
         Tag_Of
           (Block, Other (This.Role), 0,
            Hello_Key
              (Found (This.Keys, Hello_Number (Block)),
               Other (This.Role)))))
   with Global => null;

   --  The ground calls: an answer is one to its own nonce.
   function Answer_Of_Hello (This : Seal; Block : Block_Data) return Outcome
   is
     (if not This.Active.Is_Present
      then
        (if Nonce_At (Block, Answered_Place) = This.Own
           and then Hello_Number (Block) = This.Keys (First).Number
         then Hello_Taken
         else Hello_Repeated)
      elsif Nonce_At (Block, Own_Place) = This.Active.Aircraft_Nonce
        and then Nonce_At (Block, Answered_Place) = This.Active.Ground_Nonce
      then (if This.Active.Newest = 0 then Hello_Repeated
            else Hello_Out_Of_Turn)
      elsif This.Silence < Patience then Hello_Out_Of_Turn
      else Hello_Taken)
   with Global => null;

   --  The aircraft answers.
   function Call_Of_Hello (This : Seal; Block : Block_Data) return Outcome is
     (if This.Pending.Is_Present
        and then Nonce_At (Block, Own_Place) = This.Pending.Ground_Nonce
        and then Hello_Number (Block) = This.Pending.Number
      then Hello_Repeated
      elsif This.Active.Is_Present
        and then (This.Silence < Patience
                  or else Nonce_At (Block, Own_Place)
                            = This.Active.Ground_Nonce)
      then Hello_Out_Of_Turn
      else Hello_Taken)
   with Global => null;

   function Outcome_Of_Hello (This : Seal; Block : Block_Data) return Outcome
   is
     (if not Is_Known (This.Keys, Hello_Number (Block)) then Unknown_Key
      elsif not Is_True (This, Block) then Not_Opened
      elsif This.Role = Ground then Answer_Of_Hello (This, Block)
      else Call_Of_Hello (This, Block))
   with Global => null;

   --  Any block. In format 1 all are taken but those marked as of the other.
   function Outcome_Of
     (This  : Seal;
      Block : Block_Data;
      Came  : Boolean) return Outcome
   is
     (if not Came then Nothing_Came
      elsif This.Format = 1
      then (if Mark_Of (Block) in Sealed_Mark | Hello_Mark then Wrong_Format
            else Opened)
      elsif Mark_Of (Block) = Sealed_Mark
      then (if Opens (Block, Other (This.Role), This.Active) then Opened
            elsif Opens (Block, Other (This.Role), This.Pending)
            then Opened_Anew
            else Not_Opened)
      elsif Block (1) = Hello_Mark then Outcome_Of_Hello (This, Block)
      else Wrong_Format)
   with Global => null;

   --  What the node knows then.

   function After_Hello (This : Seal; Block : Block_Data) return Seal is
     (if This.Role = Aircraft
      then
        (This with delta
           Own     => This.Own + 1,
           Pending => New_Session
             (This.Keys, Hello_Number (Block),
              Ground_Nonce   => Nonce_At (Block, Own_Place),
              Aircraft_Nonce => This.Own))
      elsif This.Active.Is_Present then Begun_Anew (This)
      else
        (This with delta
           Active  => New_Session
             (This.Keys, Hello_Number (Block),
              Ground_Nonce   => This.Own,
              Aircraft_Nonce => Nonce_At (Block, Own_Place)),
           Silence => 0))
   with Global => null;

   function After
     (This  : Seal;
      Block : Block_Data;
      What  : Outcome) return Seal
   is
     (if This.Format = 1 then This
      else
        (case What is
            when Opened      =>
              (This with delta
                 Active  =>
                   With_Newest (This.Active, Block, Other (This.Role)),
                 Pending => No_Session,
                 Silence => 0),
            when Opened_Anew =>
              (This with delta
                 Active  =>
                   With_Newest (This.Pending, Block, Other (This.Role)),
                 Pending => No_Session,
                 Silence => 0),
            when Hello_Taken => After_Hello (This, Block),
            when others      => This))
   with Global => null;

   --  A frame begins. An aircraft that has opened nothing for too long
   --  cannot know any more which number the next block has.
   function A_Frame_Later (This : Seal) return Seal is
     (if This.Silence < Longest_Silence
      then (This with delta Silence => This.Silence + 1)
      elsif This.Role = Aircraft
      then (This with delta Active => No_Session)
      else This)
   with Global => null;

   --  Once a frame: a block has come, or none. It is then one of format 1,
   --  or zeros.
   procedure Open
     (This  : in out Seal;
      Block : in out Block_Data;
      Came  : Boolean;
      What  : out Outcome)
   with
     Global => null,
     Post   =>
       What = Outcome_Of (A_Frame_Later (This'Old), Block'Old, Came)
       and then This = After (A_Frame_Later (This'Old), Block'Old, What)
       and then Block =
         (if What not in Taken then Block_Data'[others => 0]
          elsif This.Format = 1 then Block'Old
          else Unpacked (Block'Old, Other (This.Role)));

   --  A block to send

   function Says_Hello (This : Seal) return Boolean is
     (This.Pending.Is_Present
      or else not This.Active.Is_Present
      or else This.Active.Sent >= Last_Number)
   with Global => null;

   function Own_Hello (This : Seal) return Block_Data is
     (if This.Pending.Is_Present
      then Hello (This.Pending.Number, This.Pending.Aircraft_Nonce,
                  This.Pending.Ground_Nonce)
      else Hello (This.Keys (First).Number, This.Own, 0))
   with Global => null;

   function Closed_Hello (This : Seal) return Block_Data is
     (With_Tag
        (Own_Hello (This), This.Role,
         Tag_Of
           (Own_Hello (This), This.Role, 0,
            Hello_Key
              (Found (This.Keys, Hello_Number (Own_Hello (This))),
               This.Role))))
   with Global => null;

   function Sealed
     (Data   : Block_Data;
      Sender : Station;
      Number : Counter;
      Inside : Session) return Block_Data
   is
     (With_Tag
        (Packed (Data, Sender, Number), Sender,
         Tag_Of
           (Packed (Data, Sender, Number), Sender, Number,
            Key_Of (Inside, Sender))))
   with Global => null;

   --  Before a block is sent: the numbers may be used up.
   function Renewed (This : Seal) return Seal is
     (if This.Active.Is_Present and then This.Active.Sent >= Last_Number
      then Begun_Anew (This)
      else This)
   with Global => null;

   function Closed (This : Seal; Data : Block_Data) return Block_Data is
     (if This.Format = 1 then Data
      elsif Says_Hello (This) then Closed_Hello (This)
      else Sealed (Data, This.Role, This.Active.Sent + 1, This.Active))
   with Global => null;

   function After_Closing (This : Seal) return Seal is
     (if This.Format = 1 or else Says_Hello (This) then This
      else
        (This with delta
           Active =>
             (This.Active with delta Sent => This.Active.Sent + 1)))
   with Global => null;

   procedure Close (This : in out Seal; Data : in out Block_Data)
   with
     Global => null,
     Post   =>
       Data = Closed (Renewed (This'Old), Data'Old)
       and then This = After_Closing (Renewed (This'Old));

end URV.Seals;
