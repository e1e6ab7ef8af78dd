--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time;                use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with System;

with Partitions.Exceptions;
with Partitions.Flood_Guards; use Partitions.Flood_Guards;
with Partitions.Links; use Partitions.Links;
with Partitions.Round_Trips;
with Telemetry;        use Telemetry;
with Telemetry.Headers; use Telemetry.Headers;

package body Partitions.Telemetry_Processor is

   Character_Time : constant Time_Span :=
     Microseconds (Microseconds_Per_Character);

   --  The interval at which an idle board looks for a block of its controller.
   Look_Again : constant Time_Span := Milliseconds (2);

   --  A frame: the age of a block that the controller takes in time is less.
   Longest_Pause : constant Time_Span := Milliseconds (20);

   --  After its input is discarded, the board receives again after its dead
   --  space of silence, as after a loss of synchronization; at the latest
   --  after five frames.
   Silence          : Time_Span := Integer (Dead_Space) * Character_Time;
   Longest_Deafness : constant Time_Span := Milliseconds (100);

   Power : Suspension_Object;

   --  The reset switch was pressed.
   Is_Pressed : Boolean := False with Atomic;

   Unasked : Count := 0 with Atomic;

   --  Used by the task only.

   --  The time up to which the board's timer has counted.
   Counted_Until : Time := Time_First;

   --  The character on the line, and the end of its last bit.
   On_Line  : Boolean := False;
   Present  : Byte    := 0;
   Ends     : Time    := Time_First;

   --  The block being sent is a data message: it has more than one character.
   Is_Data : Boolean := False;

   --  The unanswered data messages: the last one, and the one before it, whose
   --  answer the board does not expect any more.
   type Unanswered is record
      Is_There : Boolean := False;
      Ended_At : Time    := Time_First;
   end record;
   Newest, Earlier : Unanswered;

   --  The time that the board will wait without events.
   Time_Left : Character_Times := Character_Times'Last;

   Heard : Arrivals;

   --  A flood exceeds a line (RTP-3).
   Guard : Flood_Guards.Guard;

   --  Characters were lost, as by an overrun of the DUART: the board gets the
   --  next one as damaged.
   Overrun : Boolean := False;

   --  All input has arrived after this time.
   Emptied_At : Time := Time_First;

   --  The character times since the last query of the board's timer.
   procedure Ask_Timer (Now : Time; Elapsed : out Character_Times);

   --  Restarts the board and discards its input.
   procedure Restart;

   --  The interrupt handler.
   procedure Take_In (Now : Time);

   --  A status answers the newest data message if it comes in time for that,
   --  otherwise the one before it, if that has no answer.
   procedure Look_For_Answer (Now : Time; Data : Byte);

   --  Does all due work.
   procedure Run;

   --  The main program: sends every character due by Now.
   procedure Transmit_Due (Now : Time);

   function Next_Instant (Now : Time) return Time;

   procedure Ask_Timer (Now : Time; Elapsed : out Character_Times) is
      Whole : Integer;
   begin
      if Now <= Counted_Until then
         Elapsed := 0;
      else
         Whole := Integer'Min
           ((Now - Counted_Until) / Character_Time,
            Integer (Character_Times'Last));
         Elapsed := Character_Times (Whole);
         Counted_Until := Counted_Until + Whole * Character_Time;
      end if;
   end Ask_Timer;

   procedure Restart is
   begin
      Board.Start;

      --  The board neither receives nor sends meanwhile.
      Links.Discard (Silence, Longest_Deafness);
      On_Line := False;
      Newest.Is_There := False;
      Earlier.Is_There := False;
      Time_Left := 0;
      Emptied_At    := Clock;
      Counted_Until := Emptied_At;
      Overrun := False;
      Start (Guard, Emptied_At);
   end Restart;

   procedure Look_For_Answer (Now : Time; Data : Byte) is
   begin
      if not Headers.Is_Valid (Data)
        or else Headers.Decode (Data).Kind /= Headers.Status
      then
         return;
      elsif Newest.Is_There
        and then
          (not Earlier.Is_There
           or else Round_Trips.Is_In_Time (Now - Newest.Ended_At))
      then
         Round_Trips.Note_Answer (After => Now - Newest.Ended_At);
      elsif Earlier.Is_There then
         Round_Trips.Note_Answer (After => Now - Earlier.Ended_At);
      end if;
      Newest.Is_There := False;
      Earlier.Is_There := False;
   end Look_For_Answer;

   procedure Take_In (Now : Time) is
      Unused : Boolean;
   begin
      for Item of Heard.Items (1 .. Heard.Length) loop
         Board.Accept_Character
           (0, Item.Data, Item.Parity_Error or else Overrun, Unused);
         Overrun := False;
      end loop;
      if Heard.Length > 0 then
         Counted_Until := Now;
         Look_For_Answer (Now, Heard.Items (1).Data);
      end if;
   end Take_In;

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
         Board.Next_Character (Elapsed, Send, Data, Time_Left);
         if Send and then not On_Line then
            if Newest.Is_There then
               Earlier := Newest;
               Newest.Is_There := False;
            end if;
            Is_Data := False;
         elsif Send then
            Is_Data := True;
         elsif On_Line and then Is_Data then
            Newest := (Is_There => True, Ended_At => Moment);
         end if;
         On_Line := Send;
         exit when not Send;
         Present := Data;
         Ends    := Moment + Character_Time;
      end loop;

      --  Input of another time is not used.
      if Length > 0 and then Clock - Now <= Longest_Pause then
         Links.Send (Batch (1 .. Length));
      end if;
   end Transmit_Due;

   function Next_Instant (Now : Time) return Time is
      Time_Out : constant Time :=
        Counted_Until + Integer (Time_Left) * Character_Time;
      Look     : constant Time := Now + Look_Again;
   begin
      return
        (if On_Line then Ends
         elsif Time_Left < Character_Times'Last and then Time_Out < Look
         then Time_Out
         else Look);
   end Next_Instant;

   procedure Run is
      Looked_At : constant Time := Clock;
      Now       : Time;
      Is_Flood  : Boolean;
   begin
      Links.Receive (Heard);
      Now := Clock;
      Take
        (Guard, Now,
         Amount'Max (Amount (Heard.Length), Amount (Heard.Reads)), Is_Flood);
      if Is_Flood then
         Links.Throw_Away (Heard);
         Overrun := True;
      end if;
      if Now - Emptied_At > Longest_Pause then
         Unasked := Incremented (Unasked);
         Board.Clear_Transmit_Half;
         Is_Pressed := True;
      end if;

      if Is_Pressed then
         Is_Pressed := False;
         Restart;
      else
         if Heard.Emptied then
            Emptied_At := Looked_At;
         end if;
         Take_In (Now);
         Transmit_Due (Now);
      end if;
      if Is_Flood then
         Links.Wait (Now + Rest, Look_At_Line => False);
      else
         Links.Wait (Next_Instant (Now));
      end if;
   exception
      when Error : others =>
         Exceptions.Report (Error);
         Is_Pressed := True;
   end Run;

   --  At the ceiling of its shared objects, like the converter.
   task Processor with Priority => System.Priority'Last;

   task body Processor is
   begin
      Suspend_Until_True (Power);
      Restart;
      loop
         Run;
      end loop;
   end Processor;

   procedure Switch_On (Line : Telemetry.Line_Delay) is
   begin
      Board.Set_Round_Trip (Round_Trip_Of (Line));
      Round_Trips.Set_Line (Line);
      Silence :=
        Integer (Dead_Space_On (Round_Trip_Of (Line))) * Character_Time;
      Set_True (Power);
   end Switch_On;

   procedure Reset is
   begin
      Is_Pressed := True;
      Links.Wake;
   end Reset;

   procedure Look is
   begin
      Links.Wake;
   end Look;

   function Starts_Unasked return Count is (Unasked);

end Partitions.Telemetry_Processor;
