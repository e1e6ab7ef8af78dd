--  SPDX-License-Identifier: Apache-2.0

--  The software of a node, as the kernel calls it (report, sections 2.2, 3.1
--  and 3.2; KRN-1 to KRN-6, FRM-4). The application has one instance, and
--  URVOS.Virtual_Nodes, URVOS.Real_Time_Nodes or URVOS.Bare_Nodes runs it.

with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Lists;
with URVOS.Task_Trees;   use URVOS.Task_Trees;
with URVOS.Usual_Frames;

--  A signature: who instantiates with it references its formals.
pragma Warnings (Off, "*is not referenced");

generic
   with package Tasks is new URVOS.Task_Lists (<>);

   --  The next step of a task, its initialisation on the first run, and the
   --  call that ends the step.
   with procedure Run_Step
     (Who       : Tasks.Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   --  Phases 1 and 2 of a start. They end in the application's START call,
   --  unless the self-test has failed.
   with procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);

   --  Takes the present time, which stamps later reports.
   with procedure Set_Time (Now : Clock_Tick);

   --  A task was released late, or ran into its next release (FRM-4).
   with procedure Report_Overrun (Who : Task_Id);

   --  The clock has ticked Ticks times since the last call. Request is the
   --  application's request for the present frame (FRM-6). Virtual time has
   --  no such requests.
   with procedure Look_At_Frame
     (Ticks   : Tick_Count;
      Request : in out Frame_Request)
   is URVOS.Usual_Frames;
package URVOS.Node_Software with SPARK_Mode is

   --  A task's next step by its identification. One that is no task's ceases
   --  at once.
   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call)
   with Inline;

end URVOS.Node_Software;
