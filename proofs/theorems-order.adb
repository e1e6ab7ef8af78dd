--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Order with SPARK_Mode is

   procedure Aircraft_Consumers_Follow_Producers
     (Run : MCS_Run;
      Now : Clock_Tick;
      Set : Schedule_Name) is null;

   procedure Ground_Consumers_Follow_Producers
     (Run : GSC_Run;
      Now : Clock_Tick;
      Set : Schedule_Name) is null;

   procedure Aircraft_Is_Fast (Run : MCS_Run; Now : Clock_Tick) is null;

   procedure Ground_Is_Fast (Run : GSC_Run; Now : Clock_Tick) is null;

   procedure A_Frame_Is_Done_Within_It
     (Run : MCS_Run;
      Now : Clock_Tick;
      Set : Schedule_Name) is
   begin
      pragma Assert (Is_Legal (Run, Now, Set));
      pragma Assert
        (for all Who in MCS.Task_Name =>
           MCS.Task_List (Who) (Set).Offset < Minor_Frame'Last);
   end A_Frame_Is_Done_Within_It;

   procedure A_Ground_Frame_Is_Done_Within_It
     (Run : GSC_Run;
      Now : Clock_Tick;
      Set : Schedule_Name) is null;

end Theorems.Order;
