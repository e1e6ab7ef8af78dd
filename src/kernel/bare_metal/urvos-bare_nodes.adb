--  SPDX-License-Identifier: Apache-2.0

with URVOS.Executives;
with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Start_Orders; use URVOS.Start_Orders;

package body URVOS.Bare_Nodes
  with
    SPARK_Mode,
    Refined_State =>
      (Events          => Guard,
       Task_Management =>
         (Executive.Task_Management, Clock, Request, Chosen, Was_Up,
          Refused))
is

   --  Ticks that wait to be served. Further ticks are lost.
   Most_Ticks : constant := 1_000;
   type Waiting_Ticks is mod 2 ** 16;

   protected Guard is

      procedure Tick;

      --  Carries_On: the next order is to carry on, and Look would change
      --  nothing. Its record is costly on a small processor.
      procedure Take_Ticks
        (Number     : out Waiting_Ticks;
         Carries_On : out Boolean);

      --  A request abandons a start in progress.
      procedure Request (Condition : Start_Condition);

      procedure Look (Next_Order : out Order);

      procedure Note_Tested (Passed : Boolean; Numbers : Number_List);

      function Has_Ticked return Boolean;

      function Has_Work return Boolean;

   private
      Waiting : Waiting_Ticks := 0;
      State   : Node_State;
   end Guard;

   Clock   : Frame_Clock;
   Request : Frame_Request;
   Chosen  : Schedule_Name := Report;
   Was_Up  : Boolean       := False;
   Refused : Boolean       := False;

   --  Advances the clock by one tick. It is out of line, where it needs fewer
   --  registers.
   procedure Advance_Clock
   with No_Inline;

   --  Advances the clock by this number of ticks.
   procedure Follow_Clock (Number : Waiting_Ticks);

   procedure Read_Clock
     (Now : in out Clock_Tick; Has_Moved : in out Boolean)
   with Inline;

   package Executive is
     new URVOS.Executives (Software.Step, Software.Report_Overrun, Read_Clock);

   --  Reports the tick to the tasks.
   procedure Carry_On;

   --  Carries out the orders of a start.
   procedure Follow_Orders;

   protected body Guard is

      procedure Tick is
      begin
         if Waiting < Most_Ticks then
            Waiting := Waiting + 1;
         end if;
      end Tick;

      procedure Take_Ticks
        (Number     : out Waiting_Ticks;
         Carries_On : out Boolean) is
      begin
         Number := Waiting;
         Waiting := 0;
         Carries_On := State.Doing = Running and then not State.Is_Wanted;
      end Take_Ticks;

      procedure Request (Condition : Start_Condition) is
      begin
         State := (others => <>);
         State := Requested (State, Condition);
      end Request;

      procedure Look (Next_Order : out Order) is
      begin
         if Master <= Seat (State.Processors) then
            Look (State, Master, Next_Order);
         else
            Next_Order := (others => <>);
         end if;
      end Look;

      procedure Note_Tested (Passed : Boolean; Numbers : Number_List) is
      begin
         State := Tested (State, Passed, Numbers);
      end Note_Tested;

      function Has_Ticked return Boolean is (Waiting > 0);

      function Has_Work return Boolean is
        (Waiting > 0 or else State.Is_Wanted);

   end Guard;

   procedure Advance_Clock is
   begin
      Software.Look_At_Frame (1, Request);
      Take_Tick (Clock, Request);
   end Advance_Clock;

   procedure Follow_Clock (Number : Waiting_Ticks) is
   begin
      for Each in 1 .. Number loop
         Advance_Clock;
      end loop;
      Software.Set_Time (Clock.Now);
   end Follow_Clock;

   procedure Read_Clock
     (Now : in out Clock_Tick; Has_Moved : in out Boolean)
   is
      Has_Ticked        : constant Boolean := Guard.Has_Ticked;
      Number            : Waiting_Ticks;
      Unused_Carries_On : Boolean;
   begin
      if Has_Ticked then
         Guard.Take_Ticks (Number, Unused_Carries_On);
         Follow_Clock (Number);
         Now := Clock_Tick'Max (Now, Clock.Now);
         Has_Moved := True;
      end if;
   end Read_Clock;

   procedure Carry_On is
   begin
      if not Clock.Held then
         Executive.Clock_Interrupt (Clock.Now);
      end if;
   end Carry_On;

   procedure Follow_Orders is
      Next_Order : Order;
      Passed     : Boolean;
   begin
      --  A start consists of two orders: begin, then load.
      for Number in 1 .. 2 loop
         Guard.Look (Next_Order);
         case Next_Order.Name is
            when Stand_Still =>
               exit;

            when Start_Orders.Carry_On =>
               Carry_On;
               exit;

            when Begin_Start =>
               Software.Begin_Again (Next_Order.Condition, Clock.Now, Passed);
               Refused := not Passed;
               Was_Up := True;
               Guard.Note_Tested (Passed, Numbers_For (Next_Order.Present));

            when Load_Tasks =>
               Executive.Start
                 ((if Next_Order.Passed
                   then Software.Tasks.Tree_Of
                     (1, Next_Order.Number, Clock.Now, Chosen)
                   else Empty_Tree),
                  Clock.Now);
         end case;
      end loop;
   end Follow_Orders;

   procedure Begin_Start
     (Condition : Start_Condition;
      Schedule  : Schedule_Name := Report) is
   begin
      Chosen := Schedule;
      Guard.Request (if Was_Up then Condition else Cold_Start);
   end Begin_Start;

   procedure Clock_Interrupt is
   begin
      Guard.Tick;
   end Clock_Interrupt;

   function Has_Work return Boolean is
      Result : constant Boolean := Guard.Has_Work;
   begin
      return Result;
   end Has_Work;

   procedure Serve is
      Number     : Waiting_Ticks;
      Carries_On : Boolean;
   begin
      Guard.Take_Ticks (Number, Carries_On);
      if Number = 0 and then Carries_On then
         return;
      end if;
      Follow_Clock (Number);
      if Carries_On then
         Carry_On;
      else
         Follow_Orders;
      end if;
   end Serve;

   function Is_Idle return Boolean is (Executive.Is_Idle)
   with Refined_Global => (Input => Executive.Task_Management);

   procedure Run_Step (Runs_On : out Boolean) is
   begin
      Executive.Run_Step (Runs_On);
   end Run_Step;

   function Overruns return Count is (Executive.Overruns)
   with Refined_Global => (Input => Executive.Task_Management);

   function Is_Refused return Boolean is (Refused)
   with Refined_Global => (Input => Refused);

end URVOS.Bare_Nodes;
