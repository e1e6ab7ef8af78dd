--  SPDX-License-Identifier: Apache-2.0

with Partitions.Exceptions;

procedure Partitions.Guarded_Start
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
end Partitions.Guarded_Start;
