--  SPDX-License-Identifier: Apache-2.0

--  The cost of calls of the flight software, as lines "CALL NANOSECONDS". It
--  is built as it flies: with the Ravenscar profile and all run-time checks.
--  evidence/bench.py compares it with evidence/bench/peers.c, the usual C
--  alternatives.

with Ada.Text_IO;
with GNAT.OS_Lib;

with Bench_Calls;        use Bench_Calls;
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
     (Exchange_28, "mailbox 28", 4_000);
   procedure Time_66 is new Bench_Times
     (Exchange_66, "mailbox 66", 4_000);
   procedure Time_1024 is new Bench_Times
     (Exchange_1024, "mailbox 1024", 4_000);
   procedure Time_P_V is new Bench_Times
     (Claim_And_Release, "semaphore 1", 4_000);
   procedure Time_Sum is new Bench_Times (Sum_Up, "checksum 56", 1_000);
   procedure Time_Code is new Bench_Times (Code, "codec 56", 4_000);
   procedure Time_Switch is new Bench_Times
     (There_And_Back, "switch 2", 500, Each => 2);
begin
   Time_28;
   Time_66;
   Time_1024;
   Time_P_V;
   Measure_Scheduler;
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
