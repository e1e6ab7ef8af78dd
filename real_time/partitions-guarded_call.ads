--  SPDX-License-Identifier: Apache-2.0

--  An operation that an interrupt makes the processor execute. An unexpected
--  exception in it belongs to the processor and is not propagated (KRN-6).

generic
   with procedure Call;
   with procedure Raise_Processor_Exception;
procedure Partitions.Guarded_Call;
