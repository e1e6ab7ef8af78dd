--  SPDX-License-Identifier: Apache-2.0

--  How the processors of a node start together (report, section 3.1; INI-2,
--  KRN-5, KRN-6, EXT-4, D-23).
--
--  A caller requests a start. Each processor looks here at each tick, ends its
--  current step and stops. When all have stopped, the master has the node
--  tested and prepared, and gives each processor a number. Each then loads the
--  tasks of its number and continues.

with URVOS.Starts;     use URVOS.Starts;
with URVOS.Task_Trees; use URVOS.Task_Trees;

package URVOS.Start_Orders with Pure, SPARK_Mode is

   --  A processor by its place in the node. The master has the first place. A
   --  processor's number alone decides which tasks it has.
   type Seat is new Processor_Number;

   Master : constant Seat := 1;

   type Order_Name is
     (Carry_On,      --  the clock has ticked for the tasks
      Stand_Still,   --  run no step
      Begin_Start,   --  phases 1 and 2, for the master alone
      Load_Tasks);   --  phase 3

   type Seat_Flags is array (Seat) of Boolean
   with Alignment => 2;

   type Order is record
      Name      : Order_Name       := Stand_Still;

      --  For Begin_Start. Present marks the processors that have stopped.
      Condition : Start_Condition  := Cold_Start;
      Present   : Seat_Flags       := (others => False);

      --  For Load_Tasks: the self-test's result, and the number of the task
      --  set.
      Passed    : Boolean          := False;
      Number    : Processor_Number := 1;
   end record
   with Alignment => 2;

   type Activity is (Running, Stopping, Testing, Loading);

   --  The processors' numbers, as the master gives them (report, section 3.1).
   type Number_List is array (Seat) of Processor_Number
   with Alignment => 2;

   --  1 if the processor Which is present and precedes Self, else 0.
   function Ahead (Present : Seat_Flags; Which, Self : Seat) return Natural is
     (if Which < Self and then Present (Which) then 1 else 0)
   with
     Global => null,
     Post   => Ahead'Result <= 1;

   --  The master gives itself number 1, and the next numbers to the processors
   --  that are present, in the order of their places.
   function Numbers_For (Present : Seat_Flags) return Number_List is
     ((for Self in Seat =>
         Processor_Number
           (1 + Ahead (Present, 1, Self) + Ahead (Present, 2, Self)
            + Ahead (Present, 3, Self))))
   with
     Global => null,
     Post   =>
       Numbers_For'Result (Master) = 1

       --  No two processors have the same number.
       and then
         (for all One in Seat =>
            (for all Other in Seat =>
               (if One /= Other
                  and then Present (One)
                  and then Present (Other)
                then Numbers_For'Result (One) /= Numbers_For'Result (Other))))

       --  Every number up to the highest is given.
       and then
         (for all Self in Seat =>
            Numbers_For'Result (Self) = 1
            or else
              (for some Other in Seat =>
                 Present (Other)
                 and then Numbers_For'Result (Other) =
                   Numbers_For'Result (Self) - 1));

   type Node_State is record
      Processors : Processor_Number := 1;
      Doing      : Activity         := Running;
      Is_Wanted  : Boolean          := False;
      Wanted     : Start_Condition  := Cold_Start;
      Passed     : Boolean          := False;
      Numbers    : Number_List      := (others => 1);

      --  The processors that have stopped, or have loaded their tasks.
      Done       : Seat_Flags       := (others => False);
   end record
   with
     Alignment => 2,
     Predicate => (if Doing = Stopping then Is_Wanted);

   --  All seats of the node's processors are done.
   function All_Done (State : Node_State) return Boolean is
     (for all Which in Seat =>
        State.Done (Which) or else Which > Seat (State.Processors))
   with Global => null;

   --  The last of several requests counts.
   function Requested
     (State     : Node_State;
      Condition : Start_Condition) return Node_State
   is ((State with delta Is_Wanted => True, Wanted => Condition))
   with Global => null;

   --  Phases 1 and 2 are over, and the master has given these numbers. The
   --  tasks are loaded unless the self-test has failed.
   function Tested
     (State   : Node_State;
      Passed  : Boolean;
      Numbers : Number_List) return Node_State
   is
     ((State with delta
         Doing   => Loading,
         Passed  => Passed,
         Numbers => Numbers,
         Done    => (others => False)))
   with Global => null;

   --  The steps of Look

   --  The node takes up a request when all processors run.
   function Heard (State : Node_State) return Node_State is
     (if State.Doing = Running and then State.Is_Wanted
      then (State with delta Doing => Stopping, Done => (others => False))
      else State)
   with Global => null;

   --  The state after this processor has stopped, or has loaded its tasks.
   function With_Done (State : Node_State; Self : Seat) return Node_State is
     ((State with delta
         Done => (for Each in Seat => Each = Self or else State.Done (Each))))
   with Global => null;

   --  For a state in which a request has been taken up.

   function Order_For (State : Node_State; Self : Seat) return Order is
     (case State.Doing is
         when Running  => (Name => Carry_On, others => <>),
         when Stopping =>
           (if Self = Master and then All_Done (With_Done (State, Self))
            then (Begin_Start, State.Wanted, With_Done (State, Self).Done,
                  others => <>)
            else (others => <>)),
         when Testing  => (others => <>),
         when Loading  =>
           (if State.Done (Self) then (Name => Carry_On, others => <>)
            else (Name   => Load_Tasks,
                  Passed => State.Passed,
                  Number => State.Numbers (Self),
                  others => <>)))
   with Global => null;

   function State_After (State : Node_State; Self : Seat) return Node_State is
     (case State.Doing is
         when Running | Testing => State,
         when Stopping          =>
           (if Self = Master and then All_Done (With_Done (State, Self))
            then (With_Done (State, Self) with delta
                    Doing => Testing, Is_Wanted => False)
            else With_Done (State, Self)),
         when Loading           =>
           (if not State.Done (Self)
              and then All_Done (With_Done (State, Self))
            then (With_Done (State, Self) with delta Doing => Running)
            else With_Done (State, Self)))
   with Global => null;

   procedure Look
     (State      : in out Node_State;
      Self       : Seat;
      Next_Order : out Order)
   with
     Global => null,
     Pre    => Self <= Seat (State.Processors),
     Post   =>
       Next_Order = Order_For (Heard (State'Old), Self)
       and then State = State_After (Heard (State'Old), Self)

       --  No processor runs a step from the moment all have stopped until
       --  phases 1 and 2 of the start are over.
       and then
         (if Next_Order.Name = Begin_Start
          then Self = Master
            and then All_Done (State)
            and then State.Doing = Testing
            and then Next_Order.Condition = State'Old.Wanted
            and then Next_Order.Present = State.Done
            and then Next_Order.Present (Master)
            and then State'Old.Is_Wanted)
       and then
         (if State'Old.Doing = Testing
          then Next_Order.Name = Stand_Still and then State = State'Old)

       --  Each processor loads its tasks once, those of its given number.
       and then
         (if Next_Order.Name = Load_Tasks
          then State'Old.Doing = Loading
            and then not State'Old.Done (Self)
            and then State.Done (Self)
            and then Next_Order.Passed = State.Passed
            and then Next_Order.Number = State'Old.Numbers (Self))
       and then State.Numbers = State'Old.Numbers

       --  A request lasts until phases 1 and 2 grant it.
       and then
         State.Is_Wanted =
           (State'Old.Is_Wanted and then Next_Order.Name /= Begin_Start)
       and then State.Wanted = State'Old.Wanted

       --  A processor with the order to carry on has loaded its tasks; its own
       --  part of a start is over.
       and then
         (if Next_Order.Name = Carry_On
          then State.Doing in Running | Loading
            and then State = State'Old);

end URVOS.Start_Orders;
