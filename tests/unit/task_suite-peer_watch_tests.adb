--  SPDX-License-Identifier: Apache-2.0

with Checks;                use Checks;
with Expectations;          use Expectations;
with Host.Text_Numbers;     use Host.Text_Numbers;
with Partitions.Peer_Watch; use Partitions.Peer_Watch;
with URVOS;                 use URVOS;

separate (Task_Suite)
package body Peer_Watch_Tests is

   use type Host.Text_Numbers.Number;

   --  The tests, in order.
   procedure Taken;
   procedure All_Refused;
   procedure Judged_Late;
   procedure Some_Refused;
   procedure Another_Key;
   procedure Last_Values;

   procedure Expect_State
     (What : String; Item : Watch; State : Peer_State);

   procedure Expect_State
     (What : String; Item : Watch; State : Peer_State) is
   begin
      Expect (What & ": " & Name (Present (Item)) & ", not " & Name (State),
              Present (Item) = State, True);
   end Expect_State;

   procedure Taken is
      Item : Watch;
   begin
      for Frame in Number range 0 .. 9 loop
         Look (Item, 0, 0, Frame);
      end loop;
      Expect_State ("nothing came", Item, Never_Heard);
      Look (Item, 1, 0, 10);
      Look (Item, 1, 0, 11);
      Expect_State ("not judged yet", Item, Never_Heard);
      Look (Item, 1, 0, 12);
      Expect_State ("two frames later", Item, Is_Heard);
      for Frame in Number range 13 .. 10 + Longest_Silence loop
         Look (Item, 1, 0, Frame);
         Expect_State ("within a second", Item, Is_Heard);
      end loop;
      Look (Item, 1, 0, 11 + Longest_Silence);
      Expect_State ("after it", Item, Is_Lost);
      for Frame in Number range 12 + Longest_Silence
                                .. 14 + Longest_Silence loop
         Look (Item, 2, 0, Frame);
      end loop;
      Expect_State ("again", Item, Is_Heard);
   end Taken;

   procedure All_Refused is
      Item : Watch;
   begin
      for Frame in Number range 0 .. 5_000 loop
         Look (Item, Count (Frame), Count (Frame), Frame);
         Expect_State ("all refused", Item, Never_Heard);
      end loop;
   end All_Refused;

   procedure Judged_Late is
      Item : Watch;
   begin
      --  A block is refused up to two frames after it came.
      for Frame in Number range 0 .. 5_000 loop
         Look
           (Item, Received => Count (Frame),
            Dropped => Count (Frame) - Count'Min (Count (Frame), 2),
            Frame => Frame);
         Expect_State ("refused late", Item, Never_Heard);
      end loop;
   end Judged_Late;

   procedure Some_Refused is
      Item : Watch;
   begin
      for Frame in Number range 0 .. 500 loop
         Look (Item, Count (Frame), Count (Frame) / 2, Frame);
      end loop;
      Expect_State ("every second one is taken", Item, Is_Heard);
   end Some_Refused;

   procedure Another_Key is
      Item : Watch;
   begin
      --  A known peer returns with another key.
      for Frame in Number range 0 .. 100 loop
         Look (Item, Count (Frame), 0, Frame);
      end loop;
      Expect_State ("its own key", Item, Is_Heard);
      for Frame in Number range 101 .. 200 loop
         Look (Item, Count (Frame), Count (Frame) - 100, Frame);
      end loop;
      Expect_State ("another key", Item, Is_Lost);
      for Frame in Number range 201 .. 210 loop
         Look (Item, Count (Frame), 100, Frame);
      end loop;
      Expect_State ("its own again", Item, Is_Heard);
   end Another_Key;

   procedure Last_Values is
      Item : Watch;
   begin
      for Frame in Number range 0 .. 9 loop
         Look (Item, Count'Last, Count'Last, Frame);
         Look (Item, 0, Count'Last, Frame);
      end loop;
      Expect_State ("more dropped than came", Item, Never_Heard);
   end Last_Values;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "RTP-7 a peer is heard, lost after a second, heard again",
         Taken'Access);
      Add
        (Suite, "RTP-7 a peer whose blocks are all refused is never heard",
         All_Refused'Access);
      Add
        (Suite, "RTP-7 nor when they are refused two frames after they came",
         Judged_Late'Access);
      Add
        (Suite, "RTP-7 a peer is heard when some blocks are taken",
         Some_Refused'Access);
      Add
        (Suite, "RTP-7 a peer that comes back with another key is lost",
         Another_Key'Access);
      Add
        (Suite, "RTP-7 counts at their last value are no error",
         Last_Values'Access);
   end Add_To;

end Peer_Watch_Tests;
