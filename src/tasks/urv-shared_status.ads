--  SPDX-License-Identifier: Apache-2.0

--  The node's own bits of the error/status word in its messages (TST-4,
--  TST-5): a memory that is checked in flight has a fault. URV.Buffers defines
--  the bits.

with URVOS;       use URVOS;
with URV.Buffers; use URV.Buffers;

package URV.Shared_Status with SPARK_Mode is

   protected type Status is

      --  Replaces all bits.
      procedure Write (Bits : Word);

      --  Sets these bits. The others stay.
      procedure Add (Bits : Word);

      function Contents return Word;

   private
      Item : Word := No_Error;
   end Status;

end URV.Shared_Status;
