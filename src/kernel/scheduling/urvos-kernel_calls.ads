--  The calls with which a task gives the processor away (report, section 3.3;
--  KRN-2 to KRN-4, D-25).

with URVOS.Frames; use URVOS.Frames;

package URVOS.Kernel_Calls with Pure, SPARK_Mode is

   type Call_Name is (Exit_Call, Sleep_Call, Terminate_Call);

   --  Until_Tick has a meaning for SLEEP only.
   type Kernel_Call is record
      Name       : Call_Name;
      Until_Tick : Tick := 0;
   end record;

end URVOS.Kernel_Calls;
