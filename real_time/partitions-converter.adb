--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time;                use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with System;

with Devices.AD_Board; use Devices.AD_Board;
with Partitions.Exceptions;
with Partitions.Gates; use Partitions.Gates;

package body Partitions.Converter is

   Scan_Time : constant Time_Span :=
     Channel_Words'Length * Microseconds (Microseconds_Per_Conversion);

   --  A scan that begins within this time after another one follows it.
   Longest_Gap : constant Time_Span := Scan_Time;

   --  The controller may have started a channel.
   Requested : Suspension_Object;

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
      Set_True (Requested);
   end Release_Interrupts;

   --  The end of the last scan, past or future.
   Ended : Time := Time_First;

   --  Samples the channels and returns at the end of their scan. After an
   --  exception the scan is missing, and the next one is tried.
   procedure Scan (Words : out Channel_Words; Is_There : out Boolean);

   --  Converts the started channel, and the following ones that the controller
   --  starts. Wanted: it has then started a channel out of order, which is
   --  another scan, because it has given up the one before.
   procedure Convert
     (Channel : in out Channel_Number;
      Wanted  : out Boolean);

   procedure Scan (Words : out Channel_Words; Is_There : out Boolean) is
      Present : constant Time    := Clock;
      Is_Next : constant Boolean := Present < Ended + Longest_Gap;
   begin
      begin
         Sample (Is_Next, Words, Is_There);
      exception
         when Error : others =>
            Exceptions.Report (Error);
            Is_There := False;
      end;
      Ended := (if Is_Next then Ended else Present) + Scan_Time;
      delay until Ended;
   end Scan;

   procedure Convert
     (Channel : in out Channel_Number;
      Wanted  : out Boolean)
   is
      Words     : Channel_Words;
      Present   : Channel_Number;
      Interrupt : Boolean;
      Is_There  : Boolean;
   begin
      Scan (Words, Is_There);
      if not Is_There then
         Wanted := False;
         return;
      end if;
      Enter (Interrupts, From => Hardware_Side);
      loop
         Present := Channel;
         Board.Finish (Words (URV.Buffers.Channel (Present)), Interrupt);
         if Interrupt then
            Interrupt_Controller;
         end if;
         Board.Take_Start (Wanted, Channel);
         exit when not Wanted or else Channel <= Present;
      end loop;
      Leave (Interrupts, From => Hardware_Side);
   end Convert;

   --  At the ceiling of the objects shared with the controller: where threads
   --  have priorities, none of its calls changes them.
   task Hardware with Priority => System.Priority'Last;

   task body Hardware is
      Wanted  : Boolean;
      Channel : Channel_Number;
   begin
      loop
         Suspend_Until_True (Requested);
         Board.Take_Start (Wanted, Channel);
         while Wanted loop
            Convert (Channel, Wanted);
         end loop;
      end loop;
   end Hardware;

end Partitions.Converter;
