--  SPDX-License-Identifier: Apache-2.0

--  The common base of all programs on a host: the simulation, the real-time
--  partitions and the tests. Text in and out, scripts, scales, the bench and
--  the memories of the boards.

with Interfaces;

with Telemetry;
with URVOS;        use URVOS;
with URVOS.Frames; use URVOS.Frames;
with URVOS.Task_Trees;
with URV.Buffers;  use URV.Buffers;

package Host is

   --  The program's version, as in alire.toml.
   Version : constant String := "0.1.0";

   --  Since the ground node was switched on; in real time, since this node
   --  was.
   type Microseconds is range 0 .. 2 ** 62 - 1;

   --  No further event.
   Never : constant Microseconds := Microseconds'Last;

   Microseconds_Per_Millisecond : constant := 1_000;
   Microseconds_Per_Second      : constant := 1_000_000;

   --  Whole seconds by themselves: microseconds as a Duration would have room
   --  for 2.5 h only.
   function In_Seconds (Time : Microseconds) return Duration is
     (Duration (Time / Microseconds_Per_Second)
      + Duration (Time mod Microseconds_Per_Second) / 1_000_000);

   --  The kernel's times.
   Frame_Length : constant := Microseconds_Per_Tick * Ticks_Per_Major_Frame;
   Frame_Milliseconds : constant :=
     Frame_Length / Microseconds_Per_Millisecond;
   Tick_Time   : constant Microseconds := Microseconds_Per_Tick;
   Major_Frame : constant Microseconds := Frame_Length;

   --  The time, rounded up to major frames.
   function Whole_Frames (Time : Microseconds) return Microseconds is
     ((Time + Major_Frame - 1) / Major_Frame * Major_Frame);

   --  The lag of the aircraft's frame, in ticks (D-12).
   subtype Phase_Ticks is Natural range 0 .. Ticks_Per_Major_Frame - 1;

   --  By default it lags by 6 ms, whatever the length of a tick (EVI-12). At
   --  about 3 ms its block would just miss its turn on the link.
   Usual_Phase : constant Phase_Ticks := 6_000 / Microseconds_Per_Tick;

   --  The difference in length between the aircraft's and the ground's ticks,
   --  in millionths (FRM-6).
   type Drift_Number is range -200 .. 200;

   --  The seed of the random numbers.
   type Seed_Number is new Interfaces.Unsigned_64;

   subtype Schedule_Name is URVOS.Task_Trees.Schedule_Name;

   --  The ticks of the aircraft's frame at which its scans begin and the
   --  servos get new commands, and the number of ticks from these until the
   --  next scan (FRM-2, FRM-5).

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

   --  The words from the pilot's console to the ground's A/D board.
   type Console_Words is array (Command_Item) of Word;

   --  The words from the aircraft's sensors to its A/D board.
   type Sensor_Words is array (Sensor_Item) of Word;

   --  Cumulative counts of the serial link, in the order of the flight record.
   type Link_Item is
     (Uplink_Sent, Uplink_Received, Uplink_Bad, Uplink_Scrapped,
      Downlink_Sent, Downlink_Received, Downlink_Bad, Downlink_Scrapped,
      GSC_Resets, MCS_Resets);

   type Link_Counts is array (Link_Item) of Count;

   Neutral_Console : constant Console_Words :=
     (Switch_Item => 0, others => Neutral_Value);

   Neutral_Sensors : constant Sensor_Words := (others => Neutral_Value);

   --  A bad command line or a bad input file; the message names the place and
   --  the error. The program ends with exit status 2.
   Bad_Input : exception;

end Host;
