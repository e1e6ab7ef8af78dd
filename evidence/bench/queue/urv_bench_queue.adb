--  SPDX-License-Identifier: Apache-2.0

--  Ada's own queue between tasks, which the Ravenscar profile does not have.

with Ada.Containers.Synchronized_Queue_Interfaces;
with Ada.Containers.Bounded_Synchronized_Queues;

with Bench_Times;

procedure Urv_Bench_Queue is

   type Byte is mod 256;
   type Bytes is array (1 .. 66) of Byte;

   package Interfaces is
     new Ada.Containers.Synchronized_Queue_Interfaces (Bytes);
   package Queues is
     new Ada.Containers.Bounded_Synchronized_Queues (Interfaces, 1);

   Queue : Queues.Queue;
   Sent  : Bytes := (others => 1);
   Got   : Bytes;

   procedure Exchange (Turn : Positive);

   procedure Exchange (Turn : Positive) is
   begin
      Sent (1) := Byte (Turn mod 256);
      Queue.Enqueue (Sent);
      Queue.Dequeue (Got);
      if Got (1) /= Sent (1) then
         raise Program_Error;
      end if;
   end Exchange;

   procedure Time_66 is new Bench_Times (Exchange, "ada_queue 66", 4_000);
begin
   Time_66;
end Urv_Bench_Queue;
