package body URVOS.Sleepers with SPARK_Mode is

   procedure Sleep
     (List       : in out Sleeper_List;
      Who        : Task_Name;
      Until_Tick : Tick)
   is
   begin
      List (Who) := Until_Tick;
   end Sleep;

end URVOS.Sleepers;
