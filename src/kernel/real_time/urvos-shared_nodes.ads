--  SPDX-License-Identifier: Apache-2.0

--  The data that the processors of a node share: the state of a common start,
--  the clock, and each processor's overruns (KRN-5, FRM-4, EXT-4).

with Ada.Real_Time;      use Ada.Real_Time;
with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Start_Orders; use URVOS.Start_Orders;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

package URVOS.Shared_Nodes with SPARK_Mode is

   type Overrun_Counts is array (Seat) of Count;

   protected type Node is

      --  Power up with this number of processors, time of tick 0 and schedule.
      procedure Switch_On
        (Processors : Processor_Number;
         At_Time    : Time;
         Schedule   : Schedule_Name := Report);

      --  A reset or an exception. The node starts again at the first tick
      --  after all running tasks have ended their steps.
      procedure Request (Condition : Start_Condition);

      procedure Look (Self : Seat; Next_Order : out Order);

      --  Phases 1 and 2 are over; the master has given these numbers.
      procedure Note_Tested (Passed : Boolean; Numbers : Number_List);

      --  The processor's clock has ticked. Overruns is the number of overruns
      --  of its tasks since power up.
      procedure Note_Tick (Self : Seat; Now : Clock_Tick; Overruns : Count);

      function Is_Start_Wanted return Boolean;

      function Processors return Processor_Number;

      --  Advances the common clock to the time Present, by at most 100 missed
      --  ticks a call. Now is the tick that the clock then shows; Next_Tick is
      --  the time of the next tick.
      procedure Follow
        (Present   : Time;
         Request   : Frame_Request;
         Now       : out Clock_Tick;
         Next_Tick : out Time);

      function Switched_On_At return Time;

      --  The time at which the clock would have shown tick 0 if all frames had
      --  the usual length and the present frame's phase.
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
