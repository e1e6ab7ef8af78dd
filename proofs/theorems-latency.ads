--  SPDX-License-Identifier: Apache-2.0

--  A stick reaches the servos and a sensor the ground's CORE within half a
--  frame of the scan that read it, and within 30 ms of its change (FRM-5,
--  FRM-6; docs/design.md, Bounds). This holds for both nodes in the fast
--  schedule, with frames in step, on a wire and without faults; a slower line
--  adds its delay. It follows from the task lists, the lengths of messages,
--  and the phase of Theorems.In_Step.
--
--  A task is assumed to take no time. Times are microseconds from the
--  beginning of a frame. Drift within one frame is ignored.

with Devices.AD_Board; use Devices.AD_Board;
with GSC;
with MCS;
with Telemetry;        use Telemetry;
with Theorems.In_Step; use Theorems.In_Step;
with URV.Buffers;      use URV.Buffers;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Task_Trees; use URVOS.Task_Trees;

package Theorems.Latency with SPARK_Mode, Ghost is

   subtype Microseconds is Integer range -1_000_000 .. 1_000_000;

   Scan_Time : constant := Channel_Words'Length * Microseconds_Per_Conversion;

   function Time_Of (Offset : Minor_Frame) return Microseconds is
     (Integer (Offset) * Tick_Time);

   --  The beginning and the end of the scan that AD sends on, the last of its
   --  scans in the frame

   function Aircraft_Scan_Begins return Microseconds is
     (Time_Of (MCS.Task_List (MCS.AD_Task) (Fast).Offset)
      + (Integer (MCS.AD.Scans) - 1) * Scan_Time);

   function Aircraft_Scan_Ends return Microseconds is
     (Aircraft_Scan_Begins + Scan_Time);

   function Ground_Scan_Begins return Microseconds is
     (Time_Of (GSC.Task_List (GSC.AD_Task) (Fast).Offset)
      + (Integer (GSC.AD.Scans) - 1) * Scan_Time);

   function Ground_Scan_Ends return Microseconds is
     (Ground_Scan_Begins + Scan_Time);

   --  The time from TELOUT on the ground, at the scan's end, until the
   --  aircraft's board has the uplink: header, data, checksum and guard time.
   --  The guard time may be shorter by one count of the board's timer. Line is
   --  the delay of the line itself (LNK-11), 0 on a wire

   function Most_On_Line (Line : Line_Delay) return Microseconds is
     ((Uplink_Length + 2 + Integer (Guard_Time)) * Microseconds_Per_Character
      + Line);

   function Least_On_Line (Line : Line_Delay) return Microseconds is
     (Most_On_Line (Line) - Microseconds_Per_Character);

   --  The uplink's arrival within the aircraft's frame.
   function Uplink_Comes (Item : Situation) return Microseconds is
     (Time_Of (MCS.Task_List (MCS.TELIN_Task) (Fast).Offset) - Item.Before);

   --  All scans of a frame end within their minor frame.
   procedure Scans_End_In_Their_Minor_Frame
   with
     Global => null,
     Post   =>
       Aircraft_Scan_Ends <=
         Time_Of (MCS.Task_List (MCS.AD_Task) (Fast).Offset) + Tick_Time
       and then
         Ground_Scan_Ends <=
           Time_Of (GSC.Task_List (GSC.AD_Task) (Fast).Offset) + Tick_Time;

   --  The downlink is ready when an uplink arrives, so the aircraft's board
   --  announces it in its answer. No downlink is therefore skipped (LNK-7,
   --  docs/link.md, Two clocks).
   procedure A_Downlink_Waits_For_Its_Uplink (Item : Situation)
   with
     Global => null,
     Pre    => Is_In_Step (Item),
     Post   => Aircraft_Scan_Ends < Uplink_Comes (Item);

   --  The end of the exchange within the ground's frame: each of its first
   --  four messages has crossed the line.
   function Downlink_Comes (Line : Line_Delay) return Microseconds is
     (Ground_Scan_Ends + Exchange * Microseconds_Per_Character + 4 * Line);

   --  The extra time until the ground's TELIN takes it.
   function Taken_Later (Line : Line_Delay) return Microseconds is
     (if Downlink_Comes (Line) <=
        Time_Of (GSC.Task_List (GSC.TELIN_Task) (Fast).Offset)
      then 0
      else Frame_Time);

   --  On a wire, and up to a delay of 92 us, the exchange ends before the
   --  ground's TELIN runs; on a slower line, before it runs again.
   procedure A_Downlink_Comes_Before_TELIN (Line : Line_Delay)
   with
     Global => null,
     Post   =>
       Downlink_Comes (Line) <=
         Time_Of (GSC.Task_List (GSC.TELIN_Task) (Fast).Offset)
         + Taken_Later (Line)
       and then (if Line <= 92 then Taken_Later (Line) = 0);

   --  From the scan to the servos.
   function Stick_To_Servo
     (Item : Situation; Line : Line_Delay) return Microseconds
   is
     (Scan_Time + Most_On_Line (Line) + Item.Before
      + Time_Of (MCS.Task_List (MCS.PWM_Task) (Fast).Offset)
      - Time_Of (MCS.Task_List (MCS.TELIN_Task) (Fast).Offset));

   --  From the scan until the uplink arrives, and on to CORE.
   function Sensor_To_CORE
     (Item : Situation; Line : Line_Delay) return Microseconds
   is
     (Uplink_Comes (Item) - Aircraft_Scan_Begins
      + Time_Of (GSC.Task_List (GSC.CORE_Task) (Fast).Offset)
      + Taken_Later (Line) - Ground_Scan_Ends - Least_On_Line (Line));

   --  Together with the 20 ms that a change may wait for its scan, these are
   --  28 and 30 ms on a wire. On a line slower than 92 us a sensor takes one
   --  frame longer.
   procedure In_Step_Both_Are_Bounded (Item : Situation; Line : Line_Delay)
   with
     Global => null,
     Pre    => Is_In_Step (Item),
     Post   =>
       Stick_To_Servo (Item, Line) <= 7_987 + Line
       and then Sensor_To_CORE (Item, Line) <=
         9_892 - Line + Taken_Later (Line);

end Theorems.Latency;
