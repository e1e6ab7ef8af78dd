--  SPDX-License-Identifier: Apache-2.0

--  Claims about latencies that are one microsecond too strict.

with Theorems.In_Step; use Theorems.In_Step;
with Theorems.Latency; use Theorems.Latency;

package Canaries.Latency with SPARK_Mode, Ghost is

   --  False: the bound is reached.
   procedure A_Sensor_Is_A_Microsecond_Earlier (Item : Situation)
   with
     Global => null,
     Pre    => Is_In_Step (Item),
     Post   => Sensor_To_CORE (Item, 0) <= 9_891;  --  VC_POSTCONDITION

end Canaries.Latency;
