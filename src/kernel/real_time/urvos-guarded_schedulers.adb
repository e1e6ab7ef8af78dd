package body URVOS.Guarded_Schedulers with SPARK_Mode is

   --  Two counts together; the last value stands for more.
   function Sum (Left, Right : Count) return Count is
     (if Left > Count'Last - Right then Count'Last else Left + Right)
   with Global => null;

   --  Gives an idle processor to the next task, which is to be resumed; late
   --  is one that the scheduler has counted as such.
   procedure Choose (Tasks : in out Scheduler; Todo : in out Orders)
   with
     Global => null,
     Pre    => Is_Sound (Tasks),
     Post   =>
       Is_Sound (Tasks)
       and then Todo =
         (if Is_Idle (Tasks) then Todo'Old
          else (Todo'Old with delta
                  Next      => Id_Of (Tasks, Running_TCB (Tasks)),
                  Late_Next => Overruns (Tasks) /= Overruns (Tasks'Old)));

   procedure Choose (Tasks : in out Scheduler; Todo : in out Orders) is
      Before : constant Count := Overruns (Tasks);
   begin
      Dispatch (Tasks);
      if not Is_Idle (Tasks) then
         Todo.Next := Id_Of (Tasks, Running_TCB (Tasks));
         Todo.Late_Next := Overruns (Tasks) /= Before;
      end if;
   end Choose;

   protected body Guarded_Scheduler is

      procedure Start
        (Tree : Task_Tree;
         Now  : Clock_Tick;
         Todo : out Orders) is
      begin
         Former := Sum (Former, Overruns (Tasks));
         Start (Tasks, Tree, Now);
         Todo := (others => <>);
         if not Is_Idle (Tasks) then
            Todo.Next := Id_Of (Tasks, Running_TCB (Tasks));
         end if;
      end Start;

      procedure Wake
        (Now     : Clock_Tick;
         Todo    : out Orders;
         Granted : out Wish) is
      begin
         if Now >= Clock (Tasks) then
            Wake (Tasks, Now);
         end if;

         Todo := (others => <>);
         Granted := (Is_There => False, Condition => Cold_Start);
         if Is_Idle (Tasks) then
            if Wanted.Is_There then
               Granted := Wanted;
               Wanted.Is_There := False;
            else
               Choose (Tasks, Todo);
            end if;
         end if;
      end Wake;

      procedure Request (Condition : Start_Condition) is
      begin
         Wanted := (Is_There => True, Condition => Condition);
      end Request;

      procedure Begin_Step (First_Run : out Boolean) is
      begin
         First_Run :=
           not Is_Idle (Tasks)
           and then Is_First_Run (Tasks, Running_TCB (Tasks));
      end Begin_Step;

      procedure End_Step
        (Offset : Minor_Frame;
         Failed : Boolean;
         Todo   : out Orders) is
      begin
         if Failed then
            Wanted := (Is_There => True, Condition => Processor_Restart);
         end if;

         Todo := (others => <>);
         if not Is_Idle (Tasks) then
            if Has_Overrun (Tasks) then
               Todo.Late := Id_Of (Tasks, Running_TCB (Tasks));
            end if;
            Sleep (Tasks, Next_Release (Clock (Tasks), Offset));
            if not Wanted.Is_There then
               Choose (Tasks, Todo);
            end if;
         end if;
      end End_Step;

      function Overruns return Count is
        (Sum (Former, Overruns (Tasks)));

      function Now return Clock_Tick is (Clock (Tasks));

   end Guarded_Scheduler;

end URVOS.Guarded_Schedulers;
