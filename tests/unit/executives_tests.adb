with Checks;           use Checks;
with Expect_Value;
with Expectations;     use Expectations;
with GSC;
with MCS;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Executives;

package body Executives_Tests is

   --  The tests, in order.
   procedure Offsets;
   procedure Each_Frame;
   procedure Overruns;
   procedure Same_Tick_Twice;
   procedure End_Of_Time;

   type Task_Name is (Early, Late, Later);
   type Offset_Table is array (Task_Name) of Minor_Frame;

   procedure Run (Who : Task_Name);

   package Executive is new URVOS.Executives
     (Task_Name, Offset_Table, (Early => 0, Late => 4, Later => 4), Run);

   procedure Expect is new Expect_Value (Task_Name);

   --  What ran since it was last looked at, in order.
   type Name_List is array (1 .. 100) of Task_Name;
   History : Name_List;
   Ran     : Natural := 0;

   ---------
   -- Run --
   ---------

   procedure Run (Who : Task_Name) is
   begin
      Ran           := Ran + 1;
      History (Ran) := Who;
   end Run;

   -------------
   -- Offsets --
   -------------

   procedure Offsets is
   begin
      --  The table of FRM-2, in its order.
      Expect_Number ("MCS TELIN", Integer (MCS.Offsets (MCS.TELIN_Task)), 0);
      Expect_Number ("MCS AD", Integer (MCS.Offsets (MCS.AD_Task)), 0);
      Expect_Number ("MDCIN", Integer (MCS.Offsets (MCS.MDCIN_Task)), 1);
      Expect_Number ("MDCOUT", Integer (MCS.Offsets (MCS.MDCOUT_Task)), 1);
      Expect_Number ("PWM", Integer (MCS.Offsets (MCS.PWM_Task)), 2);
      Expect_Number ("MCS TELOUT", Integer (MCS.Offsets (MCS.TELOUT_Task)), 2);
      Expect_Number ("MCS CORE", Integer (MCS.Offsets (MCS.CORE_Task)), 4);
      Expect_Number ("GSC TELIN", Integer (GSC.Offsets (GSC.TELIN_Task)), 0);
      Expect_Number ("GSC AD", Integer (GSC.Offsets (GSC.AD_Task)), 0);
      Expect_Number ("GDCIN", Integer (GSC.Offsets (GSC.GDCIN_Task)), 1);
      Expect_Number ("GDCOUT", Integer (GSC.Offsets (GSC.GDCOUT_Task)), 1);
      Expect_Number ("GSC TELOUT", Integer (GSC.Offsets (GSC.TELOUT_Task)), 2);
      Expect_Number ("GSC CORE", Integer (GSC.Offsets (GSC.CORE_Task)), 4);

      --  The log, which the report leaves for later.
      Expect_Number ("MCS LOG", Integer (MCS.Offsets (MCS.LOG_Task)), 5);
      Expect_Number ("GSC LOG", Integer (GSC.Offsets (GSC.LOG_Task)), 5);

      --  SET-1: these tasks and no others.
      Expect_Number ("tasks of MCS", MCS.Offsets'Length, 8);
      Expect_Number ("tasks of GSC", GSC.Offsets'Length, 7);
   end Offsets;

   ----------------
   -- Each_Frame --
   ----------------

   procedure Each_Frame is
   begin
      Executive.Start (7);
      for Now in Tick range 8 .. 59 loop
         Ran := 0;
         Executive.Run_Due_Tasks (Now);
         if Now < 10 then
            Expect_Number ("before the first frame", Ran, 0);
         elsif Now mod 10 = 0 then
            Expect_Number ("tick" & Now'Image, Ran, 1);
            Expect ("tick" & Now'Image, History (1), Early);
         elsif Now mod 10 = 4 then
            Expect_Number ("tick" & Now'Image, Ran, 2);
            Expect ("tick" & Now'Image, History (1), Late);
            Expect ("tick" & Now'Image, History (2), Later);
         else
            Expect_Number ("tick" & Now'Image, Ran, 0);
         end if;
      end loop;
      Expect ("overruns", Executive.Overruns, 0);
   end Each_Frame;

   --------------
   -- Overruns --
   --------------

   procedure Overruns is
   begin
      Executive.Start (0);
      Ran := 0;

      --  The processor was busy at tick 10.
      Executive.Run_Due_Tasks (11);
      Expect_Number ("released late", Ran, 1);
      Expect ("overruns", Executive.Overruns, 1);
      Expect ("next release", Executive.Wake_Up (Early), 20);

      Ran := 0;
      Executive.Run_Due_Tasks (14);
      Expect_Number ("in time", Ran, 2);
      Expect ("overruns", Executive.Overruns, 1);

      --  It was busy for more than a frame: each task runs once, late, and
      --  then in its place again.
      Ran := 0;
      Executive.Run_Due_Tasks (37);
      Expect_Number ("released late", Ran, 3);
      Expect ("overruns", Executive.Overruns, 4);
      Expect ("next release", Executive.Wake_Up (Early), 40);
      Expect ("next release", Executive.Wake_Up (Later), 44);

      --  At the very last tick of its frame a task is late, too.
      Ran := 0;
      Executive.Run_Due_Tasks (49);
      Expect ("overruns", Executive.Overruns, 7);
      Expect ("next release", Executive.Wake_Up (Late), 54);

      Executive.Start (60);
      Expect ("overruns after a start", Executive.Overruns, 0);
      Expect ("release after a start", Executive.Wake_Up (Late), 74);
   end Overruns;

   ---------------------
   -- Same_Tick_Twice --
   ---------------------

   procedure Same_Tick_Twice is
   begin
      Executive.Start (0);
      Ran := 0;
      Executive.Run_Due_Tasks (10);
      Executive.Run_Due_Tasks (10);
      Expect_Number ("runs", Ran, 1);
   end Same_Tick_Twice;

   -----------------
   -- End_Of_Time --
   -----------------

   procedure End_Of_Time is
   begin
      Executive.Start (Last_Tick - 10);
      Ran := 0;
      Executive.Run_Due_Tasks (Last_Tick - 9);
      Executive.Run_Due_Tasks (Last_Tick - 5);
      Expect_Number ("in the last frame", Ran, 3);
      Ran := 0;
      Executive.Run_Due_Tasks (Last_Tick);
      Executive.Run_Due_Tasks (Last_Tick);
      Expect_Number ("at the last tick", Ran, 0);
   end End_Of_Time;

   ------------
   -- Add_To --
   ------------

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "FRM-2 SET-1 both nodes release their tasks at the offsets",
         Offsets'Access);
      Add
        (Suite, "FRM-3 each task runs once a major frame, at its offset",
         Each_Frame'Access);
      Add
        (Suite, "FRM-3 a task runs once, however often its tick is told",
         Same_Tick_Twice'Access);
      Add
        (Suite, "FRM-3 after the clock's last frame no task is released",
         End_Of_Time'Access);
      Add
        (Suite, "FRM-4 a task released late is counted and comes back",
         Overruns'Access);
   end Add_To;

end Executives_Tests;
