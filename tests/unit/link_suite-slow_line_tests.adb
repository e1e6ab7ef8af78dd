--  SPDX-License-Identifier: Apache-2.0

with Checks;           use Checks;
with Expect_Value;
with Expectations;     use Expectations;
with Link_Rig;         use Link_Rig;
with Telemetry;        use Telemetry;
with Telemetry.Boards; use Telemetry.Boards;
with URVOS;            use URVOS;

separate (Link_Suite)
package body Slow_Line_Tests is

   procedure Every_Delay;
   procedure Not_Told;
   procedure Waits;
   procedure Storms;

   procedure Expect is new Expect_Value (Character_Times);
   procedure Expect is new Expect_Value (Round_Trip_Time);

   --  The slowest line for which the nodes' frame has room.
   Slowest : constant Line_Time := Line_Time (Longest_Round_Trip / 2);

   procedure Every_Delay is
      Frames : constant := 8;
   begin
      for One_Way in 0 .. Slowest loop
         for Phase in 0 .. Frame - 1
           when Is_Tried (Phase + Natural (One_Way))
         loop
            declare
               What : constant String :=
                 One_Way'Image & " characters, phase" & Phase'Image;
               Item : Link := Slow_Link (One_Way);
            begin
               Fly (Item, Frames, 1, Phase);
               Expect
                 (What & ", blocks up",
                  Control_Of (Item.Aircraft_Board).Messages, Frames);
               Expect
                 (What & ", less than half the blocks down",
                  Control_Of (Item.Ground_Board).Messages < Frames / 2 - 1,
                  False);
               Expect (What & ", resets", Resets (Item), 0);
            end;
         end loop;
      end loop;
   end Every_Delay;

   procedure Not_Told is
      Item : Link := Slow_Link (Line_Time'Last, Told => False);
   begin
      Fly (Item, 8, 1, Phase => 40);
      Expect ("blocks down", Control_Of (Item.Ground_Board).Messages, 0);
      Expect
        ("the ground resets itself", Tally (Item.Ground_Board).Resets >= 8,
         True);
   end Not_Told;

   procedure Waits is

      --  Expects the waits of a board with this round trip.
      procedure Expect_Waits (Time : Round_Trip_Time);

      procedure Expect_Waits (Time : Round_Trip_Time) is
         Item : Board := New_Board (Ground, Uplink_Length, Downlink_Length);
         Data : constant Telemetry.Byte_Array (1 .. Longest_Block) :=
           (others => 0);
         Send, Overwrote : Boolean;
         Unused          : Byte;
      begin
         Set_Round_Trip (Item, Time);
         Put (Item, Data, Overwrote);
         loop
            Next_Character (Item, Send, Unused);
            exit when not Send;
            Elapse (Item, 1);
         end loop;
         Expect ("for an answer", Time_Left (Item), Dead_Space_On (Time));
         Elapse (Item, Dead_Space_On (Time));
         Expect
           ("before it starts afresh", Time_Left (Item), Idle_Time_On (Time));

         --  A start of the board keeps the line's delay.
         Start (Item);
         Expect ("after a start", Time_Left (Item), Idle_Time_On (Time));
         Expect ("told", Control_Of (Item).Round_Trip, Time);
      end Expect_Waits;
   begin
      for Time in Round_Trip_Time loop
         Expect_Waits (Time);
      end loop;
      for Line in Line_Delay loop
         Expect
           ("the round trip of" & Line'Image & " us, rounded up",
            Integer (Round_Trip_Of (Line)) * Microseconds_Per_Character in
              2 * Line .. 2 * Line + Microseconds_Per_Character - 1,
            True);
      end loop;
      Expect
        ("for the slowest line", Round_Trip_Of (Line_Delay'Last),
         Longest_Round_Trip);
   end Waits;

   procedure Storms is
      Flights : constant := 5;
      Mark    : Byte;
   begin
      --  After a storm the boards recover within two frames. Three frames then
      --  deliver each uplink, once.
      Start_Rain;
      for One_Way in 0 .. Slowest loop
         for Flight in 1 .. Flights
           when Is_Tried (Flights * Natural (One_Way) + Flight)
         loop
            declare
               What : constant String :=
                 One_Way'Image & " characters, storm" & Flight'Image;
               Item : Link := Slow_Link (One_Way);
            begin
               Fly (Item, 50, 1, Phase => 37 * Flight, Fault => Rain'Access);
               Fly (Item, 3, 101, Phase => 40);
               for Number in Byte range 104 .. 106 loop
                  Give (Item, Ground, Number);
                  Give (Item, Aircraft, Number);
                  Run (Item, Frame);
                  Take (Item, Aircraft, Mark);
                  Expect (What & ": block up", Mark, Number);
                  Take (Item, Ground, Mark);
                  Expect (What & ": block down", Mark, Number);
               end loop;
            end;
         end loop;
      end loop;
   end Storms;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "LNK-11 by any line with room, at any phase, blocks cross",
         Every_Delay'Access);
      Add
        (Suite, "LNK-11 boards that know of no delay give up on a slow line",
         Not_Told'Access);
      Add
        (Suite, "LNK-11 D-38 both waits are longer by the round trip",
         Waits'Access);
      Add
        (Suite, "LNK-11 LNK-9 by a slow line a storm is overcome",
         Storms'Access);
   end Add_To;

end Slow_Line_Tests;
