with Ada.Real_Time; use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with System;
with Partitions.Clocks; use Partitions.Clocks;
with Partitions.Rows; use Partitions.Rows;
with URVOS.Frames; use URVOS.Frames;

package body Partitions.GSC_Node is

   Power : Suspension_Object;

   task Ticker with Priority => System.Default_Priority;
   task body Ticker is
      Now : Clock_Tick := 0;
      Next : Time;
      Item : Row;
   begin
      Suspend_Until_True (Power);
      Next := Switched_On_At;
      loop
         Next := Next + Milliseconds (2);
         delay until Next;
         Now := Advanced (Now);
         GSC.Clock_Interrupt (Now);
         if Minor_Frame_Of (Now) = 4 then
            Item.Length := 0;
            Append (Item, Number (Now / 10));
            Append (Item, Number ((Now / 10 + 1) * 20));
            Console.Append_Values (Item);
            Append (Item, Number (Machine_Time (Clock)));
            Queue.Put (Item);
         end if;
      end loop;
   end Ticker;

   procedure Switch_On is
   begin
      Telemetry_Processor.Switch_On;
      GSC.Cold_Start (0);
      Set_True (Power);
      Converter.Switch_On;
   end Switch_On;

end Partitions.GSC_Node;
