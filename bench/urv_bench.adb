--  SPDX-License-Identifier: Apache-2.0

--  What calls of the flight software cost, as lines "WHAT NANOSECONDS", each
--  the mean over many. scripts/bench.py runs it beside bin/urv_bench_peers,
--  which has what a C programmer would take instead.

with Ada.Containers.Synchronized_Queue_Interfaces;
with Ada.Containers.Bounded_Synchronized_Queues;
with Ada.Real_Time; use Ada.Real_Time;
with Ada.Text_IO;

with Telemetry;          use Telemetry;
with Telemetry.Checksum;
with URV.Buffers;        use URV.Buffers;
with URV.Codecs;
with URVOS;              use URVOS;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Schedulers;   use URVOS.Schedulers;
with URVOS.Shared_Mailboxes;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

procedure Urv_Bench is

   Times : constant := 200_000;

   procedure Say (What : String; Started : Time; Done : Positive := Times);

   --  SEND and RECV of a message of that many bytes.
   generic
      Length : Positive;
   procedure Exchange;

   procedure Queue_Exchange;
   procedure Schedule;
   procedure Sum_Up;
   procedure Code;

   procedure Say (What : String; Started : Time; Done : Positive := Times)
   is
      Took : constant Duration := To_Duration (Clock - Started);
   begin
      Ada.Text_IO.Put_Line
        (What & Integer'Image
           (Integer (1.0E9 * Long_Float (Took) / Long_Float (Done))));
   end Say;

   procedure Exchange is

      type Bytes is array (1 .. Length) of Byte;

      package Boxes is new URVOS.Shared_Mailboxes (Bytes, Bytes'(others => 0));

      Box     : Boxes.Variable;
      Sent    : Bytes := (others => 1);
      Got     : Bytes;
      Success : Boolean;
      Fresh   : Boolean;
      Started : constant Time := Clock;
   begin
      for Turn in 1 .. Times loop
         Sent (1) := Byte (Turn mod 256);
         Box.Send (Sent, Success);
         Box.Receive (Got, Fresh);
         if not Success or else not Fresh or else Got (1) /= Sent (1) then
            raise Program_Error;
         end if;
      end loop;
      Say ("mailbox" & Length'Image, Started);
   end Exchange;

   procedure Exchange_28 is new Exchange (28);
   procedure Exchange_66 is new Exchange (66);
   procedure Exchange_1024 is new Exchange (1024);

   procedure Queue_Exchange is

      type Bytes is array (1 .. 66) of Byte;

      package Interfaces is
        new Ada.Containers.Synchronized_Queue_Interfaces (Bytes);
      package Queues is
        new Ada.Containers.Bounded_Synchronized_Queues (Interfaces, 1);

      Queue   : Queues.Queue;
      Sent    : Bytes := (others => 1);
      Got     : Bytes;
      Started : constant Time := Clock;
   begin
      for Turn in 1 .. Times loop
         Sent (1) := Byte (Turn mod 256);
         Queue.Enqueue (Sent);
         Queue.Dequeue (Got);
         if Got (1) /= Sent (1) then
            raise Program_Error;
         end if;
      end loop;
      Say ("ada_queue 66", Started);
   end Queue_Exchange;

   --  Every task of a full tree sleeps until the next frame, and is woken
   --  and chosen again: a decision is a choice and a sleep.
   procedure Schedule is
      Tree    : Task_Tree;
      Tasks   : Scheduler;
      Frames  : constant := 5_000;
      Done    : Natural := 0;
      Now     : Clock_Tick := 0;
      Started : Time;
   begin
      for Which in Tree'Range loop
         Tree (Which) :=
           (Id               => Task_Id (Which),
            Initial_Priority => Priority (Which),
            Start_Time       => 0);
      end loop;
      Start (Tasks, Tree, 0);
      Started := Clock;
      for Frame in 1 .. Frames loop
         while not Is_Idle (Tasks) loop
            Sleep (Tasks, Next_Frame (Now));
            Dispatch (Tasks);
            Done := Done + 1;
         end loop;
         Now := Next_Frame (Now);
         Wake (Tasks, Now);
         Dispatch (Tasks);
      end loop;
      Say ("decision" & Tree'Length'Image, Started, Done);
   end Schedule;

   procedure Sum_Up is
      Sum     : Byte := Checksum.First_Value;
      Started : constant Time := Clock;
   begin
      for Turn in 1 .. Times loop
         for Place in 1 .. 56 loop
            Sum := Checksum.Next (Sum, Byte (Place));
         end loop;
      end loop;
      Say ("checksum 56", Started);
      if Sum = 0 then
         Ada.Text_IO.Put_Line ("# 0");
      end if;
   end Sum_Up;

   procedure Code is
      Words   : Downlink_Buffer := Neutral_Downlink;
      Started : constant Time := Clock;
   begin
      for Turn in 1 .. Times loop
         Words (Altitude) := Word (Turn mod 4096);
         if URV.Codecs.Downlink.Decode (URV.Codecs.Downlink.Encode (Words))
           /= Words
         then
            raise Program_Error;
         end if;
      end loop;
      Say ("codec 56", Started);
   end Code;

begin
   Exchange_28;
   Exchange_66;
   Exchange_1024;
   Queue_Exchange;
   Schedule;
   Sum_Up;
   Code;
end Urv_Bench;
