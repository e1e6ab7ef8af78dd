--  SPDX-License-Identifier: Apache-2.0

--  What the processors of a node share: how they start together, and what
--  each says of its clock and its tasks (KRN-5, FRM-4, EXT-4).

with Ada.Real_Time;      use Ada.Real_Time;
with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Start_Orders; use URVOS.Start_Orders;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

package URVOS.Shared_Nodes with SPARK_Mode is

   type Overrun_Counts is array (Seat) of Count;

   protected type Node is

      --  Power up: of so many processors, at this time of tick 0, with that
      --  schedule.
      procedure Switch_On
        (Processors : Processor_Number;
         At_Time    : Time;
         Schedule   : Schedule_Name := Report);

      --  A reset or an exception: the node starts again when the tasks that
      --  now run have ended their steps, at the next tick after that.
      procedure Request (Condition : Start_Condition);

      procedure Look (Who : Seat; Next_Order : out Order);

      --  Phases 1 and 2 are over; the master has given these numbers.
      procedure Note_Tested (Passed : Boolean; Numbers : Number_List);

      --  The clock has ticked for the processor, and so many of its tasks
      --  have overrun since power up.
      procedure Note_Tick (Who : Seat; Now : Clock_Tick; Overruns : Count);

      function Is_Start_Wanted return Boolean;

      function Processors return Processor_Number;

      --  The clock of all processors ticks as often as it has to, up to
      --  now; so many missed ticks are made up for at once. Then it shows
      --  this tick, and ticks next at that time.
      procedure Follow
        (Present   : Time;
         Request   : Frame_Request;
         Now       : out Clock_Tick;
         Next_Tick : out Time);

      function Switched_On_At return Time;

      --  When the clock showed tick 0, had all frames lasted as long as ever
      --  and been as the present one is.
      function Counted_From return Time;

      function Schedule return Schedule_Name;

      --  The latest tick of any processor.
      function Now return Clock_Tick;

      function Overruns return Count;

   private
      State     : Node_State;
      Beginning : Time           := Time_First;
      Chosen    : Schedule_Name  := Report;
      Clock     : Frame_Clock;
      Next      : Time           := Time_First;
      Shifted   : Time           := Time_First;
      Latest    : Clock_Tick     := 0;
      Late      : Overrun_Counts := (others => 0);
   end Node;

end URVOS.Shared_Nodes;
