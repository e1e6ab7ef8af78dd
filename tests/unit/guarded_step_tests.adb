with Ada.Real_Time;

with Checks;       use Checks;
with Expectations; use Expectations;
with Partitions.Clocks;
with Partitions.Guarded_Step;
with Partitions.Measurements;

package body Guarded_Step_Tests is

   use type Partitions.Measurements.Total;

   --  The tests, in order.
   procedure Whole_Steps;
   procedure Exceptions;

   --  A task that counts what it does, and fails when it is told to.
   procedure Initialise;
   procedure Run_Transaction;
   procedure Observe;

   Is_Broken : Boolean := False;

   Begun, Run, Observed : Natural := 0;

   Cost, Response : Partitions.Measurements.Distribution;

   procedure Step is new Partitions.Guarded_Step
     (Cost, Response, Initialise, Run_Transaction, Observe);

   procedure Expect_Step
     (What : String; First_Run : Boolean; Failed : Boolean);

   ----------------
   -- Initialise --
   ----------------

   procedure Initialise is
   begin
      if Is_Broken then
         raise Program_Error;
      end if;
      Begun := Begun + 1;
   end Initialise;

   ---------------------
   -- Run_Transaction --
   ---------------------

   procedure Run_Transaction is
   begin
      if Is_Broken then
         raise Constraint_Error;
      end if;
      Run := Run + 1;
   end Run_Transaction;

   -------------
   -- Observe --
   -------------

   procedure Observe is
   begin
      Observed := Observed + 1;
   end Observe;

   -----------------
   -- Expect_Step --
   -----------------

   procedure Expect_Step
     (What : String; First_Run : Boolean; Failed : Boolean)
   is
      Outcome : Boolean;
   begin
      Partitions.Clocks.Set_Tick (Ada.Real_Time.Clock);
      Step (First_Run, Outcome);
      Expect (What & " has failed", Outcome, Failed);
   end Expect_Step;

   -----------------
   -- Whole_Steps --
   -----------------

   procedure Whole_Steps is
   begin
      Is_Broken := False;
      Begun := 0;
      Run := 0;
      Observed := 0;
      Expect_Step ("the first step", First_Run => True, Failed => False);
      Expect_Number ("initialised", Begun, 1);
      Expect_Number ("run in the first step", Run, 0);
      for Frame in 1 .. 3 loop
         Expect_Step ("a step", First_Run => False, Failed => False);
      end loop;
      Expect_Number ("initialised again", Begun, 1);
      Expect_Number ("transactions", Run, 3);
      Expect_Number ("seen", Observed, 3);
      Expect ("measured", Cost.Summed_Up.Number = 3, True);
      Expect ("response measured", Response.Summed_Up.Number = 3, True);
   end Whole_Steps;

   ----------------
   -- Exceptions --
   ----------------

   procedure Exceptions is
      Before : constant Natural := Observed;
   begin
      Is_Broken := True;
      Expect_Step ("a first step", First_Run => True, Failed => True);
      Expect_Step ("a later step", First_Run => False, Failed => True);
      Expect_Number ("seen", Observed, Before);
      Is_Broken := False;
      Expect_Step ("the next step", First_Run => False, Failed => False);
   end Exceptions;

   ------------
   -- Add_To --
   ------------

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "RTP-1 a step initialises first, then runs transactions",
         Whole_Steps'Access);
      Add
        (Suite, "KRN-6 a step that raises an exception has failed",
         Exceptions'Access);
   end Add_To;

end Guarded_Step_Tests;
