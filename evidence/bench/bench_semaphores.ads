--  SPDX-License-Identifier: Apache-2.0

--  A semaphore that nobody else wants.

package Bench_Semaphores is

   --  P and V.
   procedure Claim_And_Release (Turn : Positive);

end Bench_Semaphores;
