--  SPDX-License-Identifier: Apache-2.0

--  On the sealed link every sealed block opens, no block is taken twice, and
--  none is taken that was sealed more than a quarter of a second earlier
--  (SEC-1, SEC-3, SEC-4). This holds for both nodes and any line that loses,
--  delays, repeats or reorders blocks, with clocks within 200 ppm. It does not
--  show that an attacker without the key cannot forge a tag; this rests on the
--  accepted strength of SipHash.
--
--  Three theorems limit a block's age. Clocks_Keep_Step: two clocks within 200
--  ppm agree on a number of frames, within Drift. A_Taken_Block_Is_Young: if a
--  session's reference is true, a block that opens was sealed at most Most_Age
--  frames ago. The_Reference_Stays_True: after a block has opened, the
--  reference is true again. It is true at first, since the ground makes its
--  session after the aircraft.

with Telemetry;        use Telemetry;
with URVOS;            use URVOS;
with URV.Seal_Blocks;  use URV.Seal_Blocks;
with URV.Handshakes;   use URV.Handshakes;
with URV.Plain_Blocks; use URV.Plain_Blocks;
with URV.Seals;        use URV.Seals;
with URV.Sessions;     use URV.Sessions;
with URV.Sip_Hash;     use URV.Sip_Hash;
with URV.Spare_Bits;

