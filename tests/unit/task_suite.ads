--  SPDX-License-Identifier: Apache-2.0

--  Unit tests of the tasks and of the host.

with AUnit.Test_Suites;

package Task_Suite is

   --  MDI-1, MDO-1, GDI-1, GDO-1, D-11: the tasks between a node's variables.
   package Exchange_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Exchange_Tests;

   --  The bodies of the tasks send, write and report what their decisions say
   --  (SET-2): the decisions are proved, the bodies are not. Each test has
   --  inputs that all differ, so that a variable in another's place, or one
   --  that is forgotten, fails it.
   package Task_Shells_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Task_Shells_Tests;

   --  TIN-1, TOU-1: the tasks between a node and its telemetry board.
   package Telemetry_Task_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Telemetry_Task_Tests;

   --  EXT-2: data goes where its type code says, and configurations from the
   --  ground are taken whole or not at all.
   package Type_Codes_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Type_Codes_Tests;

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

   --  FTI-9, FTI-10: the flight recorder, and its rows on the way down.
   package Recorder_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Recorder_Tests;

   --  RTP-1: a serial device reports errors of characters.
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
