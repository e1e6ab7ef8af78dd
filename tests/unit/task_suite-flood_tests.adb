--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time; use Ada.Real_Time;

with Checks;                  use Checks;
with Expectations;            use Expectations;
with Partitions.Flood_Guards; use Partitions.Flood_Guards;
with Telemetry;

separate (Task_Suite)
package body Flood_Tests is

   --  The tests, in order.
   procedure A_Line_Is_None;
   procedure A_Late_Look_Is_None;
   procedure No_More_Than_A_Line;
   procedure The_Line_After_It;

   --  Any time will do: a guard uses only differences.
   Began : constant Time := Time_Of (1_000, Time_Span_Zero);

   Character_Time : constant Time_Span :=
     Microseconds (Telemetry.Microseconds_Per_Character);

   --  The amount that a line has brought up to then.
   function Brought (Since : Time_Span) return Amount is
     (Amount (Since / Character_Time));

   procedure A_Line_Is_None is
      Item     : Guard;
      Before   : Amount;
      Is_Flood : Boolean;
   begin
      for Step in 1 .. 200 loop
         declare
            --  From 0.1 ms to 20 ms between two looks.
            Pause : constant Time_Span := Microseconds (100) * Step;
         begin
            Start (Item, Began);
            Before := 0;
            for Look in 1 .. 500 loop
               Take
                 (Item, Began + Look * Pause,
                  Brought (Look * Pause) - Before, Is_Flood);
               Before := Brought (Look * Pause);
               Expect ("a flood, looked at every" & Step'Image, Is_Flood,
                       False);
            end loop;
         end;
      end loop;
   end A_Line_Is_None;

   procedure A_Late_Look_Is_None is
      Item     : Guard;
      Is_Flood : Boolean;
   begin
      --  One second of a line, found after one second, is cut at the look:
      --  there is room for a burst only.
      Start (Item, Began);
      Take (Item, Began + Seconds (1), Burst, Is_Flood);
      Expect ("a burst is a flood", Is_Flood, False);
      Take (Item, Began + Seconds (1), 1, Is_Flood);
      Expect ("more at the same time is", Is_Flood, True);
   end A_Late_Look_Is_None;

   procedure No_More_Than_A_Line is
      Item     : Guard;
      Is_Flood : Boolean;
      Granted  : Natural;
      Seconds_Long : constant := 2;
   begin
      --  10, 20 .. 1000 datagrams in a tenth of a millisecond: 100,000 a
      --  second and more.
      for Tens in 1 .. 100 loop
         Start (Item, Began);
         Granted := 0;
         for Look in 1 .. Seconds_Long * 10_000 loop
            Take
              (Item, Began + Look * Microseconds (100), Amount (10 * Tens),
               Is_Flood);
            if not Is_Flood then
               Granted := Granted + 10 * Tens;
            end if;
         end loop;
         Expect
           ("of" & Tens'Image & " tens no more than a line brings",
            Granted <= Seconds_Long * 1_000_000
              / Telemetry.Microseconds_Per_Character + 2 * Natural (Burst),
            True);
      end loop;
   end No_More_Than_A_Line;

   procedure The_Line_After_It is
      Item     : Guard;
      Is_Flood : Boolean;
      Now      : Time := Began;
   begin
      Start (Item, Began);
      for Look in 1 .. 1_000 loop
         Now := Now + Rest;
         Take (Item, Now, 200, Is_Flood);
      end loop;
      Expect ("it is a flood", Is_Flood, True);

      --  The first look finds the rest, or the line alone.
      Now := Now + Rest;
      Take (Item, Now, Brought (Rest) + 1, Is_Flood);
      for Look in 1 .. 1_000 loop
         Now := Now + Rest;
         Take (Item, Now, Brought (Rest) + 1, Is_Flood);
         Expect ("a flood after it", Is_Flood, False);
      end loop;
   end The_Line_After_It;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "RTP-3 the rate of a line is no flood",
         A_Line_Is_None'Access);
      Add
        (Suite, "RTP-3 the backlog of a late machine is no flood",
         A_Late_Look_Is_None'Access);
      Add
        (Suite, "RTP-3 of a flood no more is taken than a line brings",
         No_More_Than_A_Line'Access);
      Add
        (Suite, "RTP-3 the line is heard from the second look after a flood",
         The_Line_After_It'Access);
   end Add_To;

end Flood_Tests;
