--  SPDX-License-Identifier: Apache-2.0

--  Unexpected exceptions in any code of the partition: each restarts the
--  processor on which it occurred (KRN-6), and the partition reports the first
--  one at once and at its end. One that ends a task is reported, too.

with Ada.Exceptions; use Ada.Exceptions;

with URVOS; use URVOS;

package Partitions.Exceptions is

   pragma Elaborate_Body;

   --  A planted bus error is no fault of the program.
   procedure Report (Error : Exception_Occurrence);

   function Number return Count;

   --  The first exception.
   function First return String;

end Partitions.Exceptions;
