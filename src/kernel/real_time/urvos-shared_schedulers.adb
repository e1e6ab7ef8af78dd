package body URVOS.Shared_Schedulers
  with
    SPARK_Mode,
    Refined_State => (Task_Management => Guarded)
is

   Guarded : Guarded_Scheduler;

   procedure Start
     (Tree : Task_Tree;
      Now  : Clock_Tick;
      Todo : out Orders) is
   begin
      Guarded.Start (Tree, Now, Todo);
   end Start;

   procedure Wake
     (Now     : Clock_Tick;
      Todo    : out Orders;
      Granted : out Wish) is
   begin
      Guarded.Wake (Now, Todo, Granted);
   end Wake;

   procedure Request_Start (Condition : Start_Condition) is
   begin
      Guarded.Request (Condition);
   end Request_Start;

   procedure Begin_Step (First_Run : out Boolean) is
   begin
      Guarded.Begin_Step (First_Run);
   end Begin_Step;

   procedure End_Step
     (Offset : Minor_Frame;
      Failed : Boolean;
      Todo   : out Orders) is
   begin
      Guarded.End_Step (Offset, Failed, Todo);
   end End_Step;

   procedure Inspect_Overruns (Number : out Count) is
   begin
      Number := Guarded.Overruns;
   end Inspect_Overruns;

   procedure Inspect_Clock (Now : out Clock_Tick) is
   begin
      Now := Guarded.Now;
   end Inspect_Clock;

end URVOS.Shared_Schedulers;
