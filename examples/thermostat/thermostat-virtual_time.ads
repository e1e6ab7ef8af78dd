--  SPDX-License-Identifier: Apache-2.0

--  The thermostat in virtual time.

with URVOS.Virtual_Nodes;

package Thermostat.Virtual_Time is new URVOS.Virtual_Nodes (Software);
