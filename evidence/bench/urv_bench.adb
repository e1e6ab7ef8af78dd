--  SPDX-License-Identifier: Apache-2.0

--  What calls of the flight software cost, as lines "WHAT NANOSECONDS", built
--  as it flies: under the Ravenscar profile, with all run-time checks.
--  evidence/bench.py runs it beside evidence/bench/peers.c, which has what a C
--  programmer would take instead.

with Ada.Text_IO;
with GNAT.OS_Lib;

with Bench_Boxes_28;
with Bench_Boxes_66;
with Bench_Boxes_1024;
with Bench_Scheduler;
with Bench_Semaphores;
with Bench_Switch;
with Bench_Times;
with Telemetry;          use Telemetry;
with Telemetry.Checksum;
with URV.Buffers;        use URV.Buffers;
with URV.Codecs;
with URVOS;              use URVOS;

procedure Urv_Bench is

   Sum   : Byte := Checksum.First_Value;
   Words : Downlink_Buffer := Neutral_Downlink;

   procedure Sum_Up (Turn : Positive);
   procedure Code (Turn : Positive);

   procedure Sum_Up (Turn : Positive) is
      pragma Unreferenced (Turn);
   begin
      for Place in 1 .. 56 loop
         Sum := Checksum.Next (Sum, Byte (Place));
      end loop;
   end Sum_Up;

   procedure Code (Turn : Positive) is
   begin
      Words (Altitude) := Word (Turn mod 4096);
      if URV.Codecs.Downlink.Decode (URV.Codecs.Downlink.Encode (Words))
        /= Words
      then
         raise Program_Error;
      end if;
   end Code;

   procedure Time_28 is new Bench_Times
     (Bench_Boxes_28.Exchange, "mailbox 28", 4_000);
   procedure Time_66 is new Bench_Times
     (Bench_Boxes_66.Exchange, "mailbox 66", 4_000);
   procedure Time_1024 is new Bench_Times
     (Bench_Boxes_1024.Exchange, "mailbox 1024", 4_000);
   procedure Time_P_V is new Bench_Times
     (Bench_Semaphores.Claim_And_Release, "semaphore 1", 4_000);
   procedure Time_Sum is new Bench_Times (Sum_Up, "checksum 56", 1_000);
   procedure Time_Code is new Bench_Times (Code, "codec 56", 4_000);
   procedure Time_Switch is new Bench_Times
     (Bench_Switch.There_And_Back, "switch 2", 500, Each => 2);
begin
   Time_28;
   Time_66;
   Time_1024;
   Time_P_V;
   Bench_Scheduler.Measure;
   Time_Sum;
   Time_Code;
   Time_Switch;
   if Sum = 0 then
      Ada.Text_IO.Put_Line ("# 0");
   end if;
   Ada.Text_IO.Flush;
   --  The other task of the switch never ends.
   GNAT.OS_Lib.OS_Exit (0);
end Urv_Bench;
