with Ada.Real_Time;                use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with System;

with Partitions.Links; use Partitions.Links;

package body Partitions.Telemetry_Processor is

   Character_Time : constant Time_Span :=
     Microseconds (Microseconds_Per_Character);

   --  How soon a board at rest looks for a block of its controller unasked.
   Look_Again : constant Time_Span := Milliseconds (2);

   Power : Suspension_Object;

   --  Of the task alone.

   --  Up to when the board's timer has been told.
   Told_Until : Time := Time_First;

   --  The character on the line, and when its last bit has left.
   On_Line  : Boolean := False;
   Present  : Byte    := 0;
   Ends     : Time    := Time_First;

   --  How long the board will wait if nothing happens.
   Time_Left : Character_Times := Character_Times'Last;

   Heard : Arrivals;

   --  The character times since the board's timer was last told.
   procedure Ask_Timer (Now : Time; Elapsed : out Character_Times);

   --  The interrupt handler.
   procedure Receive_All (Now : Time);

   --  The main program: every character whose time has come by Now.
   procedure Transmit_Due (Now : Time);

   function Next_Instant (Now : Time) return Time;

   procedure Ask_Timer (Now : Time; Elapsed : out Character_Times) is
      Whole : Integer;
   begin
      if Now <= Told_Until then
         Elapsed := 0;
      else
         Whole := Integer'Min
           ((Now - Told_Until) / Character_Time,
            Integer (Character_Times'Last));
         Elapsed := Character_Times (Whole);
         Told_Until := Told_Until + Whole * Character_Time;
      end if;
   end Ask_Timer;

   procedure Receive_All (Now : Time) is
      Unused : Boolean;
   begin
      Links.Receive (Heard);
      for Item of Heard.Items (1 .. Heard.Length) loop
         Accept_Character (0, Item.Data, Item.Parity_Error, Unused);
      end loop;
      if Heard.Length > 0 then
         Told_Until := Now;
      end if;
   end Receive_All;

   procedure Transmit_Due (Now : Time) is
      Batch  : Character_Array (1 .. 256);
      Length : Character_Count := 0;
      Moment : Time            := Now;
      Elapsed : Character_Times;
      Send    : Boolean;
      Data    : Byte;
   begin
      loop
         if On_Line then
            exit when Ends > Now or else Length = Batch'Last;
            Length := Length + 1;
            Batch (Length) := Present;
            Moment := Ends;
         end if;

         Ask_Timer (Moment, Elapsed);
         Next_Character (Elapsed, Send, Data, Time_Left);
         On_Line := Send;
         exit when not Send;
         Present := Data;
         Ends    := Moment + Character_Time;
      end loop;

      if Length > 0 then
         Links.Send (Batch (1 .. Length));
      end if;
   end Transmit_Due;

   function Next_Instant (Now : Time) return Time is
      Time_Out : constant Time :=
        Told_Until + Integer (Time_Left) * Character_Time;
      Look     : constant Time := Now + Look_Again;
   begin
      return
        (if On_Line then Ends
         elsif Time_Left < Character_Times'Last and then Time_Out < Look
         then Time_Out
         else Look);
   end Next_Instant;

   task Processor with Priority => System.Priority'Last - 2;

   task body Processor is
      Now : Time;
   begin
      Suspend_Until_True (Power);
      Told_Until := Clock;
      loop
         Now := Clock;
         Receive_All (Now);
         Transmit_Due (Now);
         Links.Wait (Next_Instant (Now));
      end loop;
   end Processor;

   procedure Switch_On is
   begin
      Start;
      Set_True (Power);
   end Switch_On;

   procedure Look is
   begin
      Links.Nudge;
   end Look;

end Partitions.Telemetry_Processor;
