--  SPDX-License-Identifier: Apache-2.0

with AUnit.Assertions; use AUnit.Assertions;

with Checks;           use Checks;
with Expect_Value;
with Expectations;     use Expectations;
with URVOS;            use URVOS;
with Telemetry;        use Telemetry;
with Telemetry.Memory; use Telemetry.Memory;

separate (Link_Suite)
package body Board_Memory_Tests is

   --  The tests, in order.
   procedure Empty_State;
   procedure Where_To_Fill;
   procedure Takes;
   procedure Newest_First;
   procedure Busy_Is_Safe;

   procedure Expect is new Expect_Value (Slot);

   --  The board's operations on its buffers for the controller.
   procedure Take
     (Item  : in out Buffer_Pair;
      Data  : out Block_Data;
      Fresh : out Boolean);
   procedure Put
     (Item      : in out Buffer_Pair;
      Data      : Block_Data;
      Overwrote : out Boolean);

   --  A recognisable block.
   function Block (Mark : Byte) return Block_Data is ((others => Mark));

   --  A pair with these flags; its buffers hold blocks marked 1 and 2.
   function Pair
     (First_Full, Second_Full : Boolean;
      First_Busy, Second_Busy : Boolean;
      Newest                  : Slot) return Buffer_Pair
   is
     (Slots  =>
        (First  => (First_Full, First_Busy, 0, Block (1)),
         Second => (Second_Full, Second_Busy, 0, Block (2))),
      Newest => Newest);

   function Image (Item : Buffer_Pair) return String is
     ("full " & Item.Slots (First).Full'Image
      & " " & Item.Slots (Second).Full'Image
      & ", busy " & Item.Slots (First).Busy'Image
      & " " & Item.Slots (Second).Busy'Image
      & ", newest " & Item.Newest'Image);

   procedure Empty_State is
   begin
      for Which in Slot loop
         Expect ("full", Empty_Pair.Slots (Which).Full, False);
         Expect ("busy", Empty_Pair.Slots (Which).Busy, False);
         Expect_Number
           ("attempts", Integer (Empty_Pair.Slots (Which).Attempts), 0);
         Assert
           (Empty_Pair.Slots (Which).Data = Block (0),
            "data of an empty buffer is not zero, expected zero");
      end loop;
   end Empty_State;

   procedure Where_To_Fill is
      type Row is record
         First_Full, Second_Full : Boolean;
         First_Busy, Second_Busy : Boolean;
         Newest, Target          : Slot;
      end record;

      T : constant Boolean := True;
      F : constant Boolean := False;

      Table : constant array (Positive range <>) of Row :=
        --  One is not full: that one is filled, whichever is busy.
        ((F, T, F, F, Second, First),
         (F, T, F, T, Second, First),
         (T, F, F, F, First,  Second),
         (T, F, T, F, First,  Second),
         (F, T, F, F, First,  First),
         (T, F, F, F, Second, Second),

         --  Both are full: the one that is not busy.
         (T, T, T, F, First,  Second),
         (T, T, T, F, Second, Second),
         (T, T, F, T, First,  First),
         (T, T, F, T, Second, First),

         --  Both full, neither busy: the older one.
         (T, T, F, F, First,  Second),
         (T, T, F, F, Second, First),

         --  Both full and busy: the older one.
         (T, T, T, T, First,  Second),
         (T, T, T, T, Second, First));
   begin
      for Each of Table loop
         declare
            Before : constant Buffer_Pair :=
              Pair (Each.First_Full, Each.Second_Full,
                    Each.First_Busy, Each.Second_Busy, Each.Newest);
         begin
            Expect (Image (Before), To_Fill (Before), Each.Target);
         end;
      end loop;
   end Where_To_Fill;

   procedure Take
     (Item  : in out Buffer_Pair;
      Data  : out Block_Data;
      Fresh : out Boolean)
   is
   begin
      Fresh := Any_Full (Item);
      Data := Contents (Item);
      Item := Taken (Item);
   end Take;

   procedure Put
     (Item      : in out Buffer_Pair;
      Data      : Block_Data;
      Overwrote : out Boolean)
   is
   begin
      Overwrote := Both_Full (Item);
      Item := Filled (Item, Data);
   end Put;

   procedure Takes is
      Data  : Block_Data;
      Fresh : Boolean;
   begin
      for First_Full in Boolean loop
         for Second_Full in Boolean loop
            for Newest in Slot loop
               declare
                  Item : Buffer_Pair :=
                    Pair (First_Full, Second_Full, False, False, Newest);
                  Before : constant String := Image (Item);
               begin
                  Take (Item, Data, Fresh);
                  Expect
                    (Before & ", fresh", Fresh, First_Full or Second_Full);
                  if Fresh then
                     Expect
                       (Before & ", block", Data (1),
                        (if First_Full and Second_Full
                         then (if Newest = First then 1 else 2)
                         elsif First_Full then 1 else 2));
                  end if;
                  Expect (Before & ", full after", Any_Full (Item), False);
                  Take (Item, Data, Fresh);
                  Expect (Before & ", fresh twice", Fresh, False);
               end;
            end loop;
         end loop;
      end loop;
   end Takes;

   procedure Newest_First is
      Item      : Buffer_Pair := Empty_Pair;
      Data      : Block_Data;
      Flag      : Boolean;
   begin
      --  However many blocks are put in between, only the last one comes out,
      --  once.
      for Puts in Byte range 1 .. 5 loop
         for Number in 1 .. Puts loop
            Put (Item, Block (10 * Puts + Number), Flag);
            Expect
              ("put" & Number'Image & " of" & Puts'Image & " overwrote", Flag,
               Number > 2);
         end loop;
         Take (Item, Data, Flag);
         Expect ("fresh", Flag, True);
         Expect ("the block taken", Data (Data'Last), 10 * Puts + Puts);
         Take (Item, Data, Flag);
         Expect ("fresh again", Flag, False);
      end loop;
   end Newest_First;

   procedure Busy_Is_Safe is
      Item : Buffer_Pair := Pair (True, False, True, False, First);
      Flag : Boolean;
   begin
      --  Three more blocks come while the first is sent.
      for Mark in Byte range 11 .. 13 loop
         Put (Item, Block (Mark), Flag);
         Expect ("block" & Mark'Image & " overwrote", Flag, Mark > 11);
         Expect ("the one being sent", Item.Slots (First).Data (1), 1);
         Expect ("and is busy", Item.Slots (First).Busy, True);
         Expect ("the one that waits", Item.Slots (Second).Data (1), Mark);
      end loop;
   end Busy_Is_Safe;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "INI-4 a new pair is empty, available and clear",
         Empty_State'Access);
      Add
        (Suite, "LNK-4 a block goes where it does least harm",
         Where_To_Fill'Access);
      Add
        (Suite, "LNK-4 the controller takes the newest block, once",
         Takes'Access);
      Add
        (Suite, "TOU-1 with no buffer free the newest block replaces",
         Newest_First'Access);
      Add
        (Suite, "LNK-7 a block that is being sent is not overwritten",
         Busy_Is_Safe'Access);
   end Add_To;

end Board_Memory_Tests;
