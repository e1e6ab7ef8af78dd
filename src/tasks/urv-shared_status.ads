--  SPDX-License-Identifier: Apache-2.0

--  The node's own bits of the error/status word in its messages (TST-4): the
--  check of the program memory in flight has found a difference. URV.Buffers
--  defines the bits.

with URVOS; use URVOS;
with URVOS.Shared_Data;
with URV.Buffers; use URV.Buffers;

package URV.Shared_Status with SPARK_Mode is

   package Words is new URVOS.Shared_Data (Word, Initial => No_Error);

   subtype Status is Words.Store;

end URV.Shared_Status;
