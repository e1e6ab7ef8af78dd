--  Whose turn it is to run among the Ada tasks of the ground's node in
--  real time. Under the Ravenscar profile each waits at an object of its
--  own.

with URVOS.Shared_Schedulers;

package GSC.Turns
  with
    SPARK_Mode,
    Abstract_State => (Waiting with Synchronous, External),
    Initializes    => (Waiting, Scheduler.Task_Management)
is

   --  Who is to have the next turn.
   package Scheduler is new URVOS.Shared_Schedulers;

   --  The task of that number goes on.
   procedure Resume (Id : Task_Id)
   with Global => (In_Out => Waiting);

   --  The task was released late or ran into its next release (FRM-4).
   procedure Report_Overrun (Id : Task_Id);

   --  Each waits for its own turn.

   procedure Await_AD
   with Global => (In_Out => Waiting);

   procedure Await_TELIN
   with Global => (In_Out => Waiting);

   procedure Await_GDCIN
   with Global => (In_Out => Waiting);

   procedure Await_GDCOUT
   with Global => (In_Out => Waiting);

   procedure Await_TELOUT
   with Global => (In_Out => Waiting);

   procedure Await_CORE
   with Global => (In_Out => Waiting);

   procedure Await_LOG
   with Global => (In_Out => Waiting);

   procedure Await_SELF_TEST
   with Global => (In_Out => Waiting);

end GSC.Turns;
