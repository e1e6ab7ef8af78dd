--  SPDX-License-Identifier: Apache-2.0

--  The thermostat in virtual time.

with URVOS.Virtual_Nodes;

package Thermostat.Virtual_Time is new URVOS.Virtual_Nodes
  (Tasks, Run_Step, Begin_Again, Tell_Time, Report_Overrun);
