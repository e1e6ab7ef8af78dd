--  SPDX-License-Identifier: Apache-2.0

--  The keys of a sealed link, its sessions, and the age of their blocks
--  (SEC-3 to SEC-5).
--
--  A session has a key and two nonces, one from each node, which that node
--  never used before. The two keys of the session, up and down, are derived
--  from these.
--
--  Each node counts the frames since it made the session; this is its age of
--  the session. A block's number is the sender's age. A receiver has two
--  bounds on the time of sealing, in its own frames. A block was sealed no
--  earlier than the block whose number it echoes. It was also sealed no
--  earlier than an earlier block plus the frames between their numbers, minus
--  the drift of the clocks. A block that may be older than Most_Age is
--  refused.

with Interfaces;      use Interfaces;
with Telemetry;       use Telemetry;
with URVOS;           use URVOS;
with URV.Seal_Blocks; use URV.Seal_Blocks;
with URV.Sip_Hash;    use URV.Sip_Hash;

package URV.Sessions with Pure, SPARK_Mode is

   --  The keys of a key file. The node sends hellos with the first. The other
   --  is also valid while keys are changed

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

   --  Keys derived from a key: for a node's hellos, and for its blocks in a
   --  session

   type Use_Of_Key is (Hello_Up, Hello_Down, Blocks_Up, Blocks_Down);

   --  The hashed bytes: the use, the half of the derived key, and the nonces

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
   with Ghost, Global => null;

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
   with Ghost, Global => null;

   function Derived
     (From           : Key;
      For_Use        : Use_Of_Key;
      Ground_Nonce   : Nonce;
      Aircraft_Nonce : Nonce) return Key
   with
     Global => null,
     Post   =>
       Derived'Result.K0 = Reference
         (Derivation (For_Use, 0, Ground_Nonce, Aircraft_Nonce), From)
       and then Derived'Result.K1 = Reference
         (Derivation (For_Use, 1, Ground_Nonce, Aircraft_Nonce), From);

   --  A session ends at this age, after 93 hours. A downlink's number has
   --  three bytes.
   Last_Age : constant Counter := 2 ** 24 - 1;

   subtype Session_Age is Counter range 1 .. Last_Age;

   type Session is record
      Is_Present     : Boolean     := False;
      Number         : Key_Number  := 0;
      Ground_Nonce   : Nonce       := 0;
      Aircraft_Nonce : Nonce       := 0;
      Up_Key         : Key         := No_Key;
      Down_Key       : Key         := No_Key;

      --  Frames since this node made the session, plus one.
      Age            : Session_Age := 1;

      --  The number of the newest block taken, and this node's age at that
      --  time.
      Newest         : Counter     := 0;
      Taken_At       : Session_Age := 1;

      --  The peer sealed block Reference no earlier than this node's age
      --  Not_Before. If Reference is 0, this node knows no such block.
      Reference      : Counter     := 0;
      Not_Before     : Session_Age := 1;
   end record
   with Predicate =>
     Session.Newest <= Last_Age
     and then Session.Reference <= Last_Age
     and then (Session.Newest = 0 or else Session.Reference <= Session.Newest)
     and then Session.Not_Before <= Session.Age
     and then Session.Taken_At <= Session.Age;

   No_Session : constant Session := (others => <>);

   --  The ground makes its session after the aircraft has made its own. The
   --  aircraft therefore knows that number 1 comes no earlier than age 1.
   function New_Session
     (Keys           : Key_List;
      Number         : Key_Number;
      Ground_Nonce   : Nonce;
      Aircraft_Nonce : Nonce;
      Maker          : Station) return Session
   is
     ((Is_Present     => True,
       Number         => Number,
       Ground_Nonce   => Ground_Nonce,
       Aircraft_Nonce => Aircraft_Nonce,
       Up_Key         => Derived
         (Found (Keys, Number), Blocks_Up, Ground_Nonce, Aircraft_Nonce),
       Down_Key       => Derived
         (Found (Keys, Number), Blocks_Down, Ground_Nonce, Aircraft_Nonce),
       Age            => 1,
       Newest         => 0,
       Taken_At       => 1,
       Reference      => (if Maker = Aircraft then 1 else 0),
       Not_Before     => 1))
   with Global => null;

   function Key_Of (This : Session; Sender : Station) return Key is
     (if Sender = Ground then This.Up_Key else This.Down_Key)
   with Global => null;

   --  The session after some frames.
   function Older (This : Session; Frames : Counter) return Session is
     ((This with delta
         Age =>
           (if Frames <= Last_Age - This.Age
            then This.Age + Frames else Last_Age)))
   with Global => null;

   --  Each clock is within 200 ppm of its rate. During Frames whole frames of
   --  one node, the other counts the same number within two and one in 2,400
   --  (Theorems.Seals.Clocks_Keep_Step)

   function Drift (Frames : Counter) return Counter is (Frames / 2_400 + 2)
   with Global => null;

   function Least_Of (Frames : Counter) return Counter is
     (if Frames > Drift (Frames) then Frames - Drift (Frames) else 0)
   with Global => null;

   --  The latest number that the peer can have used by now.
   function Latest (This : Session) return Counter is
     (This.Reference + (This.Age - This.Not_Before)
      + Drift (This.Age - This.Not_Before))
   with
     Global => null,
     Post   => Latest'Result <= Counter'Last - Number_Modulus;

   --  The greatest number up to Most that has this remainder, or 0.
   function Last_With
     (Remainder : Counter;
      Modulus   : Counter;
      Most      : Counter) return Counter
   is
     (if Most - Most mod Modulus + Remainder <= Most
      then Most - Most mod Modulus + Remainder
      elsif Most >= Modulus
      then Most - Most mod Modulus - Modulus + Remainder
      else 0)
   with
     Global => null,
     Pre    => Modulus in 1 .. Number_Modulus and then Remainder < Modulus
       and then Most <= Counter'Last - Number_Modulus;

   --  An uplink's number: the greatest up to Most with its 6 bits.
   function Uplink_Number (Block : Block_Data; Most : Counter) return Counter
   is
     (Last_With
        (Counter (Field_At (Block, Uplink_Words) / Number_Modulus),
         Number_Modulus, Most))
   with
     Global => null,
     Pre    => Most <= Counter'Last - Number_Modulus;

   --  The echo, no later than Now, or 0.
   function Echo_At
     (Block  : Block_Data;
      Sender : Station;
      Now    : Counter) return Counter
   is
     (if Code_At (Block, Sender) >= No_Echo then 0
      else Last_With
        (Counter (Code_At (Block, Sender)), Echo_Modulus, Now))
   with
     Global => null,
     Pre    => Now <= Counter'Last - Number_Modulus;

   function Number_Of
     (Block  : Block_Data;
      Sender : Station;
      This   : Session) return Counter
   is
     (if Sender = Aircraft then Number_At (Block)
      else Uplink_Number (Block, Latest (This)))
   with Global => null;

   function Echo_Of
     (Block  : Block_Data;
      Sender : Station;
      This   : Session) return Counter
   is (Echo_At (Block, Sender, This.Age))
   with
     Global => null,
     Post   => Echo_Of'Result <= This.Age;

   --  The block has the tag of the session and the sender, and is newer than
   --  all blocks taken.
   function Is_Sealed
     (Block  : Block_Data;
      Sender : Station;
      This   : Session) return Boolean
   is
     (This.Is_Present
      and then Number_Of (Block, Sender, This) > This.Newest
      and then Number_Of (Block, Sender, This) <= Last_Age
      and then Has_Tag
        (Block, Sender,
         Tag_Of
           (Block, Sender, Number_Of (Block, Sender, This),
            Echo_Of (Block, Sender, This), Key_Of (This, Sender))))
   with Global => null;

   --  This node's earliest age at which a block with this number can have been
   --  sealed, by the reference alone; 0 if nothing is known.
   function By_Reference (This : Session; Number : Counter) return Counter is
     (if This.Reference = 0 then 0
      elsif Number >= This.Reference
      then This.Not_Before + Least_Of (Number - This.Reference)
      else 0)
   with
     Global => null,
     Pre    => Number <= Last_Age,
     Post   => By_Reference'Result <= 2 * Last_Age - 1;

   function Earliest
     (This : Session; Number : Counter; Echo : Counter) return Counter
   is (Counter'Max (Echo, By_Reference (This, Number)))
   with
     Global => null,
     Pre    => Number <= Last_Age and then Echo <= This.Age;

   --  0.24 s: transit, one repetition, and the uncertainty of the bounds.
   Most_Age : constant := 12;

   function Is_Timely
     (This : Session; Number : Counter; Echo : Counter) return Boolean
   is
     (Earliest (This, Number, Echo) > 0
      and then This.Age <= Earliest (This, Number, Echo) + Most_Age)
   with
     Global => null,
     Pre    => Number <= Last_Age and then Echo <= This.Age;

   --  The block belongs to the session, is newer than all blocks taken, and is
   --  no older than Most_Age.
   function Opens
     (Block  : Block_Data;
      Sender : Station;
      This   : Session) return Boolean
   is
     (Is_Sealed (Block, Sender, This)
      and then Is_Timely
        (This, Number_Of (Block, Sender, This),
         Echo_Of (Block, Sender, This)))
   with Global => null;

   --  An echo that gives a later bound than the reference becomes the
   --  reference.
   function With_Newest
     (This   : Session;
      Block  : Block_Data;
      Sender : Station) return Session
   is
     (if Echo_Of (Block, Sender, This) > 0
        and then
          Echo_Of (Block, Sender, This) >=
            By_Reference (This, Number_Of (Block, Sender, This))
      then
        (This with delta
           Newest     => Number_Of (Block, Sender, This),
           Taken_At   => This.Age,
           Reference  => Number_Of (Block, Sender, This),
           Not_Before => Echo_Of (Block, Sender, This))
      else
        (This with delta
           Newest     => Number_Of (Block, Sender, This),
           Taken_At   => This.Age))
   with
     Global => null,
     Pre    => Opens (Block, Sender, This),
     Post   =>
       With_Newest'Result.Newest = Number_Of (Block, Sender, This)
       and then With_Newest'Result.Newest > This.Newest;

   --  The echo of a block that is sealed now: the newest number taken, or 0 if
   --  that is older than Echo_Lasts frames and its six bits would be ambiguous

   Echo_Lasts : constant := 30;

   function Echo_Now (This : Session) return Counter is
     (if This.Age - This.Taken_At <= Echo_Lasts then This.Newest else 0)
   with Global => null;

end URV.Sessions;
