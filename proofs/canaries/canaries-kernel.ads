--  SPDX-License-Identifier: Apache-2.0

--  False claims about the kernel and about tasks.

with System;
with Theorems.Scheduling;
with URV.Buffers;
with URV.Mailboxes;
with URVOS; use URVOS;
with URVOS.Frames;
with URVOS.Schedulers;
with URVOS.Task_Trees;

package Canaries.Kernel with SPARK_Mode is

   --  A task whose priority is above the ceiling of the object that it calls,
   --  and a task that ends.

   package Ceilings is

      protected Box
        with Priority => System.Default_Priority
      is
         procedure Put (Item : Word);
      private
         Contents : Word := 0;
      end Box;

      task Writer  --  VC_CEILING_PRIORITY_PROTOCOL
      with
        Priority => System.Default_Priority + 1,
        Global   => (In_Out => Box);

      task Once  --  VC_TASK_TERMINATION
      with Global => null;

   end Ceilings;

   --  Two tasks write one unprotected variable.

   package Races is

      Frames : Count := 0;

      task Up  --  CONCURRENT_ACCESS
      with Global => (In_Out => Frames);

      task Down
      with Global => (In_Out => Frames);

   end Races;

   --  Claims about the real mailbox. If a contract of the flight software
   --  promised too much, one of these would be proved.

   package Mailboxes is

      use URV.Buffers;

      use URV.Mailboxes.For_Stick_Words.Boxes;

      --  MBX-2. False: of two messages sent, one is counted.
      procedure Send_Twice (Box : in out Mailbox; Item : Channel_Words)
      with
        Global => null,
        Post   =>
          Contents (Box) = Item
          and then Produced (Box) =  --  VC_POSTCONDITION
            Produced (Box'Old) + 1;

      --  MBX-3. False for a full count: a second look finds nothing new and
      --  counts a miss.
      procedure Receive_Twice (Box : in out Mailbox; Item : out Channel_Words)
      with
        Global => null,
        Post   =>
          Item = Contents (Box'Old)
          and then Misses (Box) > Misses (Box'Old);  --  VC_POSTCONDITION

   end Mailboxes;

   --  Claims about the scheduler that exceed the truth by one step.

   package Scheduling with Ghost is

      use Theorems.Scheduling;
      use URVOS.Frames;
      use URVOS.Schedulers;
      use URVOS.Task_Trees;

      --  False: a clock that moves on may wake a task.
      procedure No_Task_Is_Woken (S : Scheduler; Now : Clock_Tick)
      with
        Global => null,
        Pre    => Now >= Clock (S),
        Post   =>
          (for all Which in TCB_Number =>
             (if Queue_Of (S, Which) = Timer
              then Queue_Of  --  VC_POSTCONDITION
                (After_Wake (S, Now), Which) = Timer));

      --  False: EXIT may give the processor to another task.
      procedure The_Caller_Runs_On (S : Scheduler)
      with
        Global => null,
        Pre    => not Is_Idle (S),
        Post   =>
          Running_TCB (After_Exit (S)) = Running_TCB (S);  --  VC_POSTCONDITION

      --  False: TERMINATE removes the caller.
      procedure The_Caller_Is_Kept (S : Scheduler)
      with
        Global => null,
        Pre    => not Is_Idle (S),
        Post   => Are_Kept (S, After_Terminate (S));  --  VC_POSTCONDITION

      --  False: a task that starts to run may be late.
      procedure No_Task_Is_Late (S : Scheduler)
      with
        Global => null,
        Post   =>
          Overruns (After_Dispatch (S)) = Overruns (S);  --  VC_POSTCONDITION

   end Scheduling;

end Canaries.Kernel;
