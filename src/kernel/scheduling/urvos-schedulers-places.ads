--  SPDX-License-Identifier: Apache-2.0

--  Where a task belongs in a queue (KRN-1, KRN-3).

private package URVOS.Schedulers.Places with Pure, SPARK_Mode is

   --  The place in the ready queue behind all of a priority.
   function Behind_Priority
     (S     : Scheduler;
      Level : Priority) return Integer
   with
     Global => null,
     Pre    => Queues_Fit (S) and then Ready_In_Order (S),
     Post   =>
       Behind_Priority'Result in Running_Last (S) + 1 .. Ready_Last (S) + 1
       and then
         (for all Which in TCB_Number =>
            (if Queue_Of (S, Which) = Ready
             then (Place_Number (S, Which) < Behind_Priority'Result)
                  = (Priority_Of (S, Which) >= Level)));

   --  The place in the timer queue behind all of a tick.
   function Behind_Tick
     (S       : Scheduler;
      Release : Tick) return Integer
   with
     Global => null,
     Pre    => Queues_Fit (S) and then Timer_In_Order (S),
     Post   =>
       Behind_Tick'Result in Ready_Last (S) + 1 .. Timer_Last (S) + 1
       and then
         (for all Which in TCB_Number =>
            (if Queue_Of (S, Which) = Timer
             then (Place_Number (S, Which) < Behind_Tick'Result)
                  = (Release_Of (S, Which) <= Release)));

end URVOS.Schedulers.Places;
