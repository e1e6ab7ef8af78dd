--  SPDX-License-Identifier: Apache-2.0

--  The signals of a partition: SIGINT and SIGTERM switch it off, SIGUSR1 is an
--  unexpected interrupt of its processor, SIGUSR2 its reset switch (INI-1,
--  KRN-6).
--
--  The signals are blocked in every other task. This package is therefore
--  elaborated before any task begins.

generic
   with procedure Switch_Off;
   with procedure Raise_Processor_Exception;
   with procedure Press_Reset_Switch;
package Partitions.Signals is

   --  From now on the signals have these effects.
   procedure Listen;

end Partitions.Signals;
