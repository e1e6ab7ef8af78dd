--  SPDX-License-Identifier: Apache-2.0

--  The signals that a partition is sent: SIGINT and SIGTERM switch it off,
--  SIGUSR1 stands for an unexpected interrupt of its processor, SIGUSR2 for
--  its reset switch (INI-1, KRN-6).
--
--  The signals are kept from every other task. So this package comes before
--  any task begins.

generic
   with procedure Switch_Off;
   with procedure Raise_Processor_Exception;
   with procedure Press_Reset_Switch;
package Partitions.Signals is

   --  From now on signals do what they should.
   procedure Listen;

end Partitions.Signals;
