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
      pragma Assert
        (for all Who in MCS.Task_Name =>
           MCS.Task_List (Who) (Set).Offset < Minor_Frame'Last);
      pragma Assert (MCS.Task_List (MCS.AD_Task) (Set).Offset = 0);
      for Who in MCS.Task_Name loop
         pragma Assert
           (Run (Who) in Next_Frame (Now) ..
                           Next_Frame (Now) + Ticks_Per_Major_Frame - 2);
         pragma Loop_Invariant
           (for all Done in MCS.Task_Name'First .. Who =>
              Run (Done) in Next_Frame (Now) ..
                              Next_Frame (Now) + Ticks_Per_Major_Frame - 2);
      end loop;
   end A_Frame_Is_Done_Within_It;

   procedure A_Ground_Frame_Is_Done_Within_It
     (Run : GSC_Run;
      Now : Clock_Tick;
      Set : Schedule_Name) is
   begin
      pragma Assert
        (for all Who in GSC.Task_Name =>
           GSC.Task_List (Who) (Set).Offset < Minor_Frame'Last);
      pragma Assert (GSC.Task_List (GSC.AD_Task) (Set).Offset = 0);
      for Who in GSC.Task_Name loop
         pragma Assert
           (Run (Who) in Next_Frame (Now) ..
                           Next_Frame (Now) + Ticks_Per_Major_Frame - 2);
         pragma Loop_Invariant
           (for all Done in GSC.Task_Name'First .. Who =>
              Run (Done) in Next_Frame (Now) ..
                              Next_Frame (Now) + Ticks_Per_Major_Frame - 2);
      end loop;
   end A_Ground_Frame_Is_Done_Within_It;

end Theorems.Order;
