package body URVOS.Real_Time_Tasks with SPARK_Mode is

   task body Runner is
      First_Run : Boolean;
      Failed    : Boolean;
   begin
      loop
         Wait_For_Turn;
         Begin_Step (First_Run);
         Step (First_Run, Failed);
         End_Step (Offset, Failed);
      end loop;
   end Runner;

end URVOS.Real_Time_Tasks;
