--  SPDX-License-Identifier: Apache-2.0

--  Something that the processor is made to do by an interrupt. An unexpected
--  exception in it is one of the processor: it is not passed on (KRN-6).

generic
   with procedure Call;
   with procedure Raise_Processor_Exception;
procedure Partitions.Guarded_Call;
