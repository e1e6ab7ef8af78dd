--  SPDX-License-Identifier: Apache-2.0

--  The first two phases of a start in the partition: what runs them, and what
--  catches an unexpected exception in them, which the target has as an
--  exception vector (KRN-6).
--
--  The start has failed then, and begins anew; one at power up stays a cold
--  start.

with URVOS.Frames; use URVOS.Frames;
with URVOS.Starts; use URVOS.Starts;

generic
   with procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);
   with procedure Request_Start (Condition : Start_Condition);
procedure Partitions.Guarded_Start
  (Condition : Start_Condition;
   Now       : Clock_Tick;
   Passed    : out Boolean);
