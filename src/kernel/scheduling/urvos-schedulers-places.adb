--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Schedulers.Places with SPARK_Mode is

   --  Whom to stand behind is mostly the last; else the search is by halves.

   function Behind_Priority
     (S     : Scheduler;
      Level : Priority) return Integer
   is
      First  : Integer := Running_Last (S) + 1;
      Beyond : Integer := Ready_Last (S) + 1;
      Middle : Integer := Ready_Last (S);
      Seen   : TCB_Number;
   begin
      while First < Beyond loop
         Seen := TCB_At (S.Row, Place (Middle));

         --  It divides the queue.
         pragma Assert
           (for all Which in TCB_Number =>
              (if Queue_Of (S, Which) = Ready
               then
                 (if Is_Ahead (S, Which, Seen)
                  then Priority_Of (S, Which) >= Priority_Of (S, Seen)
                  elsif Is_Ahead (S, Seen, Which)
                  then Priority_Of (S, Seen) >= Priority_Of (S, Which)
                  else Which = Seen)));
         if S.Blocks (Seen).Priority >= Level then
            First := Middle + 1;
         else
            Beyond := Middle;
         end if;
         pragma Loop_Variant (Decreases => Beyond - First);
         pragma Loop_Invariant
           (First in Running_Last (S) + 1 .. Beyond
            and then Beyond <= Ready_Last (S) + 1);
         pragma Loop_Invariant
           (for all Which in TCB_Number =>
              (if Queue_Of (S, Which) = Ready
                 and then Place_Number (S, Which) not in First .. Beyond - 1
               then (Place_Number (S, Which) < First)
                    = (Priority_Of (S, Which) >= Level)));
         Middle := (First + Beyond - 1) / 2;
      end loop;
      return First;
   end Behind_Priority;

   function Behind_Tick
     (S       : Scheduler;
      Release : Tick) return Integer
   is
      First  : Integer := Ready_Last (S) + 1;
      Beyond : Integer := Timer_Last (S) + 1;
      Middle : Integer := Timer_Last (S);
      Seen   : TCB_Number;
   begin
      while First < Beyond loop
         Seen := TCB_At (S.Row, Place (Middle));

         --  It divides the queue.
         pragma Assert
           (for all Which in TCB_Number =>
              (if Queue_Of (S, Which) = Timer
               then
                 (if Is_Ahead (S, Which, Seen)
                  then Release_Of (S, Which) <= Release_Of (S, Seen)
                  elsif Is_Ahead (S, Seen, Which)
                  then Release_Of (S, Seen) <= Release_Of (S, Which)
                  else Which = Seen)));
         if S.Blocks (Seen).Release <= Release then
            First := Middle + 1;
         else
            Beyond := Middle;
         end if;
         pragma Loop_Variant (Decreases => Beyond - First);
         pragma Loop_Invariant
           (First in Ready_Last (S) + 1 .. Beyond
            and then Beyond <= Timer_Last (S) + 1);
         pragma Loop_Invariant
           (for all Which in TCB_Number =>
              (if Queue_Of (S, Which) = Timer
                 and then Place_Number (S, Which) not in First .. Beyond - 1
               then (Place_Number (S, Which) < First)
                    = (Release_Of (S, Which) <= Release)));
         Middle := (First + Beyond - 1) / 2;
      end loop;
      return First;
   end Behind_Tick;

end URVOS.Schedulers.Places;
