--  SPDX-License-Identifier: Apache-2.0

--  How long something takes: the median of many turns of many calls each, so
--  that what else the machine does hardly matters.

generic
   with procedure Call (Turn : Positive);
   What  : String;
   Calls : Positive;        --  of Call in a turn
   Each  : Positive := 1;   --  things done by one Call
procedure Bench_Times;
