--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time; use Ada.Real_Time;

with Partitions.Clocks;
with Partitions.Exceptions;

procedure Partitions.Guarded_Step
  (Who       : Task_Name;
   First_Run : Boolean;
   Now       : Clock_Tick;
   Call      : out Kernel_Call)
is
   Began : constant Time := Clock;
   Ended : Time;
begin
   Call := (Name => Next_Frame_Call, others => <>);
   if First_Run then
      Run_Step (Who, First_Run, Now, Call);

      --  The previous start may have taken a long time.
      Clocks.See_Tick;
   elsif Has_Stood_Still then
      Fail;
   else
      Run_Step (Who, First_Run, Now, Call);
      if Call.Name = Exit_Call then
         return;   --  the transaction continues
      end if;
      Ended := Clock;
      Costs (Who).Add (Clocks.Tenths_Of_Microseconds (Ended - Began));
      Responses (Who).Add
        (Clocks.Tenths_Of_Microseconds (Ended - Clocks.Time_Of (Now)));
      Observe (Who);
   end if;
exception
   when Error : others =>
      Exceptions.Report (Error);
      Call := (Name => Next_Frame_Call, others => <>);
      Fail;
end Partitions.Guarded_Step;
