--  SPDX-License-Identifier: Apache-2.0

--  The board's dual-ported memory, which it shares with the controller
--  (report, appendix A.2, A.3, figure A-5; LNK-4, LNK-7, D-18, D-20).
--
--  There are two receive and two transmit buffers, each with a full flag and a
--  busy semaphore. A pair records which of its buffers was filled last, so no
--  reader ever gets an older block after a newer one.

package Telemetry.Memory with Pure, SPARK_Mode is

   type Slot is (First, Second);

   function Other (Which : Slot) return Slot is
     (if Which = First then Second else First)
   with Global => null;

   --  The number of transmissions of a block. The second is the last.
   type Attempt_Count is range 0 .. 2;

   type Buffer is record
      Full     : Boolean       := False;
      Busy     : Boolean       := False;
      Attempts : Attempt_Count := 0;
      Data     : Block_Data    := (others => 0);
   end record;

   --  The same relation as the type's own equality. As a function it is one
   --  name for the provers; the type's own is a quantifier nested in every
   --  statement about pairs.
   overriding function "=" (One, Another : Buffer) return Boolean is
     (One.Full = Another.Full
      and then One.Busy = Another.Busy
      and then One.Attempts = Another.Attempts
      and then One.Data = Another.Data)
   with Global => null;

   type Buffer_Array is array (Slot) of Buffer;

   type Buffer_Pair is record
      Slots  : Buffer_Array;
      Newest : Slot := First;
   end record;

   Empty_Pair : constant Buffer_Pair := (others => <>);

   function Any_Full (Pair : Buffer_Pair) return Boolean is
     (Pair.Slots (First).Full or else Pair.Slots (Second).Full)
   with Global => null;

   function Both_Full (Pair : Buffer_Pair) return Boolean is
     (Pair.Slots (First).Full and then Pair.Slots (Second).Full)
   with Global => null;

   --  The buffer to fill: one that is not full; if both are full, one that is
   --  not busy, the older first; if both are busy too, the older one.
   function To_Fill (Pair : Buffer_Pair) return Slot is
     (if not Pair.Slots (Other (Pair.Newest)).Full
      then Other (Pair.Newest)
      elsif not Pair.Slots (Pair.Newest).Full
      then Pair.Newest
      elsif not Pair.Slots (Other (Pair.Newest)).Busy
      then Other (Pair.Newest)
      elsif not Pair.Slots (Pair.Newest).Busy
      then Pair.Newest
      else Other (Pair.Newest))
   with
     Global => null,
     Post   =>
       (if not Both_Full (Pair)
        then not Pair.Slots (To_Fill'Result).Full
        elsif Pair.Slots (To_Fill'Result).Busy
        then Pair.Slots (Other (To_Fill'Result)).Busy);

   --  The newest full buffer.
   function Newest_Full (Pair : Buffer_Pair) return Slot is
     (if Pair.Slots (Pair.Newest).Full then Pair.Newest
      else Other (Pair.Newest))
   with
     Global => null,
     Pre    => Any_Full (Pair),
     Post   => Pair.Slots (Newest_Full'Result).Full;

   --  The changes of a pair, as functions; some procedures below make them in
   --  place.

   --  No buffer is busy any more.
   function Released (Pair : Buffer_Pair) return Buffer_Pair is
     ((Pair with delta
         Slots =>
           (for Each in Slot => (Pair.Slots (Each) with delta Busy => False))))
   with Global => null;

   --  The block in one buffer is finished.
   function Emptied (Pair : Buffer_Pair; Which : Slot) return Buffer_Pair is
     ((Pair with delta
         Slots => (Pair.Slots with delta
           Which => (Pair.Slots (Which) with delta
             Full => False, Busy => False, Attempts => 0))))
   with Global => null;

   --  The outcome of a block's transmission; Open before it has ended.
   type Delivery is (Open, Confirmed, Failed);

   --  A block that failed twice is scrapped (LNK-6).
   function Is_Scrapped
     (Pair  : Buffer_Pair;
      Which : Slot;
      Block : Delivery) return Boolean
   is
     (Block = Failed
      and then Pair.Slots (Which).Attempts = Attempt_Count'Last)
   with Global => null;

   --  The transmission of the block in one buffer has ended. A block that
   --  failed once stays for another try.
   function Settled
     (Pair  : Buffer_Pair;
      Which : Slot;
      Block : Delivery) return Buffer_Pair
   is
     (if Block = Open then Pair
      elsif Block = Confirmed or else Is_Scrapped (Pair, Which, Block)
      then Emptied (Pair, Which)
      else
        (Pair with delta
           Slots => (Pair.Slots with delta
             Which => (Pair.Slots (Which) with delta Busy => False))))
   with Global => null;

   --  Another transmission of the block in one buffer begins. The other buffer
   --  is cleared if it is full (LNK-7).
   function Begun (Pair : Buffer_Pair; Which : Slot) return Buffer_Pair is
     ((Pair with delta
         Slots => (Pair.Slots with delta
           Which         => (Pair.Slots (Which) with delta
             Busy     => True,
             Attempts => Pair.Slots (Which).Attempts + 1),
           Other (Which) => (Pair.Slots (Other (Which)) with delta
             Full     => False,
             Attempts =>
               (if Pair.Slots (Other (Which)).Full
                then 0
                else Pair.Slots (Other (Which)).Attempts)))))
   with
     Global => null,
     Pre    => Pair.Slots (Which).Attempts < Attempt_Count'Last;

   --  The controller has taken from a receive pair.
   function Taken (Pair : Buffer_Pair) return Buffer_Pair is
     ((Pair with delta
         Slots =>
           (for Each in Slot => (Pair.Slots (Each) with delta Full => False))))
   with Global => null;

   --  The controller has put a block into a transmit pair.
   function Filled
     (Pair : Buffer_Pair;
      Data : Block_Data) return Buffer_Pair
   is
     ((Newest => To_Fill (Pair),
       Slots  => (Pair.Slots with delta
         To_Fill (Pair) =>
           (Full => True, Busy => False, Attempts => 0, Data => Data))))
   with Global => null;

   --  The block that the controller takes from a receive pair: the newest, or
   --  zeros if there is none. An older one is discarded.
   function Contents (Pair : Buffer_Pair) return Block_Data is
     (if Any_Full (Pair) then Pair.Slots (Newest_Full (Pair)).Data
      else (others => 0))
   with Global => null;

   --  In place

   procedure Take_All (Pair : in out Buffer_Pair)
   with
     Inline,
     Global => null,
     Post   => Pair = Taken (Pair'Old);

   procedure Release (Pair : in out Buffer_Pair)
   with
     Inline,
     Global => null,
     Post   => Pair = Released (Pair'Old);

   procedure Settle
     (Pair  : in out Buffer_Pair;
      Which : Slot;
      Block : Delivery)
   with
     Global => null,
     Post   => Pair = Settled (Pair'Old, Which, Block);

   procedure Begin_Block (Pair : in out Buffer_Pair; Which : Slot)
   with
     Inline,
     Global => null,
     Pre    => Pair.Slots (Which).Attempts < Attempt_Count'Last,
     Post   => Pair = Begun (Pair'Old, Which);

   procedure Fill (Pair : in out Buffer_Pair; Data : Block_Data)
   with
     Global => null,
     Post   => Pair = Filled (Pair'Old, Data);

   procedure Copy_Contents (Pair : Buffer_Pair; Data : out Block_Data)
   with
     Inline,
     Global => null,
     Post   => Data = Contents (Pair);

end Telemetry.Memory;
