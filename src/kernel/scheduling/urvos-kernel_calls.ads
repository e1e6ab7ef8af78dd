--  SPDX-License-Identifier: Apache-2.0

--  The calls by which a task gives up the processor (report, section 3.3;
--  KRN-2 to KRN-4, FRM-3, D-25).

with URVOS.Frames; use URVOS.Frames;

package URVOS.Kernel_Calls with Pure, SPARK_Mode is

   type Call_Name is
     (Exit_Call,
      Sleep_Call,         --  until Until_Tick
      Next_Frame_Call,    --  SLEEP until Offset in the next major frame
      Terminate_Call);    --  no task of a node ends (D-45)

   type Kernel_Call is record
      Name       : Call_Name;
      Until_Tick : Tick        := 0;
      Offset     : Minor_Frame := 0;
   end record;

end URVOS.Kernel_Calls;
