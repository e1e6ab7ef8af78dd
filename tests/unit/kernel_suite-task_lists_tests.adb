--  SPDX-License-Identifier: Apache-2.0

with Checks;           use Checks;
with Expect_Value;
with Expectations;     use Expectations;
with GSC;
with MCS;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Task_Lists;
with URVOS.Task_Trees; use URVOS.Task_Trees;

separate (Kernel_Suite)
package body Task_Lists_Tests is

   --  The tests, in order.
   procedure Trees;
   procedure Numbers;
   procedure Processors_Of_Tasks;
   procedure Releases;
   procedure Any_Lists;

   procedure Expect is new Expect_Value (Task_Id);

   --  For any number of processors, each task of a list is in exactly one
   --  tree, once, with its priority; no tree has other tasks. A tree keeps the
   --  order of the list and has no gap.
   generic
      with package Lists is new URVOS.Task_Lists (<>);
   procedure Expect_Whole_Trees (What : String);

   procedure Expect_Whole_Trees (What : String) is
      Seen : array (Task_Id) of Natural;
      Last : Task_Id;
      Over : Boolean;
      Tree : Task_Tree;
   begin
      for Processors in Processor_Number loop
         Seen := (others => 0);
         for Which in Processor_Number loop
            Tree := Lists.Tree_Of (Processors, Which, 7);
            Last := No_Task;
            Over := False;
            for Header of Tree loop
               if Header.Id = No_Task then
                  Over := True;
                  Expect
                    (What & ", after the end", Header = Null_Header, True);
               else
                  Expect (What & ", a gap before", Over, False);
                  Expect (What & ", is a task", Lists.Is_Task (Header.Id),
                          True);
                  Expect (What & ", in order", Header.Id > Last, True);
                  Expect_Number
                    (What & ", priority of" & Header.Id'Image,
                     Integer (Header.Initial_Priority),
                     32 - Integer (Header.Id));
                  Expect (What & ", start", Header.Start_Time, 7);
                  Expect_Number
                    (What & ", processor of" & Header.Id'Image,
                     Integer
                       (Lists.Processor_Of
                          (Lists.Task_Of (Header.Id), Processors)),
                     Integer (Which));
                  Seen (Header.Id) := Seen (Header.Id) + 1;
                  Last := Header.Id;
               end if;
            end loop;
         end loop;
         for Id in Task_Id loop
            Expect_Number
              (What & ", processors" & Processors'Image & ", task"
               & Id'Image,
               Seen (Id), (if Lists.Is_Task (Id) then 1 else 0));
         end loop;
      end loop;
   end Expect_Whole_Trees;

   procedure Trees is
      procedure Of_Aircraft is new Expect_Whole_Trees (MCS.Tasks);
      procedure Of_Ground is new Expect_Whole_Trees (GSC.Tasks);
   begin
      Of_Aircraft ("aircraft");
      Of_Ground ("ground");

      --  On one processor the tree has all of them, and then ends.
      for Which in TCB_Number range 1 .. GSC.Task_List'Length loop
         Expect
           ("header" & Which'Image, GSC.Tasks.Tree_Of (1, 1, 0) (Which).Id,
            Task_Id (Which));
      end loop;
      Expect
        ("end", GSC.Tasks.Tree_Of (1, 1, 0) (GSC.Task_List'Length + 1).Id,
         No_Task);
      Expect ("none on a second", GSC.Tasks.Tree_Of (1, 2, 0) (1).Id, No_Task);
   end Trees;

   procedure Numbers is
      use type MCS.Task_Name;
      Number : Task_Id := 0;
   begin
      --  Numbers from 1, in the order of the names.
      for Who in MCS.Task_Name loop
         Number := Number + 1;
         Expect (Who'Image, MCS.Tasks.Id_Of (Who), Number);
         Expect (Who'Image & " is back", MCS.Tasks.Task_Of (Number) = Who,
                 True);
      end loop;
      for Id in Task_Id loop
         Expect
           ("is a task:" & Id'Image, MCS.Tasks.Is_Task (Id),
            Id in 1 .. MCS.Task_List'Length);
         Expect
           ("is one of the ground:" & Id'Image, GSC.Tasks.Is_Task (Id),
            Id in 1 .. GSC.Task_List'Length);
      end loop;
   end Numbers;

   procedure Processors_Of_Tasks is
      use MCS;
      use GSC;
   begin
      --  The boards' tasks are on the first processor, data collection and
      --  CORE's on the second.
      for Who in MCS.Task_Name loop
         Expect_Number
           ("aircraft, " & Who'Image,
            Integer (MCS.Tasks.Processor_Of (Who, 2)),
            (if Who in MDCIN_Task | MDCOUT_Task | LAW_Task
                       | MCS.CORE_Task | MCS.LOG_Task
             then 2 else 1));
      end loop;
      for Who in GSC.Task_Name loop
         Expect_Number
           ("ground, " & Who'Image,
            Integer (GSC.Tasks.Processor_Of (Who, 2)),
            (if Who in GDCIN_Task | GDCOUT_Task | GSC.CORE_Task | GSC.LOG_Task
             then 2 else 1));
      end loop;
   end Processors_Of_Tasks;

   procedure Releases is
   begin
      for Now in Clock_Tick range 0 .. 39 loop
         for Who in MCS.Task_Name loop
            Expect
              (Who'Image & " after" & Now'Image,
               MCS.Tasks.Next_Release_Of (Who, Now),
               (Now / 10 + 1) * 10
               + Tick (MCS.Task_List (Who) (Report).Offset));
         end loop;
      end loop;
   end Releases;

   procedure Any_Lists is

      --  As many tasks as task control blocks.
      type Full_Name is range 1 .. Number_Of_TCBs;
      type Full_Table is array (Full_Name) of Task_Attributes;

      type Lone_Name is (Alone);
      type Lone_Table is array (Lone_Name) of Task_Attributes;

   begin
      --  All tasks on either processor, split at any of them, or mixed.
      for Split in Full_Name'Base'(0) .. Full_Name'Last loop
         declare
            Table : constant Full_Table :=
              (for Who in Full_Name =>
                 (Schedule_Name =>
                    (Offset    => 3,
                     Processor => (if Who > Split then 2 else 1))));

            Mixed : constant Full_Table :=
              (for Who in Full_Name =>
                 (Schedule_Name =>
                    (Offset    => 3,
                     Processor =>
                       (if (Who + Split) mod 3 = 0 then 1 else 2))));

            package Lists is
              new URVOS.Task_Lists (Full_Name, Full_Table, Table);
            package Mixed_Lists is
              new URVOS.Task_Lists (Full_Name, Full_Table, Mixed);
            procedure Expect_Split is new Expect_Whole_Trees (Lists);
            procedure Expect_Mixed is new Expect_Whole_Trees (Mixed_Lists);
         begin
            Expect_Split ("split at" & Split'Image);
            Expect_Mixed ("mixed from" & Split'Image);
         end;
      end loop;

      for Processor in Processor_Number loop
         declare
            Table : constant Lone_Table :=
              (Alone => (Schedule_Name => (9, Processor)));
            package Lists is
              new URVOS.Task_Lists (Lone_Name, Lone_Table, Table);
            procedure Expect_Trees is new Expect_Whole_Trees (Lists);
         begin
            Expect_Trees ("one task");
         end;
      end loop;
   end Any_Lists;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "KRN-1 KRN-5 D-23 each task is in one processor's tree, once",
         Trees'Access);
      Add
        (Suite, "KRN-1 a task's number is its place in the list",
         Numbers'Access);
      Add
        (Suite, "EXT-4 KRN-5 each task is on the processor of its boards",
         Processors_Of_Tasks'Access);
      Add
        (Suite, "FRM-2 FRM-3 a task's next release is in the next frame",
         Releases'Access);
      Add
        (Suite, "KRN-1 KRN-5 any list makes whole trees, up to 16 tasks",
         Any_Lists'Access);
   end Add_To;

end Task_Lists_Tests;
