--  SPDX-License-Identifier: Apache-2.0

--  Choices of the scheduler among 2, 10 and 16 tasks: as many as it has TCBs.

package Bench_Scheduler is

   procedure Measure;

end Bench_Scheduler;
