--  SPDX-License-Identifier: Apache-2.0

--  Unit tests of the telemetry link.

with AUnit.Test_Suites;

package Link_Suite is

   --  D-7: what the checksum is, and which errors change it.
   package Checksum_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Checksum_Tests;

   --  LNK-3, D-6: the first byte of a message.
   package Headers_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Headers_Tests;

   --  LNK-4, LNK-7: the buffers that board and controller share.
   package Board_Memory_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Board_Memory_Tests;

   --  LNK-3 to LNK-5: one board receives, character by character.
   package Receivers_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Receivers_Tests;

   --  LNK-3, D-5: a data message goes out, character by character.
   package Senders_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Senders_Tests;

   --  BUF-1 to BUF-3, D-1, D-3: names, words, wire bytes, and the way from a
   --  converter image to a buffer.
   package Codecs_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Codecs_Tests;

   --  SEC-1 to SEC-5: the sealed link.
   package Seal_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Seal_Tests;

   --  LNK-2 to LNK-10: two boards and a line between them that can be cut, and
   --  whose characters can be changed, lost, doubled and invented.
   package Link_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Link_Tests;

   --  Boards on a line slower than a wire (LNK-11).
   package Slow_Line_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Slow_Line_Tests;

end Link_Suite;
