--  SPDX-License-Identifier: Apache-2.0

--  What the programs on a host share, whatever moves their time: the
--  simulation, the real-time partitions and the tests. Text in and out,
--  scripts, scales, the bench and the memories behind the boards.

with Interfaces;

with Telemetry;
with URVOS;        use URVOS;
with URVOS.Frames; use URVOS.Frames;
with URVOS.Task_Trees;
with URV.Buffers;  use URV.Buffers;

package Host is

   --  Of the program, as in alire.toml.
   Version : constant String := "0.1.0-dev";

   --  Since the ground node was switched on; in real time, since the node was.
   type Microseconds is range 0 .. 2 ** 62 - 1;

   --  When nothing more happens.
   Never : constant Microseconds := Microseconds'Last;

   Microseconds_Per_Millisecond : constant := 1_000;
   Microseconds_Per_Second      : constant := 1_000_000;

   --  The kernel's times.
   Frame_Length : constant := Microseconds_Per_Tick * Ticks_Per_Major_Frame;
   Frame_Milliseconds : constant :=
     Frame_Length / Microseconds_Per_Millisecond;
   Tick_Time   : constant Microseconds := Microseconds_Per_Tick;
   Major_Frame : constant Microseconds := Frame_Length;

   --  The time, rounded up to major frames.
   function Whole_Frames (Time : Microseconds) return Microseconds is
     ((Time + Major_Frame - 1) / Major_Frame * Major_Frame);

   --  How many ticks the aircraft's frame may lag behind (D-12).
   subtype Phase_Ticks is Natural range 0 .. Ticks_Per_Major_Frame - 1;

   --  As a rule it lags by 6 ms, however long a tick is (EVI-12). At about
   --  3 ms its block would just miss its turn on the link.
   Usual_Phase : constant Phase_Ticks := 6_000 / Microseconds_Per_Tick;

   --  By how many millionths the aircraft's ticks may be longer than the
   --  ground's (FRM-6).
   type Drift_Number is range -200 .. 200;

   --  Where chance begins.
   type Seed_Number is new Interfaces.Unsigned_64;

   subtype Schedule_Name is URVOS.Task_Trees.Schedule_Name;

   --  In these ticks of the aircraft's frame its scans begin and the servos
   --  get new commands; from these it is so many until the next scan (FRM-2,
   --  FRM-5).

   function Scan_Tick (Schedule : Schedule_Name) return Phase_Ticks is
     (case Schedule is
         when URVOS.Task_Trees.Report => 0,
         when URVOS.Task_Trees.Fast   => 1);

   function Servo_Tick (Schedule : Schedule_Name) return Phase_Ticks is
     (case Schedule is
         when URVOS.Task_Trees.Report => 2,
         when URVOS.Task_Trees.Fast   => 4);

   function Ticks_To_Scan (Schedule : Schedule_Name) return Phase_Ticks is
     (Ticks_Per_Major_Frame - Servo_Tick (Schedule) + Scan_Tick (Schedule));

   --  On the serial link (D-4).
   Character_Time : constant Microseconds :=
     Telemetry.Microseconds_Per_Character;

   --  Their flight software is GSC and MCS.
   type Node is (Ground, Aircraft);

   --  What the pilot's console gives the ground's A/D board.
   type Console_Words is array (Command_Item) of Word;

   --  What the aircraft's sensors give the aircraft's A/D board.
   type Sensor_Words is array (Sensor_Item) of Word;

   --  Cumulative counts of the serial link, in the order of the flight
   --  record.
   type Link_Item is
     (Uplink_Sent, Uplink_Received, Uplink_Bad, Uplink_Scrapped,
      Downlink_Sent, Downlink_Received, Downlink_Bad, Downlink_Scrapped,
      GSC_Resets, MCS_Resets);

   type Link_Counts is array (Link_Item) of Count;

   Neutral_Console : constant Console_Words :=
     (Switch_Item => 0, others => Neutral_Value);

   Neutral_Sensors : constant Sensor_Words := (others => Neutral_Value);

   --  A bad command line or a bad input file, with a message that says
   --  where and what. The program ends with exit status 2.
   Bad_Input : exception;

end Host;
