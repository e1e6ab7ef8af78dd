--  SPDX-License-Identifier: Apache-2.0

--  What a node knows of its sealed link: keys, sessions, numbers (SEC-1 to
--  SEC-5). TELOUT closes each block, TELIN opens each one that came.
--
--     ground                                    aircraft
--     hello (G)              ------------>      keeps G, takes a new A
--     both know G and A      <------------      hello (A, in answer to G)
--     sealed blocks 1, 2 ... ------------>      both know that both know
--                            <------------      sealed blocks 1, 2 ...
--
--  A session is a key and two nonces, one of each node that it never used
--  before; its two keys, up and down, are made of these. A node without a
--  session says hello. One that hears its peer's sealed blocks disregards a
--  hello. The functions are the code: Open and Close assign their results.

with Telemetry;       use Telemetry;
with URVOS;           use URVOS;
with URV.Seal_Blocks; use URV.Seal_Blocks;
with URV.Sip_Hash;    use URV.Sip_Hash;

package URV.Seals with Pure, SPARK_Mode is

   type Format_Number is range 1 .. 2;

   function Other (This : Station) return Station is
     (if This = Ground then Aircraft else Ground)
   with Global => null;

   --  The keys of a key file. The first is the one to call with; the other
   --  is good, too, while one is changed.

   No_Key : constant Key := (K0 => 0, K1 => 0);

   type Numbered_Key is record
      Is_There : Boolean    := False;
      Number   : Key_Number := 0;
      Value    : Key        := No_Key;
   end record;

   type Key_Place is (First, Second);
   type Key_List is array (Key_Place) of Numbered_Key;

   function Is_Known (Keys : Key_List; Number : Key_Number) return Boolean is
     (for some Each of Keys => Each.Is_There and then Each.Number = Number)
   with Global => null;

   function Found (Keys : Key_List; Number : Key_Number) return Key is
     (if Keys (First).Is_There and then Keys (First).Number = Number
      then Keys (First).Value
      else Keys (Second).Value)
   with Global => null;

   --  Keys made of a key: for hellos of a node, for its blocks in a session.

   type Use_Of_Key is (Hello_Up, Hello_Down, Blocks_Up, Blocks_Down);

   --  What is hashed: the use, which half of the key it becomes, and the
   --  nonces.
   function Derivation
     (For_Use        : Use_Of_Key;
      Half           : Byte;
      Ground_Nonce   : Nonce;
      Aircraft_Nonce : Nonce) return Message
   with
     Global => null,
     Post   =>
       Derivation'Result.Length = 18
       and then Derivation'Result.Bytes (1) =
                  Byte (Use_Of_Key'Pos (For_Use))
       and then Derivation'Result.Bytes (2) = Half
       and then
         (for all Where in Byte_Index range 1 .. 8 =>
            Derivation'Result.Bytes (Message_Index (Where + 2)) =
              Byte_Of (Ground_Nonce, Where)
            and then Derivation'Result.Bytes (Message_Index (Where + 10)) =
                       Byte_Of (Aircraft_Nonce, Where))
       and then
         (for all Where in Message_Index range 19 .. Message_Index'Last =>
            Derivation'Result.Bytes (Where) = 0);

   function Derived
     (From           : Key;
      For_Use        : Use_Of_Key;
      Ground_Nonce   : Nonce;
      Aircraft_Nonce : Nonce) return Key
   is
     ((K0 => Tag
         (Derivation (For_Use, 0, Ground_Nonce, Aircraft_Nonce), From),
       K1 => Tag
         (Derivation (For_Use, 1, Ground_Nonce, Aircraft_Nonce), From)))
   with Global => null;

   type Session is record
      Is_There       : Boolean    := False;
      Number         : Key_Number := 0;
      Ground_Nonce   : Nonce      := 0;
      Aircraft_Nonce : Nonce      := 0;
      Up_Key         : Key        := No_Key;
      Down_Key       : Key        := No_Key;

      --  Of the blocks sent the last, of those taken the newest.
      Sent           : Counter    := 0;
      Newest         : Counter    := 0;
   end record;

   No_Session : constant Session := (others => <>);

   function New_Session
     (Keys           : Key_List;
      Number         : Key_Number;
      Ground_Nonce   : Nonce;
      Aircraft_Nonce : Nonce) return Session
   is
     ((Is_There       => True,
       Number         => Number,
       Ground_Nonce   => Ground_Nonce,
       Aircraft_Nonce => Aircraft_Nonce,
       Up_Key         => Derived
         (Found (Keys, Number), Blocks_Up, Ground_Nonce, Aircraft_Nonce),
       Down_Key       => Derived
         (Found (Keys, Number), Blocks_Down, Ground_Nonce, Aircraft_Nonce),
       Sent           => 0,
       Newest         => 0))
   with Global => null;

   function Key_Of (Item : Session; Sender : Station) return Key is
     (if Sender = Ground then Item.Up_Key else Item.Down_Key)
   with Global => null;

   --  The number of a block that came. An uplink tells the low 12 bits of
   --  it: it is the first after the newest that ends in them. 0 is none.

   Last_Number : constant Counter := Counter'Last - Numbers_Told;

   function Following (Newest : Counter; Low : Field) return Counter is
     (if Newest >= Last_Number then 0
      else Newest + 1
        + (Counter (Low) + Numbers_Told - (Newest + 1) mod Numbers_Told)
          mod Numbers_Told)
   with
     Global => null,
     Post   =>
       (if Newest < Last_Number
        then Following'Result in Newest + 1 .. Newest + Numbers_Told
          and then Following'Result mod Numbers_Told = Counter (Low));

   function Number_Of
     (Block  : Block_Data;
      Sender : Station;
      Newest : Counter) return Counter
   is
     (if Sender = Aircraft then Number_At (Block)
      else Following (Newest, Field_At (Block, 14)))
   with Global => null;

   --  The block is one of the session, of that sender, and newer than all
   --  that was taken.
   function Opens
     (Block  : Block_Data;
      Sender : Station;
      Item   : Session) return Boolean
   is
     (Item.Is_There
      and then Number_Of (Block, Sender, Item.Newest) > Item.Newest
      and then Has_Tag
        (Block, Sender,
         Tag_Of
           (Block, Sender, Number_Of (Block, Sender, Item.Newest),
            Key_Of (Item, Sender))))
   with Global => null;

   function With_Newest
     (Item   : Session;
      Block  : Block_Data;
      Sender : Station) return Session
   is
     ((Item with delta Newest => Number_Of (Block, Sender, Item.Newest)))
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
   function Begun_Anew (Item : Seal) return Seal is
     ((Item with delta
         Own     => Item.Own + 1,
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

   function Is_True (Item : Seal; Block : Block_Data) return Boolean is
     (Has_Tag
        (Block, Other (Item.Role),
         Tag_Of
           (Block, Other (Item.Role), 0,
            Hello_Key
              (Found (Item.Keys, Hello_Number (Block)),
               Other (Item.Role)))))
   with Global => null;

   --  The ground calls: an answer is one to its own nonce.
   function Answer_Of_Hello (Item : Seal; Block : Block_Data) return Outcome
   is
     (if not Item.Active.Is_There
      then
        (if Nonce_At (Block, Answered_Place) = Item.Own
           and then Hello_Number (Block) = Item.Keys (First).Number
         then Hello_Taken
         else Hello_Repeated)
      elsif Nonce_At (Block, Own_Place) = Item.Active.Aircraft_Nonce
        and then Nonce_At (Block, Answered_Place) = Item.Active.Ground_Nonce
      then (if Item.Active.Newest = 0 then Hello_Repeated
            else Hello_Out_Of_Turn)
      elsif Item.Silence < Patience then Hello_Out_Of_Turn
      else Hello_Taken)
   with Global => null;

   --  The aircraft answers.
   function Call_Of_Hello (Item : Seal; Block : Block_Data) return Outcome is
     (if Item.Pending.Is_There
        and then Nonce_At (Block, Own_Place) = Item.Pending.Ground_Nonce
        and then Hello_Number (Block) = Item.Pending.Number
      then Hello_Repeated
      elsif Item.Active.Is_There
        and then (Item.Silence < Patience
                  or else Nonce_At (Block, Own_Place)
                            = Item.Active.Ground_Nonce)
      then Hello_Out_Of_Turn
      else Hello_Taken)
   with Global => null;

   function Outcome_Of_Hello (Item : Seal; Block : Block_Data) return Outcome
   is
     (if not Is_Known (Item.Keys, Hello_Number (Block)) then Unknown_Key
      elsif not Is_True (Item, Block) then Not_Opened
      elsif Item.Role = Ground then Answer_Of_Hello (Item, Block)
      else Call_Of_Hello (Item, Block))
   with Global => null;

   --  Any block. In format 1 all are taken but those marked as of the other.
   function Outcome_Of
     (Item  : Seal;
      Block : Block_Data;
      Came  : Boolean) return Outcome
   is
     (if not Came then Nothing_Came
      elsif Item.Format = 1
      then (if Mark_Of (Block) in Sealed_Mark | Hello_Mark then Wrong_Format
            else Opened)
      elsif Mark_Of (Block) = Sealed_Mark
      then (if Opens (Block, Other (Item.Role), Item.Active) then Opened
            elsif Opens (Block, Other (Item.Role), Item.Pending)
            then Opened_Anew
            else Not_Opened)
      elsif Block (1) = Hello_Mark then Outcome_Of_Hello (Item, Block)
      else Wrong_Format)
   with Global => null;

   --  What the node knows then.

   function After_Hello (Item : Seal; Block : Block_Data) return Seal is
     (if Item.Role = Aircraft
      then
        (Item with delta
           Own     => Item.Own + 1,
           Pending => New_Session
             (Item.Keys, Hello_Number (Block),
              Ground_Nonce   => Nonce_At (Block, Own_Place),
              Aircraft_Nonce => Item.Own))
      elsif Item.Active.Is_There then Begun_Anew (Item)
      else
        (Item with delta
           Active  => New_Session
             (Item.Keys, Hello_Number (Block),
              Ground_Nonce   => Item.Own,
              Aircraft_Nonce => Nonce_At (Block, Own_Place)),
           Silence => 0))
   with Global => null;

   function After
     (Item  : Seal;
      Block : Block_Data;
      What  : Outcome) return Seal
   is
     (if Item.Format = 1 then Item
      else
        (case What is
            when Opened      =>
              (Item with delta
                 Active  =>
                   With_Newest (Item.Active, Block, Other (Item.Role)),
                 Pending => No_Session,
                 Silence => 0),
            when Opened_Anew =>
              (Item with delta
                 Active  =>
                   With_Newest (Item.Pending, Block, Other (Item.Role)),
                 Pending => No_Session,
                 Silence => 0),
            when Hello_Taken => After_Hello (Item, Block),
            when others      => Item))
   with Global => null;

   --  A frame begins. An aircraft that has opened nothing for too long
   --  cannot know any more which number the next block has.
   function A_Frame_Later (Item : Seal) return Seal is
     (if Item.Silence < Longest_Silence
      then (Item with delta Silence => Item.Silence + 1)
      elsif Item.Role = Aircraft
      then (Item with delta Active => No_Session)
      else Item)
   with Global => null;

   --  Once a frame: a block has come, or none. It is then one of format 1,
   --  or zeros.
   procedure Open
     (Item  : in out Seal;
      Block : in out Block_Data;
      Came  : Boolean;
      What  : out Outcome)
   with
     Global => null,
     Post   =>
       What = Outcome_Of (A_Frame_Later (Item'Old), Block'Old, Came)
       and then Item = After (A_Frame_Later (Item'Old), Block'Old, What)
       and then Block =
         (if What not in Taken then Block_Data'[others => 0]
          elsif Item.Format = 1 then Block'Old
          else Unpacked (Block'Old, Other (Item.Role)));

   --  A block to send

   function Says_Hello (Item : Seal) return Boolean is
     (Item.Pending.Is_There
      or else not Item.Active.Is_There
      or else Item.Active.Sent >= Last_Number)
   with Global => null;

   function Own_Hello (Item : Seal) return Block_Data is
     (if Item.Pending.Is_There
      then Hello (Item.Pending.Number, Item.Pending.Aircraft_Nonce,
                  Item.Pending.Ground_Nonce)
      else Hello (Item.Keys (First).Number, Item.Own, 0))
   with Global => null;

   function Closed_Hello (Item : Seal) return Block_Data is
     (With_Tag
        (Own_Hello (Item), Item.Role,
         Tag_Of
           (Own_Hello (Item), Item.Role, 0,
            Hello_Key
              (Found (Item.Keys, Hello_Number (Own_Hello (Item))),
               Item.Role))))
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
   function Renewed (Item : Seal) return Seal is
     (if Item.Active.Is_There and then Item.Active.Sent >= Last_Number
      then Begun_Anew (Item)
      else Item)
   with Global => null;

   function Closed (Item : Seal; Data : Block_Data) return Block_Data is
     (if Item.Format = 1 then Data
      elsif Says_Hello (Item) then Closed_Hello (Item)
      else Sealed (Data, Item.Role, Item.Active.Sent + 1, Item.Active))
   with Global => null;

   function After_Closing (Item : Seal) return Seal is
     (if Item.Format = 1 or else Says_Hello (Item) then Item
      else
        (Item with delta
           Active =>
             (Item.Active with delta Sent => Item.Active.Sent + 1)))
   with Global => null;

   procedure Close (Item : in out Seal; Data : in out Block_Data)
   with
     Global => null,
     Post   =>
       Data = Closed (Renewed (Item'Old), Data'Old)
       and then Item = After_Closing (Renewed (Item'Old));

end URV.Seals;
