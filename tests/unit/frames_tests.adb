--  SPDX-License-Identifier: Apache-2.0

with Checks;       use Checks;
with Expectations; use Expectations;
with URVOS.Frames; use URVOS.Frames;

package body Frames_Tests is

   --  The tests, in order.
   procedure Time_Units;
   procedure Advance;
   procedure Clock_At_Limit;
   procedure Next_Frames;
   procedure Releases;
   procedure One_Frame;

   procedure Time_Units is
   begin
      Expect_Number ("microseconds a tick", Microseconds_Per_Tick, 2_000);
      Expect_Number ("ticks a major frame", Ticks_Per_Major_Frame, 10);
      Expect_Number
        ("microseconds a major frame",
         Microseconds_Per_Tick * Ticks_Per_Major_Frame, 20_000);
      Expect_Number ("first minor frame", Integer (Minor_Frame'First), 0);
      Expect_Number ("last minor frame", Integer (Minor_Frame'Last), 9);
   end Time_Units;

   procedure Advance is
      Now : Clock_Tick := 0;
   begin
      for Minor in 1 .. 1_000 loop
         Now := Advanced (Now);
         Expect ("clock", Now, Tick (Minor));
         Expect_Number
           ("minor frame", Integer (Minor_Frame_Of (Now)), Minor mod 10);
      end loop;
   end Advance;

   procedure Clock_At_Limit is
      Seven_Days : constant := 7 * 24 * 3_600 * 500;
      Now        : Clock_Tick := Last_Tick - 1;
   begin
      Expect
        ("clock in a flight of seven days", Advanced (Seven_Days),
         Seven_Days + 1);
      Now := Advanced (Now);
      Expect ("clock at its last tick", Now, Last_Tick);
      Now := Advanced (Now);
      Expect ("clock after its last tick", Now, Last_Tick);
      Expect ("next frame is in the future", Next_Frame (Now) > Now, True);
      Expect
        ("and no overflow with the greatest offset",
         Next_Release (Now, Minor_Frame'Last), Tick'Last);
   end Clock_At_Limit;

   procedure Next_Frames is
      type Row is record
         Now, Frame : Tick;
      end record;

      Last_Frame : constant Tick := Last_Tick / 10 * 10;

      Table : constant array (Positive range <>) of Row :=
        ((0, 10), (1, 10), (9, 10), (10, 20), (11, 20), (19, 20),
         (123_456, 123_460), (123_459, 123_460), (123_460, 123_470),

         --  Beyond 16 and 32 bits.
         (65_535, 65_540), (65_536, 65_540),
         (2 ** 31 - 1, 2_147_483_650), (2 ** 32, 4_294_967_300),
         (Last_Frame - 1, Last_Frame), (Last_Frame, Last_Frame + 10));
   begin
      for Each of Table loop
         Expect
           ("next frame at" & Each.Now'Image, Next_Frame (Each.Now),
            Each.Frame);
      end loop;
   end Next_Frames;

   procedure Releases is
   begin
      for Now in Tick range 0 .. 100 loop
         for Offset in Minor_Frame loop
            Expect
              ("release at" & Now'Image & ", offset" & Offset'Image,
               Next_Release (Now, Offset),
               (Now / 10 + 1) * 10 + Tick (Offset));
         end loop;
      end loop;
   end Releases;

   procedure One_Frame is
      Release : Tick := 4;
   begin
      --  A task with offset 4 that runs when released comes back every
      --  10 ticks, also when it runs up to the last tick of its frame.
      for Delay_Ticks in Tick range 0 .. 5 loop
         Expect ("release", Release, 4 + 10 * Delay_Ticks);
         Release := Next_Release (Release + Delay_Ticks, 4);
      end loop;
   end One_Frame;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "FRM-1 ten minor frames of 2 ms are a major frame of 20 ms",
         Time_Units'Access);
      Add
        (Suite, "FRM-1 the clock advances by one tick a minor frame",
         Advance'Access);
      Add
        (Suite, "FRM-1 at its last tick the clock stands still",
         Clock_At_Limit'Access);
      Add
        (Suite, "FRM-3 the next frame begins at the next multiple of ten",
         Next_Frames'Access);
      Add
        (Suite, "FRM-3 a release is the next frame plus the offset",
         Releases'Access);
      Add
        (Suite, "FRM-3 a task is released once a major frame",
         One_Frame'Access);
   end Add_To;

end Frames_Tests;
