--  SPDX-License-Identifier: Apache-2.0

--  Exceptions that nobody expected, in whatever the partition runs: each
--  restarts the processor that it happened on (KRN-6), and the partition
--  says at its end what the first one was.

with Ada.Exceptions; use Ada.Exceptions;

with URVOS; use URVOS;

package Partitions.Exceptions is

   --  A planted bus error is no fault of the program.
   procedure Tell (Error : Exception_Occurrence);

   function Number return Count;

   --  What the first one was.
   function First return String;

end Partitions.Exceptions;
