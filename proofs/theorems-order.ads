--  SPDX-License-Identifier: Apache-2.0

--  In each frame every consumer runs after its producer, so data crosses a
--  node within one frame (report, section 2.2, figure 3; FRM-2, FRM-5, SET-1).
--  This holds for both nodes on one to four processors, in both schedules, for
--  every run in which no task overruns. Overruns are detected and reported
--  separately. A consumer at the same tick as its producer is on the same
--  processor, which runs the producer first because it is earlier in the list.
--  In the report's schedule only LAW is such a consumer. In the fast schedule
--  each task after AD runs when AD's scan has come, within the minor frame. AD
--  waits for the scan with EXIT, which lets no task of lower priority run.

with GSC;
with MCS;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Task_Trees; use URVOS.Task_Trees;

package Theorems.Order with SPARK_Mode, Ghost is

   --  The tick at which each task runs in one major frame and sends its
   --  output.
   type MCS_Run is array (MCS.Task_Name) of Tick;
   type GSC_Run is array (GSC.Task_Name) of Tick;

   use type MCS.Task_Name;
   use type GSC.Task_Name;

   --  No task has overrun: each runs in its minor frame of the major frame
   --  after Now. Tasks that share a minor frame run in any order

   function Is_Legal
     (Run : MCS_Run;
      Now : Clock_Tick;
      Set : Schedule_Name) return Boolean
   is
     (for all Who in MCS.Task_Name =>
        Run (Who) = MCS.Tasks.Next_Release_Of (Who, Now, Set));

   function Is_Legal
     (Run : GSC_Run;
      Now : Clock_Tick;
      Set : Schedule_Name) return Boolean
   is
     (for all Who in GSC.Task_Name =>
        Run (Who) = GSC.Tasks.Next_Release_Of (Who, Now, Set));

   --  The variables that pass between tasks within a frame: figure 2.
   --  ADINT_variable is not among them, since in the report's schedule it
   --  passes from frame to frame

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

   --  If two tasks are released at one tick on one processor, the producer is
   --  chosen first by its priority, which is its place in the list

   function Is_Chosen_First
     (Producer, Consumer : MCS.Task_Name;
      Set                : Schedule_Name) return Boolean
   is
     (MCS.Task_List (Producer) (Set).Processor =
        MCS.Task_List (Consumer) (Set).Processor
      and then Producer < Consumer);

   function Is_Chosen_First
     (Producer, Consumer : GSC.Task_Name;
      Set                : Schedule_Name) return Boolean
   is
     (GSC.Task_List (Producer) (Set).Processor =
        GSC.Task_List (Consumer) (Set).Processor
      and then Producer < Consumer);

   --  Aircraft: every consumer runs at a later tick than its producer. In the
   --  fast schedule, and for the laws, it may run at the same tick, after it.
   procedure Aircraft_Consumers_Follow_Producers
     (Run : MCS_Run;
      Now : Clock_Tick;
      Set : Schedule_Name)
   with
     Global => null,
     Pre    => Is_Legal (Run, Now, Set),
     Post   =>
       (for all Consumer in MCS.Task_Name =>
          (for all Producer in MCS.Task_Name =>
             (if Consumes (Consumer, Producer)
              then Run (Consumer) > Run (Producer)
                or else
                  ((Set = Fast or else Consumer = MCS.LAW_Task)
                   and then Run (Consumer) = Run (Producer)
                   and then Is_Chosen_First (Producer, Consumer, Set)))));

   --  Ground: the same.
   procedure Ground_Consumers_Follow_Producers
     (Run : GSC_Run;
      Now : Clock_Tick;
      Set : Schedule_Name)
   with
     Global => null,
     Pre    => Is_Legal (Run, Now, Set),
     Post   =>
       (for all Consumer in GSC.Task_Name =>
          (for all Producer in GSC.Task_Name =>
             (if Consumes (Consumer, Producer)
              then Run (Consumer) > Run (Producer)
                or else
                  (Set = Fast
                   and then Run (Consumer) = Run (Producer)
                   and then Is_Chosen_First (Producer, Consumer, Set)))));

   --  The fast schedule: the aircraft's sensors reach the telemetry board in
   --  the minor frame of their scan, so an uplink that comes one to two ticks
   --  before TELIN finds them there. Commands reach the servos at the tick at
   --  which TELIN takes them.
   procedure Aircraft_Is_Fast (Run : MCS_Run; Now : Clock_Tick)
   with
     Global => null,
     Pre    => Is_Legal (Run, Now, Fast),
     Post   =>
       Run (MCS.TELOUT_Task) = Run (MCS.AD_Task)
       and then Run (MCS.TELIN_Task) = Run (MCS.TELOUT_Task) + 3
       and then Run (MCS.PWM_Task) = Run (MCS.TELIN_Task)
       and then Run (MCS.CORE_Task) = Run (MCS.TELIN_Task);

   --  The console's words reach the telemetry board in the minor frame of
   --  their scan. Data from the board reaches CORE at the tick at which TELIN
   --  takes it, five ticks after that minor frame began.
   procedure Ground_Is_Fast (Run : GSC_Run; Now : Clock_Tick)
   with
     Global => null,
     Pre    => Is_Legal (Run, Now, Fast),
     Post   =>
       Run (GSC.TELOUT_Task) = Run (GSC.AD_Task)
       and then Run (GSC.CORE_Task) = Run (GSC.TELIN_Task)
       and then Run (GSC.TELIN_Task) = Run (GSC.TELOUT_Task) + 5;

   --  All tasks have run before the last minor frame begins

   procedure A_Frame_Is_Done_Within_It
     (Run : MCS_Run;
      Now : Clock_Tick;
      Set : Schedule_Name)
   with
     Global => null,
     Pre    => Is_Legal (Run, Now, Set),
     Post   =>
       (for all Who in MCS.Task_Name =>
          Run (Who) in Next_Frame (Now) ..
                         Next_Frame (Now) + Ticks_Per_Major_Frame - 2);

   procedure A_Ground_Frame_Is_Done_Within_It
     (Run : GSC_Run;
      Now : Clock_Tick;
      Set : Schedule_Name)
   with
     Global => null,
     Pre    => Is_Legal (Run, Now, Set),
     Post   =>
       (for all Who in GSC.Task_Name =>
          Run (Who) in Next_Frame (Now) ..
                         Next_Frame (Now) + Ticks_Per_Major_Frame - 2);

end Theorems.Order;
