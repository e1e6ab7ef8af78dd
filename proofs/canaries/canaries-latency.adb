--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Latency with SPARK_Mode is

   procedure A_Sensor_Is_A_Microsecond_Earlier (Item : Situation) is
   begin
      In_Step_Is_In_Time (Item);
   end A_Sensor_Is_A_Microsecond_Earlier;

end Canaries.Latency;
