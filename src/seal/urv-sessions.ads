--  SPDX-License-Identifier: Apache-2.0

--  The keys of a sealed link, its sessions, and the numbers of their blocks
--  (SEC-3 to SEC-5).
--
--  A session is a key and two nonces, one of each node that it never used
--  before; its two keys, up and down, are made of these.

with Telemetry;       use Telemetry;
with URVOS;           use URVOS;
with URV.Seal_Blocks; use URV.Seal_Blocks;
with URV.Sip_Hash;    use URV.Sip_Hash;

package URV.Sessions with Pure, SPARK_Mode is

   --  The keys of a key file. The first is the one to call with; the other
   --  is good, too, while one is changed.

   No_Key : constant Key := (K0 => 0, K1 => 0);

   type Numbered_Key is record
      Is_Present : Boolean    := False;
      Number     : Key_Number := 0;
      Value      : Key        := No_Key;
   end record;

   type Key_Place is (First, Second);
   type Key_List is array (Key_Place) of Numbered_Key;

   function Is_Known (Keys : Key_List; Number : Key_Number) return Boolean is
     (for some Each of Keys => Each.Is_Present and then Each.Number = Number)
   with Global => null;

   function Found (Keys : Key_List; Number : Key_Number) return Key is
     (if Keys (First).Is_Present and then Keys (First).Number = Number
      then Keys (First).Value
      else Keys (Second).Value)
   with Global => null;

   --  Keys made of a key: for hellos of a node, for its blocks in a session.

   type Use_Of_Key is (Hello_Up, Hello_Down, Blocks_Up, Blocks_Down);

   --  What is hashed: the use, which half of the key it becomes, and the
   --  nonces.

   function Derivation_Byte
     (Where          : Message_Index;
      For_Use        : Use_Of_Key;
      Half           : Byte;
      Ground_Nonce   : Nonce;
      Aircraft_Nonce : Nonce) return Byte
   is
     (case Where is
         when 1        => Byte (Use_Of_Key'Pos (For_Use)),
         when 2        => Half,
         when 3 .. 10  => Byte_Of (Ground_Nonce, Byte_Index (Where - 2)),
         when 11 .. 18 => Byte_Of (Aircraft_Nonce, Byte_Index (Where - 10)),
         when others   => 0)
   with Global => null;

   function Derivation
     (For_Use        : Use_Of_Key;
      Half           : Byte;
      Ground_Nonce   : Nonce;
      Aircraft_Nonce : Nonce) return Message
   is
     ((Length => 18,
       Bytes  =>
         [for Where in Message_Index =>
            Derivation_Byte
              (Where, For_Use, Half, Ground_Nonce, Aircraft_Nonce)]))
   with Global => null;

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
      Is_Present     : Boolean    := False;
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
     ((Is_Present     => True,
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

   function Key_Of (This : Session; Sender : Station) return Key is
     (if Sender = Ground then This.Up_Key else This.Down_Key)
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
      else Following (Newest, Field_At (Block, Uplink_Words)))
   with Global => null;

   --  The block is one of the session, of that sender, and newer than all
   --  that was taken.
   function Opens
     (Block  : Block_Data;
      Sender : Station;
      This   : Session) return Boolean
   is
     (This.Is_Present
      and then Number_Of (Block, Sender, This.Newest) > This.Newest
      and then Has_Tag
        (Block, Sender,
         Tag_Of
           (Block, Sender, Number_Of (Block, Sender, This.Newest),
            Key_Of (This, Sender))))
   with Global => null;

   function With_Newest
     (This   : Session;
      Block  : Block_Data;
      Sender : Station) return Session
   is
     ((This with delta Newest => Number_Of (Block, Sender, This.Newest)))
   with Global => null;

end URV.Sessions;
