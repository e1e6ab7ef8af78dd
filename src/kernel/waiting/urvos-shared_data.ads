--  SPDX-License-Identifier: Apache-2.0

--  The data that one task keeps from one step to the next.
--
--  The protected object lets the task run on any processor that the node's
--  list gives it; each start may give it another (EXT-4). No other task sees
--  the data. No interrupt handler calls it: by its priority a bare machine
--  masks none meanwhile.

with System;

generic
   type Data is private;
   Initial : Data;
package URVOS.Shared_Data with SPARK_Mode is

   protected type Store with Priority => System.Priority'Last is

      procedure Write (Item : Data);

      function Contents return Data;

   private
      Kept : Data := Initial;
   end Store;

end URVOS.Shared_Data;
