--  SPDX-License-Identifier: Apache-2.0

--  How the processors of a node start together (report, section 3.1; INI-2,
--  KRN-5, KRN-6, EXT-4, D-23).
--
--  Somebody asks for a start. Each processor looks here at each tick: it
--  ends the step that it is in and stands still. When all do, the master has
--  the node tested and prepared, and gives each a number. Then each loads the
--  tasks of its number, and goes on.

with URVOS.Starts;     use URVOS.Starts;
with URVOS.Task_Trees; use URVOS.Task_Trees;

package URVOS.Start_Orders with Pure, SPARK_Mode is

   --  A processor by its place in the node. The master is the first. Which
   --  tasks it has follows from its number alone.
   type Seat is new Processor_Number;

   Master : constant Seat := 1;

   type Order_Name is
     (Carry_On,      --  the clock has ticked for the tasks, as ever
      Stand_Still,   --  no step is to be run
      Begin_Start,   --  phases 1 and 2, for the master alone
      Load_Tasks);   --  phase 3

   type Seat_Flags is array (Seat) of Boolean;

   type Order is record
      Name      : Order_Name       := Stand_Still;

      --  For Begin_Start; Present are the processors that stand still.
      Condition : Start_Condition  := Cold_Start;
      Present   : Seat_Flags       := (others => False);

      --  For Load_Tasks: whether there are tasks, after phase 1, and which.
      Passed    : Boolean          := False;
      Number    : Processor_Number := 1;
   end record;

   type Activity is (Running, Stopping, Testing, Loading);

   --  The processors' numbers, as the master gives them (report, section 3.1).
   type Number_List is array (Seat) of Processor_Number;

   --  One if a processor is there, before another one.
   function Ahead (Present : Seat_Flags; Which, Who : Seat) return Natural is
     (if Which < Who and then Present (Which) then 1 else 0)
   with
     Global => null,
     Post   => Ahead'Result <= 1;

   --  The master gives itself number 1, and the next ones to the processors
   --  that are there, in the order of their places.
   function Numbers_For (Present : Seat_Flags) return Number_List is
     ((for Who in Seat =>
         Processor_Number
           (1 + Ahead (Present, 1, Who) + Ahead (Present, 2, Who)
            + Ahead (Present, 3, Who))))
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

       --  And every number up to theirs is given.
       and then
         (for all Who in Seat =>
            Numbers_For'Result (Who) = 1
            or else
              (for some Other in Seat =>
                 Present (Other)
                 and then Numbers_For'Result (Other) =
                   Numbers_For'Result (Who) - 1));

   type Node_State is record
      Processors : Processor_Number := 1;
      Doing      : Activity         := Running;
      Is_Wanted  : Boolean          := False;
      Wanted     : Start_Condition  := Cold_Start;
      Passed     : Boolean          := False;
      Numbers    : Number_List      := (others => 1);

      --  Who has stopped, or loaded its tasks.
      Done       : Seat_Flags       := (others => False);
   end record
   with Predicate => (if Doing = Stopping then Is_Wanted);

   --  All seats that are taken.
   function All_Done (State : Node_State) return Boolean is
     (for all Which in Seat =>
        State.Done (Which) or else Which > Seat (State.Processors))
   with Global => null;

   --  Of several requests the last one counts.
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

   --  A processor looks what it has to do.

   --  A request is heard when all run.
   function Heard (State : Node_State) return Node_State is
     (if State.Doing = Running and then State.Is_Wanted
      then (State with delta Doing => Stopping, Done => (others => False))
      else State)
   with Global => null;

   --  With a processor that has stopped, or loaded.
   function With_Done (State : Node_State; Who : Seat) return Node_State is
     ((State with delta
         Done => (for Each in Seat => Each = Who or else State.Done (Each))))
   with Global => null;

   --  For a state in which a request has been heard.

   function Order_For (State : Node_State; Who : Seat) return Order is
     (case State.Doing is
         when Running  => (Name => Carry_On, others => <>),
         when Stopping =>
           (if Who = Master and then All_Done (With_Done (State, Who))
            then (Begin_Start, State.Wanted, With_Done (State, Who).Done,
                  others => <>)
            else (others => <>)),
         when Testing  => (others => <>),
         when Loading  =>
           (if State.Done (Who) then (Name => Carry_On, others => <>)
            else (Name   => Load_Tasks,
                  Passed => State.Passed,
                  Number => State.Numbers (Who),
                  others => <>)))
   with Global => null;

   function State_After (State : Node_State; Who : Seat) return Node_State is
     (case State.Doing is
         when Running | Testing => State,
         when Stopping          =>
           (if Who = Master and then All_Done (With_Done (State, Who))
            then (With_Done (State, Who) with delta
                    Doing => Testing, Is_Wanted => False)
            else With_Done (State, Who)),
         when Loading           =>
           (if not State.Done (Who)
              and then All_Done (With_Done (State, Who))
            then (With_Done (State, Who) with delta Doing => Running)
            else With_Done (State, Who)))
   with Global => null;

   procedure Look
     (State      : in out Node_State;
      Who        : Seat;
      Next_Order : out Order)
   with
     Global => null,
     Pre    => Who <= Seat (State.Processors),
     Post   =>
       Next_Order = Order_For (Heard (State'Old), Who)
       and then State = State_After (Heard (State'Old), Who)

       --  Nobody runs a step from the time when all stand still until the
       --  start's phases 1 and 2 are over.
       and then
         (if Next_Order.Name = Begin_Start
          then Who = Master
            and then All_Done (State)
            and then State.Doing = Testing
            and then Next_Order.Condition = State'Old.Wanted
            and then Next_Order.Present = State.Done
            and then Next_Order.Present (Master)
            and then State'Old.Is_Wanted)
       and then
         (if State'Old.Doing = Testing
          then Next_Order.Name = Stand_Still and then State = State'Old)

       --  Each loads its tasks once, those of the number that it was given.
       and then
         (if Next_Order.Name = Load_Tasks
          then State'Old.Doing = Loading
            and then not State'Old.Done (Who)
            and then State.Done (Who)
            and then Next_Order.Passed = State.Passed
            and then Next_Order.Number = State'Old.Numbers (Who))
       and then State.Numbers = State'Old.Numbers

       --  A request is granted by phases 1 and 2, and not lost before.
       and then
         State.Is_Wanted =
           (State'Old.Is_Wanted and then Next_Order.Name /= Begin_Start)
       and then State.Wanted = State'Old.Wanted

       --  Whoever is told to carry on has tasks, and no start is under way.
       and then
         (if Next_Order.Name = Carry_On
          then State.Doing in Running | Loading
            and then State = State'Old);

end URVOS.Start_Orders;
