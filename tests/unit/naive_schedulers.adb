--  SPDX-License-Identifier: Apache-2.0

with Expect_Value;
with Expectations; use Expectations;

package body Naive_Schedulers is

   procedure Expect is new Expect_Value (Queue_Name);
   procedure Expect is new Expect_Value (Task_Id);
   procedure Expect is new Expect_Value (Priority);

   --  The first of two leaves the queue that both are in before the other.
   function Is_Sooner (First, Other : Naive_Task) return Boolean is
     (case First.Queue is
         when Ready =>
            First.Header.Initial_Priority > Other.Header.Initial_Priority
            or else
              (First.Header.Initial_Priority = Other.Header.Initial_Priority
               and then First.Arrival < Other.Arrival),
         when Timer =>
            First.Header.Start_Time < Other.Header.Start_Time
            or else
              (First.Header.Start_Time = Other.Header.Start_Time
               and then First.Arrival < Other.Arrival),
         when Running | Free =>
            First.Arrival < Other.Arrival);

   --  The first of a queue that has one.
   function First_Of
     (Model : Naive_Scheduler; Queue : Queue_Name) return TCB_Number;

   --  Puts a TCB into a queue.
   procedure Put
     (Model : in out Naive_Scheduler;
      Which : TCB_Number;
      Queue : Queue_Name);

   function First_Of
     (Model : Naive_Scheduler; Queue : Queue_Name) return TCB_Number is
   begin
      for Which in TCB_Number loop
         if Model.Tasks (Which).Queue = Queue
           and then
             (for all Other in TCB_Number =>
                Other = Which
                or else Model.Tasks (Other).Queue /= Queue
                or else Is_Sooner (Model.Tasks (Which), Model.Tasks (Other)))
         then
            return Which;
         end if;
      end loop;
      raise Program_Error with "an empty queue has no first";
   end First_Of;

   procedure Put
     (Model : in out Naive_Scheduler;
      Which : TCB_Number;
      Queue : Queue_Name) is
   begin
      Model.Arrivals := Model.Arrivals + 1;
      Model.Tasks (Which).Arrival := Model.Arrivals;
      Model.Tasks (Which).Queue := Queue;
   end Put;

   procedure Start
     (Model : out Naive_Scheduler;
      Tree  : Task_Tree;
      Now   : Clock_Tick) is
   begin
      Model := (Now => Now, others => <>);
      for Which in TCB_Number loop
         Put (Model, Which, Free);
      end loop;
      for Header of Tree loop
         exit when Header.Id = No_Task;
         Load (Model, Header);
      end loop;
      Dispatch (Model);
   end Start;

   procedure Load (Model : in out Naive_Scheduler; Header : Task_Header) is
      TCB : constant TCB_Number := First_Of (Model, Free);
   begin
      Model.Tasks (TCB).Header := Header;
      Model.Tasks (TCB).New_Release := True;
      Model.Tasks (TCB).First_Run := True;
      Put
        (Model, TCB, (if Header.Start_Time > Model.Now then Timer else Ready));
   end Load;

   procedure Dispatch (Model : in out Naive_Scheduler) is
      Chosen : TCB_Number;
   begin
      if Has (Model, Running) or else not Has (Model, Ready) then
         return;
      end if;
      Chosen := First_Of (Model, Ready);
      if Model.Tasks (Chosen).New_Release
        and then Model.Tasks (Chosen).Header.Start_Time < Model.Now
      then
         Model.Overruns := Model.Overruns + 1;
      end if;
      Model.Tasks (Chosen).New_Release := False;
      Put (Model, Chosen, Running);
   end Dispatch;

   procedure Wake (Model : in out Naive_Scheduler; Now : Clock_Tick) is
      First : TCB_Number;
   begin
      Model.Now := Now;
      while Has (Model, Timer) loop
         First := First_Of (Model, Timer);
         exit when Model.Tasks (First).Header.Start_Time > Now;
         Put (Model, First, Ready);
      end loop;
   end Wake;

   procedure Exit_Call (Model : in out Naive_Scheduler) is
      Caller : constant TCB_Number := First_Of (Model, Running);
   begin
      if (for some Each of Model.Tasks =>
            Each.Queue = Ready
            and then Each.Header.Initial_Priority >
                     Model.Tasks (Caller).Header.Initial_Priority)
      then
         Put (Model, Caller, Ready);
         Dispatch (Model);
      end if;
   end Exit_Call;

   procedure Sleep (Model : in out Naive_Scheduler; Until_Tick : Tick) is
      Caller : constant TCB_Number := First_Of (Model, Running);
      Slept  : Naive_Task renames Model.Tasks (Caller);
   begin
      if Model.Now >= Slept.Header.Start_Time + Ticks_Per_Major_Frame then
         Model.Overruns := Model.Overruns + 1;
      end if;
      Slept.Header.Start_Time := Tick'Max (Until_Tick, Model.Now + 1);
      Slept.New_Release := True;
      Slept.First_Run := False;
      Put (Model, Caller, Timer);
   end Sleep;

   procedure Terminate_Caller (Model : in out Naive_Scheduler) is
   begin
      Put (Model, First_Of (Model, Running), Free);
   end Terminate_Caller;

   procedure Expect_Same
     (When_It_Was : String;
      S           : Scheduler;
      Model       : Naive_Scheduler) is
   begin
      Expect (When_It_Was & ": clock", Clock (S), Model.Now);
      Expect (When_It_Was & ": overruns", Overruns (S), Model.Overruns);
      Expect (When_It_Was & ": idle", Is_Idle (S), not Has (Model, Running));
      for A in TCB_Number loop
         declare
            What   : constant String := When_It_Was & ": TCB" & A'Image & ' ';
            Wanted : Naive_Task renames Model.Tasks (A);
         begin
            Expect (What & "queue", Queue_Of (S, A), Wanted.Queue);
            Expect (What & "identity", Id_Of (S, A), Wanted.Header.Id);
            Expect
              (What & "priority", Priority_Of (S, A),
               Wanted.Header.Initial_Priority);
            Expect
              (What & "release", Release_Of (S, A), Wanted.Header.Start_Time);
            Expect
              (What & "has not run since", Is_New_Release (S, A),
               Wanted.New_Release);
            Expect
              (What & "has never run", Is_First_Run (S, A),
               Wanted.First_Run);
            for B in TCB_Number loop
               if Model.Tasks (B).Queue = Wanted.Queue then
                  Expect
                    (What & "is ahead of" & B'Image, Is_Ahead (S, A, B),
                     Is_Sooner (Wanted, Model.Tasks (B)));
               end if;
            end loop;
         end;
      end loop;
   end Expect_Same;

end Naive_Schedulers;
