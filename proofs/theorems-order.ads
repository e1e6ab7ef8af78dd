--  SPDX-License-Identifier: Apache-2.0

--  The order of a frame (report, section 2.2, figure 3; FRM-2, SET-1): who
--  consumes what another task has produced runs after it, in the same
--  frame, on any schedule that keeps the releases, on one processor or two.
--  The control laws alone run at the same tick as those they consume from:
--  on the same processor, which runs them first because they stand first.

with GSC;
with MCS;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Task_Trees; use URVOS.Task_Trees;

package Theorems.Order with SPARK_Mode, Ghost is

   --  The tick at which each task runs in one major frame.
   type MCS_Schedule is array (MCS.Task_Name) of Tick;
   type GSC_Schedule is array (GSC.Task_Name) of Tick;

   --  No task has overrun: each runs in the minor frame in which it is
   --  released, in the major frame that follows Now. Which of those that
   --  share a minor frame runs first is left open.

   function Is_Legal
     (Schedule : MCS_Schedule;
      Now      : Clock_Tick) return Boolean
   is
     (for all Who in MCS.Task_Name =>
        Schedule (Who) = MCS.Tasks.Next_Release_Of (Who, Now));

   function Is_Legal
     (Schedule : GSC_Schedule;
      Now      : Clock_Tick) return Boolean
   is
     (for all Who in GSC.Task_Name =>
        Schedule (Who) = GSC.Tasks.Next_Release_Of (Who, Now));

   --  The variables between the tasks that pass within a frame: figure 2.
   --  ADINT_variable is not one of them, it passes from frame to frame.

   use type MCS.Task_Name;
   use type GSC.Task_Name;

   function Consumes
     (Consumer, Producer : MCS.Task_Name) return Boolean
   is
     (case Consumer is
         when MCS.MDCIN_Task  => Producer = MCS.TELIN_Task,
         when MCS.MDCOUT_Task => Producer = MCS.AD_Task,
         when MCS.LAW_Task    =>
           Producer in MCS.MDCIN_Task | MCS.MDCOUT_Task,
         when MCS.PWM_Task    => Producer = MCS.LAW_Task,
         when MCS.TELOUT_Task => Producer = MCS.MDCOUT_Task,
         when MCS.CORE_Task   =>
           Producer in MCS.MDCIN_Task | MCS.MDCOUT_Task,
         when others          => False);

   function Consumes
     (Consumer, Producer : GSC.Task_Name) return Boolean
   is
     (case Consumer is
         when GSC.GDCIN_Task  => Producer = GSC.TELIN_Task,
         when GSC.GDCOUT_Task => Producer = GSC.AD_Task,
         when GSC.TELOUT_Task => Producer = GSC.GDCOUT_Task,
         when GSC.CORE_Task   =>
           Producer in GSC.GDCIN_Task | GSC.GDCOUT_Task,
         when others          => False);

   --  Released at one tick, the producer is chosen first: on one processor,
   --  by its priority, which is its place in the list.
   function Is_Chosen_First
     (Producer, Consumer : MCS.Task_Name) return Boolean
   is
     (MCS.Task_List (Producer).Processor = MCS.Task_List (Consumer).Processor
      and then Producer < Consumer);

   --  Aircraft: every consumer but the laws runs at a later tick than its
   --  producer; the laws no earlier, and after it.
   procedure Aircraft_Consumers_Follow_Producers
     (Schedule : MCS_Schedule;
      Now      : Clock_Tick)
   with
     Global => null,
     Pre    => Is_Legal (Schedule, Now),
     Post   =>
       (for all Consumer in MCS.Task_Name =>
          (for all Producer in MCS.Task_Name =>
             (if Consumes (Consumer, Producer)
              then Schedule (Consumer) > Schedule (Producer)
                or else
                  (Consumer = MCS.LAW_Task
                   and then Schedule (Consumer) = Schedule (Producer)
                   and then Is_Chosen_First (Producer, Consumer)))));

   --  Ground: the same.
   procedure Ground_Consumers_Follow_Producers
     (Schedule : GSC_Schedule;
      Now      : Clock_Tick)
   with
     Global => null,
     Pre    => Is_Legal (Schedule, Now),
     Post   =>
       (for all Consumer in GSC.Task_Name =>
          (for all Producer in GSC.Task_Name =>
             (if Consumes (Consumer, Producer)
              then Schedule (Consumer) > Schedule (Producer))));

   --  All of it is over before the next frame begins.
   procedure A_Frame_Is_Done_Within_It
     (Schedule : MCS_Schedule;
      Now      : Clock_Tick)
   with
     Global => null,
     Pre    => Is_Legal (Schedule, Now),
     Post   =>
       (for all Who in MCS.Task_Name =>
          Schedule (Who) in Next_Frame (Now) ..
                              Next_Frame (Now) + Ticks_Per_Major_Frame - 1);

end Theorems.Order;
