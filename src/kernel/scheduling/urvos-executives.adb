with URVOS.Arrangements; use URVOS.Arrangements;
with URVOS.Schedulers;   use URVOS.Schedulers;

package body URVOS.Executives
  with
    SPARK_Mode,
    Refined_State => (Task_Management => (Tasks, Late))
is

   subtype Sound_Scheduler is Scheduler
   with Predicate => Is_Sound (Sound_Scheduler);

   Tasks : Sound_Scheduler := Empty_Scheduler (0);

   Late  : Count := 0;

   --  Between two ticks each task sleeps once at the most, and gives way to
   --  each higher one once at the most before one of them sleeps.
   Steps_Per_Tick : constant := Number_Of_TCBs * (Number_Of_TCBs + 1);

   --  Gives an idle processor to the next task.
   procedure Choose;

   procedure Run_Tasks;

   procedure Choose is
      Before : constant Count := Overruns (Tasks);
   begin
      Dispatch (Tasks);
      if not Is_Idle (Tasks) and then Overruns (Tasks) /= Before then
         Late := Incremented (Late);
         Report_Overrun (Id_Of (Tasks, Running_TCB (Tasks)));
      end if;
   end Choose;

   procedure Run_Tasks is
      Caller : TCB_Number;
      Id     : Task_Id;
      Call   : Kernel_Call;
   begin
      for Number in 1 .. Steps_Per_Tick loop
         exit when Is_Idle (Tasks);
         Caller := Running_TCB (Tasks);
         Id := Id_Of (Tasks, Caller);
         Step (Id, Is_First_Run (Tasks, Caller), Clock (Tasks), Call);

         case Call.Name is
            when Kernel_Calls.Exit_Call =>
               Schedulers.Exit_Call (Tasks);
               exit when Running_TCB (Tasks) = Caller;

            when Sleep_Call =>
               if Has_Overrun (Tasks) then
                  Late := Incremented (Late);
                  Report_Overrun (Id);
               end if;
               Sleep (Tasks, Call.Until_Tick);
               Choose;

            when Terminate_Call =>
               Terminate_Caller (Tasks);
               Choose;
         end case;
      end loop;
   end Run_Tasks;

   procedure Start (Tree : Task_Tree; Now : Clock_Tick) is
   begin
      Start (Tasks, Tree, Now);
      Run_Tasks;
   end Start;

   procedure Clock_Interrupt (Now : Clock_Tick) is
   begin
      if Now >= Clock (Tasks) then
         Wake (Tasks, Now);
      end if;
      Choose;
      Run_Tasks;
   end Clock_Interrupt;

   function Overruns return Count is (Late)
   with Refined_Global => Late;

end URVOS.Executives;
