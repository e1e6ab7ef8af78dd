--  SPDX-License-Identifier: Apache-2.0

--  Runs the first two phases of a start in the partition and catches an
--  unexpected exception in them, in the role of the target's exception vector
--  (KRN-6).
--
--  The start has then failed, and is repeated; a start at power up remains a
--  cold start.

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
