--  SPDX-License-Identifier: Apache-2.0

with Checks;            use Checks;
with Expect_Value;
with Expectations;      use Expectations;
with Law_Rig;
with URVOS;             use URVOS;
with URV.Buffers;       use URV.Buffers;
with URV.Console_Watch; use URV.Console_Watch;
with URV.CORE_Memory;
with URV.Law_Gains;     use URV.Law_Gains;

separate (Law_Suite)
package body Console_Watch_Tests is

   --  The tests, in order.
   procedure In_Flight;
   procedure On_The_Ground;
   procedure Slow_And_Low;
   procedure Not_Known;
   procedure Every_Other_Downlink;
   procedure Cleared_CORE;

   procedure Expect_Input is new Expect_Value (Converter_Input);

   Standing : constant Downlink_Buffer :=
     (Law_Rig.Level with delta Airspeed => 0, Altitude => 3);

   No_Downlink : constant Downlink_Buffer :=
     (Standing with delta Error_Status => Stale_Data);

   --  The watch after one second of these sensors with a live console.
   function After_A_Second (Sensors : Downlink_Buffer) return Watch;

   --  The converter's input in the frame after it.
   function Input_Of
     (Silent : Frame_Count; Sensors : Downlink_Buffer) return Converter_Input
   is
     (Next (After_A_Second (Sensors), Silent, Sensors).Input);

   function After_A_Second (Sensors : Downlink_Buffer) return Watch is
   begin
      return Item : Watch do
         for Frame in 1 .. Good_Scans loop
            Item := Next (Item, 0, Sensors);
            Expect_Input ("the console is there", Item.Input, Live);
         end loop;
      end return;
   end After_A_Second;

   procedure In_Flight is
   begin
      Expect_Input ("0.48 s", Input_Of (24, Law_Rig.Level), Live);
      Expect_Input ("0.5 s", Input_Of (25, Law_Rig.Level), Held);
      Expect_Input ("2 s", Input_Of (100, Law_Rig.Level), Held);
      Expect_Input
        ("for ever", Input_Of (Frame_Count'Last, Law_Rig.Level), Held);
   end In_Flight;

   procedure On_The_Ground is
   begin
      Expect_Input ("0.48 s", Input_Of (24, Standing), Live);
      Expect_Input ("0.5 s", Input_Of (25, Standing), Held);
      Expect_Input ("1.98 s", Input_Of (99, Standing), Held);
      Expect_Input ("2 s", Input_Of (100, Standing), Safe_Words);
      Expect_Input
        ("for ever", Input_Of (Frame_Count'Last, Standing), Safe_Words);
   end On_The_Ground;

   procedure Slow_And_Low is
      Fast : constant Downlink_Buffer :=
        (Standing with delta Airspeed => Flying_Speed);
      High : constant Downlink_Buffer :=
        (Standing with delta Altitude => Flying_Height);
      Just : constant Downlink_Buffer :=
        (Standing with delta
           Airspeed => Flying_Speed - 1, Altitude => Flying_Height - 1);
   begin
      Expect_Input ("42 kt", Input_Of (100, Fast), Held);
      Expect_Input ("50 ft", Input_Of (100, High), Held);
      Expect_Input ("just below both", Input_Of (100, Just), Safe_Words);
   end Slow_And_Low;

   procedure Not_Known is
      Item : Watch;
   begin
      --  The first scan sets the sensors' words. One second of good scans
      --  follows.
      for Frame in 1 .. Good_Scans loop
         Item := Next (Item, Frame_Count'Last, Standing);
         Expect_Input ("not yet believed", Item.Input, Held);
      end loop;
      Item := Next (Item, Frame_Count'Last, Standing);
      Expect_Input ("believed", Item.Input, Safe_Words);
      for Frame in 1 .. Bad_Scans - 1 loop
         Item := Next (Item, Frame_Count'Last, No_Downlink);
         Expect_Input ("a downlink is missing", Item.Input, Safe_Words);
      end loop;
      Item := Next (Item, Frame_Count'Last, No_Downlink);
      Expect_Input ("the link is lost", Item.Input, Held);
      for Frame in 1 .. Good_Scans - 1 loop
         Item := Next (Item, Frame_Count'Last, Standing);
         Expect_Input ("not yet believed again", Item.Input, Held);
      end loop;
      Item := Next (Item, Frame_Count'Last, Standing);
      Expect_Input ("believed again", Item.Input, Safe_Words);
   end Not_Known;

   procedure Every_Other_Downlink is
      Item : Watch;
   begin
      --  The first scan sets the sensors' words.
      for Pair in 1 .. Good_Scans loop
         Item := Next (Item, Frame_Count'Last, Standing);
         Item := Next (Item, Frame_Count'Last, No_Downlink);
         Expect_Input ("not yet believed", Item.Input, Held);
      end loop;
      for Pair in 1 .. 5 * Good_Scans loop
         Item := Next (Item, Frame_Count'Last, Standing);
         Expect_Input ("believed", Item.Input, Safe_Words);
         Item := Next (Item, Frame_Count'Last, No_Downlink);
         Expect_Input ("the other is missing", Item.Input, Safe_Words);
      end loop;
   end Every_Other_Downlink;

   procedure Cleared_CORE is
   begin
      Expect
        ("cleared: old",
         Downlink_Of (URV.CORE_Memory.Cleared.Downlink) (Error_Status),
         Stale_Data);
      Expect
        ("written: as it is",
         Downlink_Of (Standing) = Standing, True);
   end Cleared_CORE;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "SAF-10 in flight a lost console brings no scan",
           In_Flight'Access);
      Add (Suite, "SAF-10 on the ground it brings the safe words after 2 s",
           On_The_Ground'Access);
      Add (Suite, "SAF-10 on the ground is slow and low",
           Slow_And_Low'Access);
      Add (Suite, "SAF-10 whatever is not known is flight",
           Not_Known'Access);
      Add (Suite, "SAF-10 every other downlink is enough to know the place",
           Every_Other_Downlink'Access);
      Add (Suite, "SAF-10 a CORE memory that is cleared says nothing",
           Cleared_CORE'Access);
   end Add_To;

end Console_Watch_Tests;
