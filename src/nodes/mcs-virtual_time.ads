--  SPDX-License-Identifier: Apache-2.0

--  The aircraft's node in virtual time (KRN-1 to KRN-6, EXT-4).

pragma SPARK_Mode;

with URVOS.Virtual_Nodes;

package MCS.Virtual_Time is new URVOS.Virtual_Nodes
  (Tasks          => Tasks,
   Run_Step       => Run_Step,
   Begin_Again    => Starts.Begin_Again,
   Tell_Time      => Tell_Time,
   Report_Overrun => Report_Overrun);
