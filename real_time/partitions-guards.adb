--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time; use Ada.Real_Time;

with Partitions.Clocks;
with Partitions.Exceptions;

package body Partitions.Guards is

   procedure Call is
   begin
      Interrupt;
   exception
      when Error : others =>
         Exceptions.Report (Error);
         Raise_Processor_Exception;
   end Call;

   procedure Start
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean) is
   begin
      Begin_Again (Condition, Now, Passed);
   exception
      when Error : others =>
         Exceptions.Report (Error);
         Passed := False;
         Request_Start
           (if Condition = Cold_Start then Cold_Start else Processor_Restart);
   end Start;

   procedure Step
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
   end Step;

end Partitions.Guards;
