--  SPDX-License-Identifier: Apache-2.0

with Checks;             use Checks;
with Expect_Value;
with Expectations;       use Expectations;
with GSC;
with MCS;
with URVOS.Executives;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

separate (Kernel_Suite)
package body Executives_Tests is

   --  The tests, in order.
   procedure Offsets;
   procedure Fast_Offsets;
   procedure Each_Frame;
   procedure Overruns;
   procedure Same_Tick_Twice;
   procedure End_Of_Time;
   procedure Gives_Way;
   procedure Ends;

   --  Three tasks that sleep like those of the nodes, one that calls EXIT
   --  three times in a frame, and one that ends.
   Early  : constant Task_Id := 1;
   Late   : constant Task_Id := 2;
   Later  : constant Task_Id := 3;
   Polite : constant Task_Id := 4;
   Mortal : constant Task_Id := 5;

   Offset_Of : constant array (Early .. Mortal) of Minor_Frame :=
     (Early => 0, Late => 4, Later => 4, Polite => 0, Mortal => 0);

   Exits : Natural := 0;

   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   procedure Report_Overrun (Who : Task_Id);

   package Executive is new URVOS.Executives (Step, Report_Overrun);

   procedure Expect is new Expect_Value (Task_Id);

   --  The tasks that ran since the last look, in order.
   type Id_List is array (1 .. 100) of Task_Id;
   History : Id_List;
   Ran     : Natural := 0;

   Last_Overrun : Task_Id := No_Task;

   --  Loads tasks, or ticks the clock, and runs the due tasks.
   procedure Start (Tree : Task_Tree; Now : Clock_Tick);
   procedure Clock_Interrupt (Now : Clock_Tick);

   --  Loads the three tasks at a tick.
   procedure Start (Now : Clock_Tick);

   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call) is
   begin
      Call := (Sleep_Call, Next_Release (Now, Offset_Of (Who)), others => <>);
      if not First_Run then
         Ran           := Ran + 1;
         History (Ran) := Who;
         if Who = Polite and then Exits < 3 then
            Exits := Exits + 1;
            Call  := (Name => Exit_Call, others => <>);
         elsif Who = Mortal then
            Call := (Name => Terminate_Call, others => <>);
         end if;
      end if;
   end Step;

   procedure Report_Overrun (Who : Task_Id) is
   begin
      Last_Overrun := Who;
   end Report_Overrun;

   procedure Start (Tree : Task_Tree; Now : Clock_Tick) is
   begin
      Executive.Start (Tree, Now);
      Executive.Run_Until_Idle;
   end Start;

   procedure Clock_Interrupt (Now : Clock_Tick) is
   begin
      Executive.Clock_Interrupt (Now);
      Executive.Run_Until_Idle;
   end Clock_Interrupt;

   procedure Start (Now : Clock_Tick) is
   begin
      Start
        (((Early, Now, 3), (Late, Now, 2), (Later, Now, 1),
          others => Null_Header), Now);
   end Start;

   procedure Offsets is

      --  The table of FRM-2. The tasks that the report leaves for later (the
      --  log, the check of the program memory and any other) are released
      --  after those.

      Of_The_Log   : constant Minor_Frame := 5;
      Of_The_Check : constant Minor_Frame := 6;

      function Is_Right
        (Who    : MCS.Task_Name;
         Offset : Minor_Frame) return Boolean
      is
        (case Who is
            when MCS.AD_Task | MCS.TELIN_Task      => Offset = 0,
            when MCS.MDCIN_Task | MCS.MDCOUT_Task
              | MCS.LAW_Task                       => Offset = 1,
            when MCS.PWM_Task | MCS.TELOUT_Task    => Offset = 2,
            when MCS.CORE_Task                     => Offset = 4,
            when MCS.LOG_Task                      => Offset = Of_The_Log,
            when others => Offset >= Of_The_Check);

      function Is_Right
        (Who    : GSC.Task_Name;
         Offset : Minor_Frame) return Boolean
      is
        (case Who is
            when GSC.AD_Task | GSC.TELIN_Task      => Offset = 0,
            when GSC.GDCIN_Task | GSC.GDCOUT_Task  => Offset = 1,
            when GSC.TELOUT_Task                   => Offset = 2,
            when GSC.CORE_Task                     => Offset = 4,
            when GSC.LOG_Task                      => Offset = Of_The_Log,
            when others => Offset >= Of_The_Check);
   begin
      for Who in MCS.Task_Name loop
         Expect
           ("offset of MCS " & Who'Image,
            Is_Right (Who, MCS.Task_List (Who) (Report).Offset), True);
      end loop;
      for Who in GSC.Task_Name loop
         Expect
           ("offset of GSC " & Who'Image,
            Is_Right (Who, GSC.Task_List (Who) (Report).Offset), True);
      end loop;
      Expect_Number
        ("the check in the aircraft",
         Integer (MCS.Task_List (MCS.SELF_TEST_Task) (Report).Offset),
         Integer (Of_The_Check));
      Expect_Number
        ("the check on the ground",
         Integer (GSC.Task_List (GSC.SELF_TEST_Task) (Report).Offset),
         Integer (Of_The_Check));
   end Offsets;

   procedure Fast_Offsets is

      --  The table of FRM-5

      function Is_Right
        (Who    : MCS.Task_Name;
         Offset : Minor_Frame) return Boolean
      is
        (case Who is
            when MCS.AD_Task | MCS.MDCOUT_Task | MCS.TELOUT_Task =>
              Offset = 1,
            when MCS.TELIN_Task | MCS.MDCIN_Task | MCS.LAW_Task
              | MCS.PWM_Task | MCS.CORE_Task        => Offset = 4,
            when others                             => Offset in 5 .. 8);

      function Is_Right
        (Who    : GSC.Task_Name;
         Offset : Minor_Frame) return Boolean
      is
        (case Who is
            when GSC.AD_Task | GSC.GDCOUT_Task | GSC.TELOUT_Task =>
              Offset = 0,
            when GSC.TELIN_Task | GSC.GDCIN_Task
              | GSC.CORE_Task                       => Offset = 5,
            when others                             => Offset in 7 .. 8);

      --  The log and the check of the program memory are alone on the second
      --  processor.
      use type MCS.Task_Name;
      use type GSC.Task_Name;
   begin
      for Who in MCS.Task_Name loop
         Expect
           ("offset of MCS " & Who'Image,
            Is_Right (Who, MCS.Task_List (Who) (Fast).Offset), True);
         Expect_Number
           ("processor of MCS " & Who'Image,
            Integer (MCS.Tasks.Processor_Of (Who, 2, Fast)),
            (if Who > MCS.CORE_Task then 2 else 1));
      end loop;
      for Who in GSC.Task_Name loop
         Expect
           ("offset of GSC " & Who'Image,
            Is_Right (Who, GSC.Task_List (Who) (Fast).Offset), True);
         Expect_Number
           ("processor of GSC " & Who'Image,
            Integer (GSC.Tasks.Processor_Of (Who, 2, Fast)),
            (if Who > GSC.CORE_Task then 2 else 1));
      end loop;
   end Fast_Offsets;

   procedure Each_Frame is
   begin
      Ran := 0;
      Start (7);
      Expect_Number ("only initialised", Ran, 0);
      for Now in Tick range 8 .. 59 loop
         Ran := 0;
         Clock_Interrupt (Now);
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
   end Each_Frame;

   procedure Overruns is
      Before : constant Natural := Natural (Executive.Overruns);

      procedure Expect_Overruns (Number : Natural);

      procedure Expect_Overruns (Number : Natural) is
      begin
         Expect_Number
           ("overruns", Natural (Executive.Overruns) - Before, Number);
      end Expect_Overruns;
   begin
      Start (0);
      Ran := 0;

      --  The processor was busy at tick 10.
      Clock_Interrupt (11);
      Expect_Number ("released late", Ran, 1);
      Expect_Overruns (1);
      Expect ("who", Last_Overrun, Early);

      Ran := 0;
      Clock_Interrupt (14);
      Expect_Number ("in time", Ran, 2);
      Expect_Overruns (1);

      --  It was busy for more than a frame. Each task runs once, late, and
      --  then on time again. Each has also missed its next release.
      Ran := 0;
      Clock_Interrupt (37);
      Expect_Number ("released late", Ran, 3);
      Expect_Overruns (7);
      Clock_Interrupt (40);
      Expect_Number ("in time again", Ran, 4);
      Expect_Overruns (7);
   end Overruns;

   procedure Same_Tick_Twice is
   begin
      Start (0);
      Ran := 0;
      Clock_Interrupt (10);
      Clock_Interrupt (10);
      Expect_Number ("runs", Ran, 1);

      --  A clock that runs back releases no task either.
      Clock_Interrupt (3);
      Clock_Interrupt (10);
      Expect_Number ("runs", Ran, 1);
   end Same_Tick_Twice;

   procedure End_Of_Time is
   begin
      Start (Last_Tick - 10);
      Ran := 0;
      Clock_Interrupt (Last_Tick - 9);
      Clock_Interrupt (Last_Tick - 5);
      Expect_Number ("in the last frame", Ran, 3);
      Ran := 0;
      Clock_Interrupt (Last_Tick);
      Clock_Interrupt (Last_Tick);
      Expect_Number ("at the last tick", Ran, 0);
   end End_Of_Time;

   procedure Gives_Way is
   begin
      --  The polite task has the lowest priority. Without a ready task of
      --  higher priority it keeps the processor, at the next tick.
      Start
        (((Polite, 0, 1), (Early, 0, 3), others => Null_Header), 0);
      Exits := 0;
      Ran := 0;
      Clock_Interrupt (10);
      Expect_Number ("runs at tick 10", Ran, 2);
      Expect ("first", History (1), Early);
      Expect ("then", History (2), Polite);
      Clock_Interrupt (11);
      Expect_Number ("runs on at tick 11", Ran, 3);

      --  It still polls when the other task is due again, and gives way.
      Ran := 0;
      Clock_Interrupt (20);
      Expect_Number ("runs at tick 20", Ran, 3);
      Expect ("first", History (1), Polite);
      Expect ("then", History (2), Early);
      Expect ("and again", History (3), Polite);
   end Gives_Way;

   procedure Ends is
   begin
      Start
        (((Mortal, 0, 5), (Early, 0, 3), others => Null_Header), 0);
      Ran := 0;
      Clock_Interrupt (10);
      Clock_Interrupt (20);
      Expect_Number ("runs", Ran, 3);
      Expect ("first", History (1), Mortal);
      Expect ("second", History (2), Early);
      Expect ("third", History (3), Early);
   end Ends;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "FRM-2 SET-1 both nodes release their tasks at the offsets",
         Offsets'Access);
      Add
        (Suite, "FRM-5 SET-1 so they do in the fast schedule",
         Fast_Offsets'Access);
      Add
        (Suite, "FRM-3 KRN-3 each task runs once a major frame, at its offset",
         Each_Frame'Access);
      Add
        (Suite, "FRM-3 a task runs once for repeated reports of its tick",
         Same_Tick_Twice'Access);
      Add
        (Suite, "FRM-3 after the clock's last frame no task is released",
         End_Of_Time'Access);
      Add
        (Suite, "FRM-4 a task released late is counted and comes back",
         Overruns'Access);
      Add
        (Suite, "KRN-2 D-25 a task that calls EXIT gives way to higher ones",
         Gives_Way'Access);
      Add
        (Suite, "KRN-4 a task that ends never runs again",
         Ends'Access);
   end Add_To;

end Executives_Tests;
