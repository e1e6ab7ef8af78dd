--  SPDX-License-Identifier: Apache-2.0

with Checks;             use Checks;
with Expect_Value;
with Expectations;       use Expectations;
with URVOS.Start_Orders; use URVOS.Start_Orders;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

separate (Kernel_Suite)
package body Start_Orders_Tests is

   --  The tests, in order.
   procedure One_Processor;
   procedure Two_Processors;
   procedure Wishes;
   procedure Any_Order;
   procedure Numbers;

   procedure Expect is new Expect_Value (Order_Name);
   procedure Expect is new Expect_Value (Start_Condition);

   --  A processor looks and gets this order.
   procedure Expect_Order
     (State    : in out Node_State;
      Who      : Seat;
      Expected : Order_Name);

   --  The master begins a start with this condition.
   procedure Expect_Start
     (State     : in out Node_State;
      Condition : Start_Condition);

   --  A processor loads its tasks, or none.
   procedure Expect_Load
     (State  : in out Node_State;
      Who    : Seat;
      Passed : Boolean);

   --  Numbers that differ from the places: the master's number alone decides
   --  which tasks a processor has.
   Given : constant Number_List := (1, 3, 4, 2);

   procedure Expect_Order
     (State    : in out Node_State;
      Who      : Seat;
      Expected : Order_Name)
   is
      Next_Order : Order;
   begin
      Look (State, Who, Next_Order);
      Expect ("order of processor" & Who'Image, Next_Order.Name, Expected);
   end Expect_Order;

   procedure Expect_Start
     (State     : in out Node_State;
      Condition : Start_Condition)
   is
      Next_Order : Order;
   begin
      Look (State, Master, Next_Order);
      Expect ("order of the master", Next_Order.Name, Begin_Start);
      Expect ("condition", Next_Order.Condition, Condition);
   end Expect_Start;

   procedure Expect_Load
     (State  : in out Node_State;
      Who    : Seat;
      Passed : Boolean)
   is
      Next_Order : Order;
   begin
      Look (State, Who, Next_Order);
      Expect ("order of processor" & Who'Image, Next_Order.Name, Load_Tasks);
      Expect ("passed", Next_Order.Passed, Passed);
      Expect_Number
        ("number", Integer (Next_Order.Number),
         Integer (State.Numbers (Who)));
   end Expect_Load;

   procedure One_Processor is
      State : Node_State := (Processors => 1, others => <>);
   begin
      State := Requested (State, Cold_Start);
      Expect_Start (State, Cold_Start);
      State := Tested (State, True, Given);
      Expect_Load (State, Master, Passed => True);
      for Look in 1 .. 3 loop
         Expect_Order (State, Master, Carry_On);
      end loop;

      --  After a failed test there is nothing to load until the next request.
      State := Requested (State, Warm_Reset);
      Expect_Start (State, Warm_Reset);
      State := Tested (State, False, Given);
      Expect_Load (State, Master, Passed => False);
      Expect_Order (State, Master, Carry_On);
      State := Requested (State, Processor_Restart);
      Expect_Start (State, Processor_Restart);
      State := Tested (State, True, Given);
      Expect_Load (State, Master, Passed => True);
   end One_Processor;

   procedure Two_Processors is
      State : Node_State := (Processors => 2, others => <>);
   begin
      --  The master waits for the other processor.
      State := Requested (State, Cold_Start);
      Expect_Order (State, 1, Stand_Still);
      Expect_Order (State, 1, Stand_Still);
      Expect_Order (State, 2, Stand_Still);
      Expect_Start (State, Cold_Start);

      --  The other processor waits for the test, and then each loads its
      --  tasks.
      Expect_Order (State, 2, Stand_Still);
      Expect_Order (State, 2, Stand_Still);
      State := Tested (State, True, Given);
      Expect_Load (State, 2, Passed => True);
      Expect_Order (State, 2, Carry_On);
      Expect_Load (State, 1, Passed => True);
      Expect_Order (State, 1, Carry_On);
      Expect_Order (State, 2, Carry_On);

      --  The same in the other order.
      State := Requested (State, Warm_Reset);
      Expect_Order (State, 2, Stand_Still);
      Expect_Order (State, 2, Stand_Still);
      Expect_Start (State, Warm_Reset);
      State := Tested (State, False, Given);
      Expect_Load (State, 1, Passed => False);
      Expect_Order (State, 1, Carry_On);
      Expect_Load (State, 2, Passed => False);
   end Two_Processors;

   procedure Wishes is
      State : Node_State := (Processors => 2, others => <>);
   begin
      --  The last of several requests counts, up to phase 1.
      State := Requested (State, Cold_Start);
      State := Requested (State, Processor_Restart);
      Expect_Order (State, 1, Stand_Still);
      State := Requested (State, Warm_Reset);
      Expect_Order (State, 2, Stand_Still);
      Expect_Start (State, Warm_Reset);

      --  A later request is kept until this start is over.
      State := Requested (State, Processor_Restart);
      Expect_Order (State, 2, Stand_Still);
      State := Tested (State, True, Given);
      Expect_Load (State, 1, Passed => True);
      Expect_Load (State, 2, Passed => True);
      Expect_Order (State, 2, Stand_Still);
      Expect_Start (State, Processor_Restart);
      State := Tested (State, True, Given);
      Expect_Load (State, 1, Passed => True);

      --  A request while the tasks are loaded is kept as well.
      State := Requested (State, Warm_Reset);
      Expect_Order (State, 1, Carry_On);
      Expect_Load (State, 2, Passed => True);
      Expect_Order (State, 1, Stand_Still);
      Expect_Order (State, 2, Stand_Still);
      Expect_Start (State, Warm_Reset);
      State := Tested (State, True, Given);
      Expect_Load (State, 2, Passed => True);
      Expect_Load (State, 1, Passed => True);
      Expect_Order (State, 1, Carry_On);
      Expect_Order (State, 2, Carry_On);
   end Wishes;

   procedure Any_Order is

      type Last_Orders is array (Seat) of Order_Name;

      --  A node and the monitor's knowledge of it: each processor's activity,
      --  the processors that have loaded tasks since the last start, and the
      --  pending request.
      type Watched is record
         State  : Node_State;
         Does   : Last_Orders := (others => Stand_Still);
         Loaded : Seat_Flags  := (others => False);
         Passed : Boolean     := False;
         Is_Due : Boolean     := False;
         Due    : Start_Condition := Cold_Start;
      end record;

      Most  : constant := 20_000;
      Found : array (1 .. Most) of Watched;
      Last  : Natural := 0;

      procedure Note (This : Watched);

      --  The next steps from there

      procedure Wish (This : in out Watched; Condition : Start_Condition);
      procedure End_Test (This : in out Watched; Passed : Boolean);
      procedure Take_Turn (This : in out Watched; Who : Seat);

      --  In turns, a node grants the request and then runs its tasks.
      procedure Expect_Progress (From : Watched);

      procedure Note (This : Watched) is
      begin
         for Place in 1 .. Last loop
            if Found (Place) = This then
               return;
            end if;
         end loop;
         Last := Last + 1;
         Found (Last) := This;
      end Note;

      procedure Wish (This : in out Watched; Condition : Start_Condition) is
      begin
         This.State := Requested (This.State, Condition);
         This.Is_Due := True;
         This.Due := Condition;
      end Wish;

      procedure End_Test (This : in out Watched; Passed : Boolean) is
      begin
         This.State := Tested (This.State, Passed, Given);
         This.Passed := Passed;
         This.Does (Master) := Stand_Still;
      end End_Test;

      procedure Take_Turn (This : in out Watched; Who : Seat) is
         Is_Testing : constant Boolean := This.Does (Master) = Begin_Start;
         Next_Order : Order;
      begin
         Look (This.State, Who, Next_Order);
         if Is_Testing then
            Expect ("during phases 1 and 2", Next_Order.Name, Stand_Still);
         end if;

         case Next_Order.Name is
            when Stand_Still =>
               null;

            when Begin_Start =>
               Expect ("the master begins", Who = Master, True);
               Expect
                 ("all others stand still",
                  (for all Which in Seat =>
                     Which = Master
                     or else This.Does (Which) = Stand_Still),
                  True);
               Expect ("somebody has wished for it", This.Is_Due, True);
               Expect
                 ("what was wished for last", Next_Order.Condition, This.Due);
               This.Is_Due := False;
               This.Loaded := (others => False);

            when Load_Tasks =>
               Expect ("loads once", This.Loaded (Who), False);
               Expect ("has stood still", This.Does (Who), Stand_Still);
               Expect ("as the test says", Next_Order.Passed, This.Passed);
               Expect
                 ("the tasks of its number", Next_Order.Number = Given (Who),
                  True);
               This.Loaded (Who) := True;

            when Carry_On =>
               Expect ("has loaded its tasks", This.Loaded (Who), True);
         end case;
         This.Does (Who) := Next_Order.Name;
      end Take_Turn;

      procedure Expect_Progress (From : Watched) is
         This    : Watched := From;
         Granted : Boolean := not From.Is_Due;
      begin
         for Round in 1 .. 10 loop
            if This.Does (Master) = Begin_Start then
               End_Test (This, True);
            end if;
            for Who in 1 .. Seat (This.State.Processors) loop
               if This.Does (Master) /= Begin_Start or else Who /= Master then
                  Take_Turn (This, Who);
                  Granted := Granted or else This.Does (Who) = Begin_Start;
               end if;
            end loop;
         end loop;
         Expect ("a wish is granted", Granted, True);
         for Who in 1 .. Seat (This.State.Processors) loop
            Expect ("in the end", This.Does (Who), Carry_On);
         end loop;
      end Expect_Progress;

      Next : Natural;
      This : Watched;
   begin
      for Processors in Processor_Number loop
         Last := 0;
         This := (State => (Processors => Processors, others => <>),
                  others => <>);
         Wish (This, Cold_Start);
         Note (This);
         Next := 0;
         while Next < Last loop
            Next := Next + 1;
            Expect_Progress (Found (Next));
            for Condition in Start_Condition loop
               This := Found (Next);
               Wish (This, Condition);
               Note (This);
            end loop;
            for Who in 1 .. Seat (Processors) loop
               if Who = Master and then Found (Next).Does (Who) = Begin_Start
               then
                  for Passed in Boolean loop
                     This := Found (Next);
                     End_Test (This, Passed);
                     Note (This);
                  end loop;
               else
                  This := Found (Next);
                  Take_Turn (This, Who);
                  Note (This);
               end if;
            end loop;
         end loop;
         Expect ("many ways", Last > 20, True);
      end loop;
   end Any_Order;

   procedure Numbers is
      State      : Node_State := (Processors => 3, others => <>);
      Next_Order : Order;
      Present    : Seat_Flags;
      Number     : Processor_Number;
      List       : Number_List;
   begin
      --  The master's order names the processors that have stopped.
      State := Requested (State, Cold_Start);
      Expect_Order (State, 3, Stand_Still);
      Expect_Order (State, 2, Stand_Still);
      Look (State, Master, Next_Order);
      for Who in Seat loop
         Expect
           ("stands still:" & Who'Image, Next_Order.Present (Who), Who <= 3);
      end loop;

      --  Each processor present gets the next number, in the order of their
      --  places, whatever places are empty.
      for Others_There in 0 .. 7 loop
         Present :=
           (True, Others_There mod 2 = 1, Others_There / 2 mod 2 = 1,
            Others_There / 4 = 1);
         List := Numbers_For (Present);
         Number := 1;
         for Who in Seat loop
            if Present (Who) then
               Expect_Number
                 ("number of the processor at place" & Who'Image,
                  Integer (List (Who)), Integer (Number));
               if Number < Processor_Number'Last then
                  Number := Number + 1;
               end if;
            end if;
         end loop;
      end loop;
   end Numbers;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "INI-2 KRN-5 one processor tests, loads its tasks, carries on",
         One_Processor'Access);
      Add
        (Suite, "EXT-4 KRN-5 INI-2 two processors stop for the test",
         Two_Processors'Access);
      Add
        (Suite, "INI-1 EXT-4 a wish during a start is not lost",
         Wishes'Access);
      Add
        (Suite, "EXT-4 KRN-5 INI-2 whoever looks when, nobody runs a step "
         & "during a start", Any_Order'Access);
      Add
        (Suite, "KRN-5 EXT-4 D-23 the master gives each processor its number",
         Numbers'Access);
   end Add_To;

end Start_Orders_Tests;
