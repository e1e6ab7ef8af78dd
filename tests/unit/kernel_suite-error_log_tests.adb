--  SPDX-License-Identifier: Apache-2.0

with Checks;            use Checks;
with Expect_Value;
with Expectations;      use Expectations;
with URVOS;             use URVOS;
with URVOS.Error_Logs;
with URVOS.Frames;      use URVOS.Frames;
with URV.Errors;
with URV.Shared_Errors;

separate (Kernel_Suite)
package body Error_Log_Tests is

   --  The tests, in order.
   procedure Empty;
   procedure First_And_Last;
   procedure Several_At_Once;
   procedure Flood;
   procedure Saturation;
   procedure Clock_Set_Back;
   procedure Shell_Stamps;
   procedure Shell_Keeps;

   type Colour is (Red, Green, Blue);

   package Logs is new URVOS.Error_Logs (Colour);
   use Logs;

   procedure Expect is new Expect_Value (Colour);

   --  Expects one kind's history; below, the same for the shell's kinds.
   procedure Expect_History
     (What        : String;
      Actual      : History;
      Occurrences : Count;
      First, Last : Clock_Tick;
      Detail      : Word);

   Shell : URV.Shared_Errors.Shared_Log;

   function Of_Shell
     (Kind : URV.Errors.Error_Kind) return URV.Errors.Logs.History
   is
     (URV.Errors.Logs.History_Of (Shell.Contents, Kind));

   procedure Expect_In_Shell
     (What        : String;
      Kind        : URV.Errors.Error_Kind;
      Occurrences : Count;
      First, Last : Clock_Tick;
      Detail      : Word);

   procedure Expect_History
     (What        : String;
      Actual      : History;
      Occurrences : Count;
      First, Last : Clock_Tick;
      Detail      : Word) is
   begin
      Expect (What & ", count", Actual.Occurrences, Occurrences);
      Expect (What & ", first", Actual.First, First);
      Expect (What & ", last", Actual.Last, Last);
      Expect (What & ", detail", Actual.Last_Detail, Detail);
   end Expect_History;

   procedure Expect_In_Shell
     (What        : String;
      Kind        : URV.Errors.Error_Kind;
      Occurrences : Count;
      First, Last : Clock_Tick;
      Detail      : Word)
   is
      Actual : constant URV.Errors.Logs.History := Of_Shell (Kind);
   begin
      Expect (What & ", count", Actual.Occurrences, Occurrences);
      Expect (What & ", first", Actual.First, First);
      Expect (What & ", last", Actual.Last, Last);
      Expect (What & ", detail", Actual.Last_Detail, Detail);
   end Expect_In_Shell;

   procedure Empty is
   begin
      for Kind in Colour loop
         Expect_History
           (Kind'Image, History_Of (Empty_Log, Kind), 0, 0, 0, 0);
      end loop;
      Expect ("total", Total (Empty_Log), 0);
   end Empty;

   procedure First_And_Last is
      Log : Error_Log := Empty_Log;
   begin
      Add (Log, Green, 120, 7);
      Expect_History ("once", History_Of (Log, Green), 1, 120, 120, 7);
      Expect ("latest", Latest (Log), Green);

      Add (Log, Green, 130, 9);
      Add (Log, Red, 135, 1);
      Add (Log, Green, 140, 8);
      Expect_History ("green", History_Of (Log, Green), 3, 120, 140, 8);
      Expect_History ("red", History_Of (Log, Red), 1, 135, 135, 1);
      Expect_History ("blue", History_Of (Log, Blue), 0, 0, 0, 0);
      Expect ("total", Total (Log), 4);
      Expect ("latest", Latest (Log), Green);
   end First_And_Last;

   procedure Several_At_Once is
      Log : Error_Log := Empty_Log;
   begin
      Add (Log, Blue, 10, 5, How_Often => 5);
      Add (Log, Blue, 20, 3, How_Often => 3);
      Expect_History ("blue", History_Of (Log, Blue), 8, 10, 20, 3);
      Expect ("total", Total (Log), 8);
   end Several_At_Once;

   procedure Flood is
      Log : Error_Log := Empty_Log;
   begin
      Add (Log, Red, 50, 11);
      for Time in Clock_Tick range 51 .. 100_050 loop
         Add (Log, Green, Time, Word (Time mod 2 ** 16));
      end loop;
      Add (Log, Blue, 100_051, 13);

      Expect_History
        ("before the flood", History_Of (Log, Red), 1, 50, 50, 11);
      Expect_History
        ("the flood", History_Of (Log, Green), 100_000, 51, 100_050,
         Word (Tick'(100_050) mod 2 ** 16));
      Expect_History
        ("after the flood", History_Of (Log, Blue), 1, 100_051, 100_051, 13);
      Expect ("total", Total (Log), 100_002);
   end Flood;

   procedure Saturation is
      Log : Error_Log := Empty_Log;
   begin
      Add (Log, Red, 1, 0);
      Add (Log, Green, 2, 0, How_Often => Count'Last - 1);
      Expect ("total", Total (Log), Count'Last);
      Add (Log, Green, 3, 4);
      Expect ("green, at its last value", History_Of (Log, Green).Occurrences,
              Count'Last);
      Add (Log, Green, 5, 6);
      Expect_History
        ("green, beyond", History_Of (Log, Green), Count'Last, 2, 5, 6);
      Add (Log, Green, 7, 8, How_Often => Count'Last);
      Expect_History
        ("green, far beyond", History_Of (Log, Green), Count'Last, 2, 7, 8);
      Expect_History ("red", History_Of (Log, Red), 1, 1, 1, 0);
      Expect ("total", Total (Log), Count'Last);

      --  The same at the last tick.
      Add (Log, Blue, Last_Tick, Word'Last);
      Expect_History
        ("blue", History_Of (Log, Blue), 1, Last_Tick, Last_Tick, Word'Last);
   end Saturation;

   procedure Clock_Set_Back is
      Log : Error_Log := Empty_Log;
   begin
      --  A restart may count from 0 again; the log keeps the times that it was
      --  given.
      Add (Log, Red, 1_000, 0);
      Add (Log, Red, 3, 0);
      Expect_History ("red", History_Of (Log, Red), 2, 1_000, 3, 0);
   end Clock_Set_Back;

   procedure Shell_Stamps is
      use URV.Errors;
   begin
      Shell.Set_Time (0);
      Shell.Clear;
      Shell.Set_Time (41);
      Shell.Report (No_Input, 0);
      Shell.Report (Input_Out_Of_Range, 5);
      Shell.Set_Time (51);
      Shell.Report (No_Input, 2);
      Shell.Report_Several (Link_Block_Bad, 4, 4);
      Expect_In_Shell ("no input", No_Input, 2, 41, 51, 2);
      Expect_In_Shell ("range", Input_Out_Of_Range, 1, 41, 41, 5);
      Expect_In_Shell ("bad blocks", Link_Block_Bad, 4, 51, 51, 4);
      Expect_In_Shell ("resets", Link_Reset, 0, 0, 0, 0);
   end Shell_Stamps;

   procedure Shell_Keeps is
      use URV.Errors;
   begin
      --  Every kind has its own place.
      Shell.Clear;
      for Kind in Error_Kind loop
         Shell.Set_Time (100 + Error_Kind'Pos (Kind));
         Shell.Report (Kind, Error_Kind'Pos (Kind));
      end loop;
      for Kind in Error_Kind loop
         Expect_In_Shell
           (Kind'Image, Kind, 1, 100 + Error_Kind'Pos (Kind),
            100 + Error_Kind'Pos (Kind), Error_Kind'Pos (Kind));
      end loop;

      Shell.Clear;
      for Kind in Error_Kind loop
         Expect_In_Shell (Kind'Image & " cleared", Kind, 0, 0, 0, 0);
      end loop;

      --  Time goes on.
      Shell.Report (Warm_Reset, 0);
      Expect_In_Shell
        ("after", Warm_Reset, 1, 100 + Error_Kind'Pos (Error_Kind'Last),
         100 + Error_Kind'Pos (Error_Kind'Last), 0);
   end Shell_Keeps;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "EXT-1 in an empty log nothing has happened", Empty'Access);
      Add
        (Suite, "EXT-1 a history has count, first and last time, last detail",
         First_And_Last'Access);
      Add
        (Suite, "EXT-1 several errors at once are counted as several",
         Several_At_Once'Access);
      Add
        (Suite, "EXT-1 a flood of one kind hides no other", Flood'Access);
      Add
        (Suite, "EXT-1 counts stay at their last value", Saturation'Access);
      Add
        (Suite, "EXT-1 a clock set back does not hurt the log",
         Clock_Set_Back'Access);
      Add
        (Suite, "EXT-1 a report has the tick of the last interrupt",
         Shell_Stamps'Access);
      Add
        (Suite, "EXT-1 every kind is kept until the log is cleared",
         Shell_Keeps'Access);
   end Add_To;

end Error_Log_Tests;
