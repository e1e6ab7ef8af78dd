--  SPDX-License-Identifier: Apache-2.0

--  A scheduler as one would write it without a thought for speed: every TCB
--  has the name of its queue and a number that tells when it came there,
--  and each choice looks at all of them. The tests hold the kernel's
--  scheduler against it.

with URVOS;              use URVOS;
with URVOS.Arrangements; use URVOS.Arrangements;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Schedulers;   use URVOS.Schedulers;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

package Naive_Schedulers is

   type Naive_Task is record
      Header      : Task_Header;
      Queue       : Queue_Name := Free;
      Arrival     : Natural    := 0;
      New_Release : Boolean    := False;
      First_Run   : Boolean    := False;
   end record;

   type Naive_Tasks is array (TCB_Number) of Naive_Task;

   type Naive_Scheduler is record
      Tasks    : Naive_Tasks;
      Arrivals : Natural    := 0;
      Now      : Clock_Tick := 0;
      Overruns : Count      := 0;
   end record;

   procedure Start
     (Model : out Naive_Scheduler;
      Tree  : Task_Tree;
      Now   : Clock_Tick);

   procedure Load (Model : in out Naive_Scheduler; Header : Task_Header);

   procedure Dispatch (Model : in out Naive_Scheduler);

   procedure Wake (Model : in out Naive_Scheduler; Now : Clock_Tick);

   procedure Exit_Call (Model : in out Naive_Scheduler);

   procedure Sleep (Model : in out Naive_Scheduler; Until_Tick : Tick);

   procedure Terminate_Caller (Model : in out Naive_Scheduler);

   function Has
     (Model : Naive_Scheduler; Queue : Queue_Name) return Boolean
   is (for some Each of Model.Tasks => Each.Queue = Queue);

   --  Expects that both are in the same state, all that can be asked for.
   procedure Expect_Same
     (When_It_Was : String;
      S           : Scheduler;
      Model       : Naive_Scheduler);

end Naive_Schedulers;
