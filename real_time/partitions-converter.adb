--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time;                use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with System;

with Devices.AD_Board; use Devices.AD_Board;
with Partitions.Gates; use Partitions.Gates;

package body Partitions.Converter is

   Scan_Time : constant Time_Span :=
     Channel_Words'Length * Microseconds (Microseconds_Per_Conversion);

   --  How soon a start is seen.
   Look_Again : constant Time_Span := Milliseconds (1);

   Power : Suspension_Object;

   --  The board's hardware, and the controller that begins scans.
   Hardware_Side   : constant Side := Left;
   Controller_Side : constant Side := Right;

   Interrupts : Gate;

   procedure Hold_Interrupts is
   begin
      Enter (Interrupts, From => Controller_Side);
   end Hold_Interrupts;

   procedure Release_Interrupts is
   begin
      Leave (Interrupts, From => Controller_Side);
   end Release_Interrupts;

   --  The channel has been started: converts it, and those that the
   --  controller starts thereafter. One that is not behind the last begins
   --  another scan: the controller has given up the one before.
   procedure Convert (First : Channel_Number);

   procedure Convert (First : Channel_Number) is
      Words     : Channel_Words;
      Present   : Channel_Number := First;
      Next      : Channel_Number;
      Interrupt : Boolean;
      Wanted    : Boolean;
   begin
      Sample (Words);
      delay until Clock + Scan_Time;
      loop
         Enter (Interrupts, From => Hardware_Side);
         Board.Finish (Words (URV.Buffers.Channel (Present)), Interrupt);
         if Interrupt then
            Interrupt_Controller;
         end if;
         Board.Take_Start (Wanted, Next);
         Leave (Interrupts, From => Hardware_Side);
         exit when not Wanted;
         if Next <= Present then
            Sample (Words);
            delay until Clock + Scan_Time;
         end if;
         Present := Next;
      end loop;
   end Convert;

   task Hardware with Priority => System.Priority'Last - 3;

   task body Hardware is
      Wanted  : Boolean;
      Channel : Channel_Number;
   begin
      Suspend_Until_True (Power);
      loop
         Board.Take_Start (Wanted, Channel);
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
