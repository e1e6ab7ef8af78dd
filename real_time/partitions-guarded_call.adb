--  SPDX-License-Identifier: Apache-2.0

with Partitions.Exceptions;

procedure Partitions.Guarded_Call is
begin
   Call;
exception
   when Error : others =>
      Exceptions.Report (Error);
      Raise_Processor_Exception;
end Partitions.Guarded_Call;