package Theorems.Seals with SPARK_Mode, Ghost is

   --  A received word of a block: a command limited to 12 bits (D-11), a
   --  sensor's word without spare bits; in the last word, an uplink has the
   --  flags and a downlink all bits (D-15).
   function Carried
     (Data   : Block_Words;
      Sender : Station;
      Which  : Word_Place) return Word
   is
     (if Which < Words_Of (Sender) and then Sender = Ground
      then URV.Spare_Bits.Clipped (Data (Which))
      elsif Which < Words_Of (Sender)
      then URV.Spare_Bits.Without_Spare (Data (Which))
      elsif Sender = Ground then Data (Which) mod 16
      else Data (Which))
   with
     Global => null,
     Pre    => Which <= Words_Of (Sender);

   --  The spare bits of a received sensor's word (FTI-12): a mark, the low 12
   --  bits of the block's number, and the sent card and phase.
   function Spare_Carried
     (Data   : Block_Words;
      Number : Counter;
      Which  : Word_Place) return URV.Spare_Bits.Nibble
   is
     (URV.Spare_Bits.Sealed_With
        (Number => Word (Byte_Of (Number, 3)) * 256
                     + Word (Byte_Of (Number, 4)),
         Card   => Word (Card_Of (Data)),
         Place  => Positive (Which)))
   with Global => null;

   procedure Words_Come_Through
     (Data   : Block_Words;
      Sender : Station;
      Number : Counter;
      Echo   : Counter;
      Inside : Session;
      Which  : Word_Place)
   with
     Global => null,
     Pre    => Which <= Words_Of (Sender),
     Post   =>
       Unpacked (Sealed (Data, Sender, Number, Echo, Inside), Sender)
         (Which) =
         (if Sender = Ground or else Which = Words_Of (Sender)
          then Carried (Data, Sender, Which)
          else Carried (Data, Sender, Which)
            or Spare_Carried (Data, Number, Which)
               * URV.Spare_Bits.Spare_Unit);

   --  A block opens for a node with its session if it is newer than all blocks
   --  taken, came in time, and has a number and echo among the latest that the
   --  receiver's clock allows.
   procedure A_Sealed_Block_Opens
     (Data   : Block_Words;
      Sender : Station;
      Number : Counter;
      Echo   : Counter;
      Mine   : Session;
      Theirs : Session)
   with
     Global => null,
     Pre    =>
       Theirs.Is_Present
       and then Key_Of (Mine, Sender) = Key_Of (Theirs, Sender)
       and then Number > Theirs.Newest
       and then Number <= Last_Age
       and then Number <= Latest (Theirs)
       and then Latest (Theirs) - Number < Number_Modulus
       and then Echo <= Theirs.Age
       and then (Echo = 0 or else Theirs.Age - Echo < Echo_Modulus)
       and then Is_Timely (Theirs, Number, Echo),
     Post   =>
       Number_Of
         (Sealed (Data, Sender, Number, Echo, Mine), Sender, Theirs) = Number
       and then Echo_Of
         (Sealed (Data, Sender, Number, Echo, Mine), Sender, Theirs) = Echo
       and then Opens
         (Sealed (Data, Sender, Number, Echo, Mine), Sender, Theirs);

   --  A block that is taken has a higher number than all blocks that its
   --  session has taken, and the session records it as newest.
   procedure Nothing_Older_Is_Taken
     (Item    : in out URV.Handshakes.Seal;
      Block   : Block_Data;
      Arrived : Boolean;
      Words   : out Block_Words;
      Result  : out Outcome)
   with
     Global => null,
     Pre    => Item.Format = 2,
     Post   =>
       (if Result = Opened
        then Item'Old.Active.Is_Present
          and then Item.Active.Newest > Item'Old.Active.Newest
        elsif Result = Opened_New_Session
        then (for some Each of Item'Old.Pending => Each.Is_Present)
          and then Item.Active.Newest > 0
        elsif Result /= Hello_Taken
        then Item.Active = Item'Old.Active);

   --  Time: the frame of a clock within 200 ppm of its rate, in nanoseconds

   type Nanoseconds is range 0 .. 2 ** 62;

   Shortest_Frame : constant := 20_000_000 - 4_000;
   Longest_Frame  : constant := 20_000_000 + 4_000;

   --  The time between two events is within one frame of the whole frames that
   --  a clock counts between them.
   function Can_Count (Frames : Counter; Time : Nanoseconds) return Boolean is
     (Time < (Nanoseconds (Frames) + 1) * Longest_Frame
      and then
        (Frames = 0
         or else Time > (Nanoseconds (Frames) - 1) * Shortest_Frame))
   with Global => null;

   --  While the peer counts Theirs frames, this node counts at least Least_Of
   --  (Theirs).
   procedure Clocks_Keep_Step
     (Theirs : Counter; Mine : Counter; Time : Nanoseconds)
   with
     Global => null,
     Pre    =>
       Theirs <= Last_Age
       and then Can_Count (Theirs, Time)
       and then Can_Count (Mine, Time),
     Post   => Mine >= Least_Of (Theirs);

   --  This node's age when the peer sealed a block; neither node knows it.
   --  Sealed_At belongs to the block received, Reference_At to the reference

   --  The reference is true.
   function Is_True
     (Item : Session; Reference_At : Counter) return Boolean
   is
     (Item.Reference = 0 or else Reference_At >= Item.Not_Before)
   with Global => null;

   --  The peer is honest and its clock is within bounds: it had taken the
   --  block that it echoes, and has counted the frames between the two blocks.
   function Is_Honest
     (Item         : Session;
      Number       : Counter;
      Echo         : Counter;
      Reference_At : Counter;
      Sealed_At    : Counter) return Boolean
   is
     (Sealed_At >= Echo
      and then
        (if Item.Reference > 0 and then Number >= Item.Reference
         then Sealed_At >= Reference_At
           and then Sealed_At - Reference_At >=
                      Least_Of (Number - Item.Reference)))
   with
     Global => null,
     Pre    => Number <= Last_Age;

   --  For any line: delayed, withheld and reordered blocks are refused if they
   --  are too old.
   procedure A_Taken_Block_Is_Young
     (Item         : Session;
      Block        : Block_Data;
      Sender       : Station;
      Reference_At : Counter;
      Sealed_At    : Counter)
   with
     Global => null,
     Pre    =>
       Opens (Block, Sender, Item)
       and then Is_True (Item, Reference_At)
       and then Is_Honest
         (Item, Number_Of (Block, Sender, Item),
          Echo_Of (Block, Sender, Item), Reference_At, Sealed_At),
     Post   =>
       Item.Age <= Sealed_At
       or else Item.Age - Sealed_At <= Most_Age;

   procedure The_Reference_Stays_True
     (Item         : Session;
      Block        : Block_Data;
      Sender       : Station;
      Reference_At : Counter;
      Sealed_At    : Counter)
   with
     Global => null,
     Pre    =>
       Opens (Block, Sender, Item)
       and then Is_True (Item, Reference_At)
       and then Is_Honest
         (Item, Number_Of (Block, Sender, Item),
          Echo_Of (Block, Sender, Item), Reference_At, Sealed_At),
     Post   =>
       (if With_Newest (Item, Block, Sender).Reference =
             Number_Of (Block, Sender, Item)
        then Is_True (With_Newest (Item, Block, Sender), Sealed_At)
        else Is_True (With_Newest (Item, Block, Sender), Reference_At));

   --  Three blocks that arrive make a session: a call, its answer, and a
   --  sealed block. Up to three recorded calls between them do not prevent it.
   --  Each node needs a new nonce

   --  A call is taken and answered.
   procedure A_Call_Is_Answered
     (Item    : in out URV.Handshakes.Seal;
      Call    : Block_Data;
      Words   : out Block_Words;
      Result  : out Outcome)
   with
     Global => null,
     Pre    =>
       Item.Role = Aircraft
       and then Item.Format = 2
       and then Outcome_Of (Item, Call, True) = Hello_Taken,
     Post   =>
       Result = Hello_Taken
       and then Is_Answered (Item.Pending (Item.Latest))
       and then Item.Pending (Item.Latest).Number = Hello_Number (Call)
       and then Item.Pending (Item.Latest).Aircraft_Nonce = Item'Old.Own
       and then Item.Pending (Item.Latest).Ground_Nonce =
         Nonce_At (Call, Own_Place);

   --  Each answer has its turn: while the session in this place is to be
   --  answered, at least every fourth of the aircraft's hellos answers it

   function Distance (From, To : Pending_Place) return Natural is
     ((Integer (To) - Integer (From)) mod Integer (Pending_Place'Last))
   with Global => null;

   procedure Each_Answer_Has_Its_Turn
     (Item  : in out URV.Handshakes.Seal;
      Which : Pending_Place)
   with
     Global => null,
     Pre    =>
       Is_Answered (Item.Pending (Which)) and then Sends_Hello (Item),
     Post   =>
       To_Answer (Item'Old) = Which
       or else
         Distance (Item.Turn, Which) < Distance (Item.Turn'Old, Which);

   --  A pending session remains after one more call, unless that is the
   --  fourth.
   procedure A_Call_Displaces_The_Oldest
     (Item    : in out URV.Handshakes.Seal;
      Call    : Block_Data;
      Words   : out Block_Words;
      Result  : out Outcome)
   with
     Global => null,
     Pre    =>
       Item.Role = Aircraft
       and then Item.Format = 2
       and then Mark_Of (Call) = Hello_Mark,
     Post   =>
       (for all Which in Pending_Place =>
          (if Which /= Next_Place (Item'Old.Latest)
           then Item.Pending (Which) = Item'Old.Pending (Which)))
       and then Item.Latest in
         Item'Old.Latest | Next_Place (Item'Old.Latest);

   --  A sealed block of a pending session makes it the active session.
   procedure A_Sealed_Block_Completes
     (Item   : in out URV.Handshakes.Seal;
      Block  : Block_Data;
      Which  : Pending_Place;
      Words  : out Block_Words;
      Result : out Outcome)
   with
     Global => null,
     Pre    =>
       Item.Role = Aircraft
       and then Item.Format = 2
       and then Mark_Of (Block) = Sealed_Mark
       and then Opens (Block, Ground, Item.Pending (Which)),
     Post   =>
       Result in Taken
       and then Item.Active.Is_Present
       and then Item.Silence = 0
       and then
         (if Result = Opened_New_Session
          then (for some Each in Pending_Place =>
                  Each <= Which
                  and then Item.Active.Ground_Nonce =
                    Item'Old.Pending (Each).Ground_Nonce
                  and then Item.Active.Aircraft_Nonce =
                    Item'Old.Pending (Each).Aircraft_Nonce));

   --  A refused block changes nothing.
   procedure A_Refused_Block_Changes_Nothing
     (Item   : in out URV.Handshakes.Seal;
      Block  : Block_Data;
      Words  : out Block_Words;
      Result : out Outcome)
   with
     Global => null,
     Post   =>
       (if Result in Refused
        then Item = Item'Old
          and then (for all Each of Words => Each = 0));

   --  A node's keys, and those of its hellos, remain as configured: whatever
   --  comes, is sent, or passes (SEC-5).
   procedure Keys_Remain
     (Item   : URV.Handshakes.Seal;
      Block  : Block_Data;
      Frames : Counter)
   with
     Global => null,
     Post   =>
       After (Item, Block, Outcome_Of (Item, Block, True)).Keys = Item.Keys
       and then
         After (Item, Block, Outcome_Of (Item, Block, True)).Hellos =
           Item.Hellos
       and then After_Frames (Item, Frames).Keys = Item.Keys
       and then After_Frames (Item, Frames).Hellos = Item.Hellos
       and then Renewed (Item).Keys = Item.Keys
       and then Renewed (Item).Hellos = Item.Hellos
       and then Restarted (Item).Keys = Item.Keys
       and then Restarted (Item).Hellos = Item.Hellos;

   --  A session begins with a nonce of this node that it does not use again.
   procedure Own_Nonces_Are_Used_Once
     (Item   : in out URV.Handshakes.Seal;
      Block  : Block_Data;
      Words  : out Block_Words;
      Result : out Outcome)
   with
     Global => null,
     Pre    => Item.Format = 2,
     Post   =>
       (if Result = Hello_Taken and then Item.Role = Aircraft
        then Item.Own = Item.Own'Old + 1
          and then Item.Pending (Item.Latest).Aircraft_Nonce = Item.Own'Old
        elsif Result = Hello_Taken and then Is_Answer (Item'Old, Block)
        then Item.Own = Item.Own'Old + 1
          and then Item.Active.Ground_Nonce = Item.Own'Old
        else Item.Own = Item.Own'Old);

end Theorems.Seals;
