--  SPDX-License-Identifier: Apache-2.0

--  Unit tests of the other tasks, and the host.

with AUnit.Test_Suites;

package Task_Suite is

   --  ADI-1, AD-1, INI-5: the scan of the converter's channels, its interrupt
   --  handler, and the task that passes it on.
   package AD_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end AD_Tests;

   --  COR-1, INI-6, INI-7, BUF-4: CORE memory and the task that writes it.
   package CORE_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end CORE_Tests;

   --  EXT-1, INI-6, TST-4: the log task and the words it leaves in CORE.
   package LOG_Task_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end LOG_Task_Tests;

   --  RTP-1: what a serial device tells of a character.
   package Serial_Line_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Serial_Line_Tests;

   --  RTP-3: floods.
   package Flood_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Flood_Tests;

   --  RTP-10: outputs that nobody waits for.
   package Output_Buffers_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Output_Buffers_Tests;

   --  RTP-7: the peer is heard when its blocks are taken.
   package Peer_Watch_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Peer_Watch_Tests;

end Task_Suite;
