--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Order with SPARK_Mode is

   procedure Aircraft_Consumers_Follow_Producers
     (Schedule : MCS_Schedule;
      Now      : Clock_Tick) is null;

   procedure Ground_Consumers_Follow_Producers
     (Schedule : GSC_Schedule;
      Now      : Clock_Tick) is null;

   procedure A_Frame_Is_Done_Within_It
     (Schedule : MCS_Schedule;
      Now      : Clock_Tick) is null;

end Theorems.Order;
