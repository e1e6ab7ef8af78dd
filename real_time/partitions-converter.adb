with Ada.Real_Time;                use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with System;

package body Partitions.Converter is

   Scan_Time : constant Time_Span :=
     32 * Microseconds (Microseconds_Per_Conversion);

   --  How soon a start is seen.
   Look_Again : constant Time_Span := Milliseconds (1);

   Power : Suspension_Object;

   --  The channel has been started: converts it, and those that the
   --  controller starts thereafter.
   procedure Convert (First : Channel_Number);

   procedure Convert (First : Channel_Number) is
      Words     : Channel_Words;
      Present   : Channel_Number := First;
      Interrupt : Boolean;
      Wanted    : Boolean;
   begin
      Sample (Words);
      delay until Clock + Scan_Time;
      loop
         Finish (Words (URV.Buffers.Channel (Present)), Interrupt);
         if Interrupt then
            Interrupt_Controller;
         end if;
         Take_Start (Wanted, Present);
         exit when not Wanted;
      end loop;
   end Convert;

   task Hardware with Priority => System.Priority'Last - 3;

   task body Hardware is
      Wanted  : Boolean;
      Channel : Channel_Number;
   begin
      Suspend_Until_True (Power);
      loop
         Take_Start (Wanted, Channel);
         if Wanted then
            Convert (Channel);
         end if;
         delay until Clock + Look_Again;
      end loop;
   end Hardware;

   procedure Switch_On is
   begin
      Set_True (Power);
   end Switch_On;

end Partitions.Converter;
