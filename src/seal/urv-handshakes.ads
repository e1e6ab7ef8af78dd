--  SPDX-License-Identifier: Apache-2.0

--  The handshake by which two nodes start a session (SEC-3, FRM-7), and a
--  node's state of its sealed link.
--
--     ground                                    aircraft
--     hello (G)              ------------>      keeps G, takes a new A
--     both know G and A      <------------      hello (A, in answer to G)
--     sealed blocks 1, 2 ... ------------>      both know that both know
--                            <------------      sealed blocks 1, 2 ...
--
--  A node without a session sends a hello. A node that receives its peer's
--  sealed blocks ignores a hello.

with Telemetry;       use Telemetry;
with URV.Frame_Times; use URV.Frame_Times;
with URV.Seal_Blocks; use URV.Seal_Blocks;
with URV.Sessions;    use URV.Sessions;
with URV.Sip_Hash;    use URV.Sip_Hash;

package URV.Handshakes with Pure, SPARK_Mode is

   type Format_Number is range 1 .. 2;

   function Other (This : Station) return Station is
     (if This = Ground then Aircraft else Ground)
   with Global => null;

   --  A node. Silence counts the frames since a block was opened

   Silent_Frames : constant := 3;

   --  One minute.
   Longest_Silence : constant := 60 * Frames_Per_Second;
   subtype Frame_Count is Counter range 0 .. Longest_Silence;

   --  The sessions that the aircraft has offered in answer to a hello, and
   --  from which no block has come. There are four, so that recorded hellos do
   --  not displace the ground's own.
   type Pending_Place is range 1 .. 4;
   type Pending_List is array (Pending_Place) of Session;

   function None_Pending return Pending_List is ([others => No_Session])
   with Global => null;

   --  The keys of hellos, by their senders. They are derived once, when the
   --  node is configured: a hello must not cost a frame more than its tag.

   type Sender_Keys is array (Station) of Key;
   type Hello_Key_List is array (Key_Place) of Sender_Keys;

   function Hello_Key (From : Key; Sender : Station) return Key is
     (Derived
        (From, (if Sender = Ground then Hello_Up else Hello_Down), 0, 0))
   with Global => null;

   function Hello_Keys_Of (Keys : Key_List) return Hello_Key_List is
     ([for Place in Key_Place =>
         [for Sender in Station =>
            (if Keys (Place).Is_Present
             then Hello_Key (Keys (Place).Value, Sender) else No_Key)]])
   with Global => null;

   type Seal is record
      Role     : Station       := Ground;
      Format   : Format_Number := 1;
      Keys     : Key_List;
      Hellos   : Hello_Key_List := [others => [others => No_Key]];

      --  The nonce of the next hello.
      Own      : Nonce         := 0;
      Active   : Session;

      --  The aircraft's offered sessions; the place of the newest; the place
      --  at which it begins to look for one to answer.
      Pending  : Pending_List  := [others => (others => <>)];
      Latest   : Pending_Place := 1;
      Turn     : Pending_Place := 1;

      --  The ground has a session but received a hello instead of its blocks.
      --  It then sends a hello in every second block.
      In_Doubt   : Boolean       := False;

      Silence  : Frame_Count   := 0;
   end record;

   --  A node's state before it is switched on. Start must be a nonce with
   --  which this node has never begun.
   function New_Seal
     (Role   : Station;
      Format : Format_Number;
      Keys   : Key_List;
      Start  : Nonce) return Seal
   is
     ((Role     => Role,
       Format    => Format,
       Keys      => Keys,
       Hellos    => Hello_Keys_Of (Keys),
       Own       => Start,
       Active    => No_Session,
       Pending   => None_Pending,
       Latest    => 1,
       Turn      => 1,
       In_Doubt  => False,
       Silence   => 0))
   with Global => null;

   --  The state without sessions: after a cold start, or at the end of a
   --  session's numbers.
   function Restarted (This : Seal) return Seal is
     ((This with delta
         Own      => This.Own + 1,
         Active   => No_Session,
         Pending  => None_Pending,
         In_Doubt => False))
   with Global => null;

   --  The outcome of a block.
   type Outcome is
     (Nothing_Came,
      Opened,
      Opened_New_Session,
      Hello_Taken,
      Hello_Repeated,      --  known already, or answers no present hello

      --  Refused
      Wrong_Format,
      Not_Opened,          --  its tag or its number is wrong
      Unknown_Key,
      Hello_Out_Of_Turn,   --  there is a session
      Too_Late);           --  it was sealed more than Most_Age frames ago

   subtype Taken is Outcome range Opened .. Opened_New_Session;
   subtype Refused is Outcome range Wrong_Format .. Too_Late;

   --  A hello that was received

   function Hello_Number (Block : Block_Data) return Key_Number is
     (Key_Number (Block (2)))
   with Global => null;

   function Found_Hello_Key
     (This : Seal; Number : Key_Number; Sender : Station) return Key
   is
     (if This.Keys (First).Is_Present
        and then This.Keys (First).Number = Number
      then This.Hellos (First) (Sender)
      else This.Hellos (Second) (Sender))
   with Global => null;

   function Is_True (This : Seal; Block : Block_Data) return Boolean is
     (Has_Tag
        (Block, Other (This.Role),
         Tag_Of
           (Block, Other (This.Role), 0, 0,
            Found_Hello_Key
              (This, Hello_Number (Block), Other (This.Role)))))
   with Global => null;

   --  The ground calls: it sends a hello and accepts an answer to its nonce

   function Calls (This : Seal) return Boolean is
     (not This.Active.Is_Present or else This.In_Doubt)
   with Global => null;

   function Is_Answer (This : Seal; Block : Block_Data) return Boolean is
     (Calls (This)
      and then Nonce_At (Block, Answered_Place) = This.Own
      and then Hello_Number (Block) = This.Keys (First).Number)
   with Global => null;

   function Answer_Of_Hello (This : Seal; Block : Block_Data) return Outcome
   is
     (if Is_Answer (This, Block) then Hello_Taken
      elsif Calls (This) then Hello_Repeated
      elsif Nonce_At (Block, Own_Place) = This.Active.Aircraft_Nonce
        and then Nonce_At (Block, Answered_Place) = This.Active.Ground_Nonce
        and then This.Active.Newest = 0
      then Hello_Repeated
      elsif This.Silence < Silent_Frames
        or else (Nonce_At (Block, Own_Place) = This.Active.Aircraft_Nonce
                 and then Nonce_At (Block, Answered_Place)
                            = This.Active.Ground_Nonce)
      then Hello_Out_Of_Turn
      else Hello_Taken)
   with Global => null;

   --  The aircraft answers a call for 8 frames. Later the same call counts as
   --  a new one, since the block that closes the exchange would be too late.
   --  In these frames each pending session has its turn, even if every second
   --  block is a sealed one

   Answer_Lasts : constant := 8;

   function Is_Answered (Item : Session) return Boolean is
     (Item.Is_Present and then Item.Age <= Answer_Lasts)
   with Global => null;

   function Is_Call (Item : Session; Block : Block_Data) return Boolean is
     (Is_Answered (Item)
      and then Nonce_At (Block, Own_Place) = Item.Ground_Nonce
      and then Hello_Number (Block) = Item.Number)
   with Global => null;

   function Call_Of_Hello (This : Seal; Block : Block_Data) return Outcome is
     (if (for some Each of This.Pending => Is_Call (Each, Block))
      then Hello_Repeated
      elsif This.Active.Is_Present
        and then (This.Silence < Silent_Frames
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
   with
     Global => null,
     Post   => Outcome_Of_Hello'Result not in Opened | Opened_New_Session;

   --  The node's state after a hello

   function Next_Place (Item : Pending_Place) return Pending_Place is
     (if Item = Pending_Place'Last then Pending_Place'First else Item + 1)
   with Global => null;

   --  The aircraft's state with one more pending session, in the place of the
   --  oldest.
   function With_Pending (This : Seal; Item : Session) return Seal is
     ((This with delta
         Own      => This.Own + 1,
         Pending  =>
           [for Each in Pending_Place =>
              (if Each = Next_Place (This.Latest) then Item
               else This.Pending (Each))],
         Latest   => Next_Place (This.Latest)))
   with
     Ghost,
     Global => null,
     Post   =>
       With_Pending'Result.Pending (Next_Place (This.Latest)) = Item
       and then
         (for all Each in Pending_Place =>
            (if Each /= Next_Place (This.Latest)
             then With_Pending'Result.Pending (Each) =
                    This.Pending (Each)));

   function After_Hello (This : Seal; Block : Block_Data) return Seal is
     (if This.Role = Aircraft
      then With_Pending
        (This,
         New_Session
           (This.Keys, Hello_Number (Block),
            Ground_Nonce   => Nonce_At (Block, Own_Place),
            Aircraft_Nonce => This.Own,
            Maker          => Aircraft))
      elsif Is_Answer (This, Block)
      then
        (This with delta
           Own     => This.Own + 1,
           Active  => New_Session
             (This.Keys, Hello_Number (Block),
              Ground_Nonce   => This.Own,
              Aircraft_Nonce => Nonce_At (Block, Own_Place),
              Maker          => Ground),
           In_Doubt => False,
           Silence  => 0)
      else (This with delta In_Doubt => True))
   with Ghost, Global => null;

end URV.Handshakes;
