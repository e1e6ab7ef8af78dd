--  SPDX-License-Identifier: Apache-2.0

--  What a node adds to the error/status word of what it sends (TST-4): the
--  check of the program memory in flight has found a difference. The bits
--  stand in URV.Buffers.

with URVOS; use URVOS;
with URVOS.Shared_Data;
with URV.Buffers; use URV.Buffers;

package URV.Shared_Status with SPARK_Mode is

   package Words is new URVOS.Shared_Data (Word, Initial => No_Error);

   subtype Status is Words.Store;

end URV.Shared_Status;
