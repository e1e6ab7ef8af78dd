--  SPDX-License-Identifier: Apache-2.0

--  Mailboxes of so many bytes, each between two tasks: under the Ravenscar
--  profile they are library-level objects.

with URVOS; use URVOS;
with URVOS.Shared_Mailboxes;

generic
   Length : Positive;
package Bench_Boxes is

   type Bytes is array (1 .. Length) of Byte;

   package Boxes is new URVOS.Shared_Mailboxes (Bytes, Bytes'(others => 0));

   Box : Boxes.Variable;

   --  SEND and RECV of a message.
   procedure Exchange (Turn : Positive);

end Bench_Boxes;
