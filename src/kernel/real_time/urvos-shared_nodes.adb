--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Shared_Nodes with SPARK_Mode is

   Tick_Time : constant Time_Span := Microseconds (Microseconds_Per_Tick);

   --  The largest number of missed ticks that one call makes up for.
   Most_Missed : constant := 100;

   protected body Node is

      procedure Switch_On
        (Processors : Processor_Number;
         At_Time    : Time;
         Schedule   : Schedule_Name := Report) is
      begin
         State := (Processors => Processors, others => <>);
         State := Requested (State, Cold_Start);
         Beginning := At_Time;
         Chosen := Schedule;
         Clock := (others => <>);
         Next := At_Time + Tick_Time;
         Shifted := At_Time;
      end Switch_On;

      procedure Request (Condition : Start_Condition) is
      begin
         State := Requested (State, Condition);
      end Request;

      procedure Look (Self : Seat; Next_Order : out Order) is
      begin
         if Self <= Seat (State.Processors) then
            Look (State, Self, Next_Order);
         else
            Next_Order := (others => <>);
         end if;
      end Look;

      procedure Note_Tested (Passed : Boolean; Numbers : Number_List) is
      begin
         State := Tested (State, Passed, Numbers);
      end Note_Tested;

      procedure Note_Tick (Self : Seat; Now : Clock_Tick; Overruns : Count) is
      begin
         Latest := Clock_Tick'Max (Latest, Now);
         Late (Self) := Overruns;
      end Note_Tick;

      function Is_Start_Wanted return Boolean is (State.Is_Wanted);

      function Processors return Processor_Number is (State.Processors);

      procedure Follow
        (Present   : Time;
         Request   : Frame_Request;
         Now       : out Clock_Tick;
         Next_Tick : out Time)
      is
         Before : Clock_Tick;
      begin
         for Missed in 1 .. Most_Missed loop
            exit when Next > Present;
            Next := Next + Tick_Time;
            Before := Clock.Now;
            Clock := Ticked (Clock, Request);
            if Clock.Now = Before then
               Shifted := Shifted + Tick_Time;
            elsif Clock.Now > Before + 1 then
               Shifted := Shifted - Tick_Time;
            end if;
         end loop;
         Now := Clock.Now;
         Next_Tick := Next;
      end Follow;

      function Switched_On_At return Time is (Beginning);

      function Counted_From return Time is (Shifted);

      function Schedule return Schedule_Name is (Chosen);

      function Now return Clock_Tick is (Latest);

      function Overruns return Count is
        (Saturating_Sum
           (Saturating_Sum (Late (1), Late (2)),
            Saturating_Sum (Late (3), Late (4))));

   end Node;

end URVOS.Shared_Nodes;
