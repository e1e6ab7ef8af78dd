--  SPDX-License-Identifier: Apache-2.0

--  The measured calls of the kernel. Their objects are at library level, as
--  the Ravenscar profile demands.

package Bench_Calls is

   --  SEND and RECV of a message of 28, 66 or 1,024 bytes.
   procedure Exchange_28 (Turn : Positive);
   procedure Exchange_66 (Turn : Positive);
   procedure Exchange_1024 (Turn : Positive);

   --  P and V of a semaphore that no other task claims.
   procedure Claim_And_Release (Turn : Positive);

   --  Another task runs, and hands back: two switches.
   procedure There_And_Back (Turn : Positive);

   --  Choices of the scheduler among 2, 10 and 16 tasks: as many as it has
   --  TCBs.
   procedure Measure_Scheduler;

end Bench_Calls;
