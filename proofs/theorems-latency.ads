--  SPDX-License-Identifier: Apache-2.0

--  How long a stick takes to the servos and a sensor to the ground's CORE, in
--  step and in the fast schedule, without faults: at most half a frame from
--  the scan that saw it, 30 ms from the change (FRM-5, FRM-6; docs/design.md,
--  Bounds). It follows from the lists of tasks, the lengths of messages, and
--  how long before TELIN an uplink comes (Theorems.In_Step).
--
--  A task takes no time. Times are microseconds, of a frame from its
--  beginning; a drift within one frame is left out.

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

   --  When AD begins the scan that it hands on, and when it is over: the last
   --  of as many as it has made.

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

   --  From the scan's end, when TELOUT gives the ground's board the uplink,
   --  until the aircraft's has it: header, data, checksum, and the guard time,
   --  which is up to one count of the board's timer shorter. Line is the delay
   --  of the line itself (LNK-11), 0 on a wire.

   function Most_On_Line (Line : Line_Delay) return Microseconds is
     ((Uplink_Length + 2 + Integer (Guard_Time)) * Microseconds_Per_Character
      + Line);

   function Least_On_Line (Line : Line_Delay) return Microseconds is
     (Most_On_Line (Line) - Microseconds_Per_Character);

   --  When in the aircraft's frame the uplink comes.
   function Uplink_Comes (Item : Situation) return Microseconds is
     (Time_Of (MCS.Task_List (MCS.TELIN_Task) (Fast).Offset) - Item.Before);

   --  All scans of a frame are over within their minor frame.
   procedure Scans_End_In_Their_Minor_Frame
   with
     Global => null,
     Post   =>
       Aircraft_Scan_Ends <=
         Time_Of (MCS.Task_List (MCS.AD_Task) (Fast).Offset) + Tick_Time
       and then
         Ground_Scan_Ends <=
           Time_Of (GSC.Task_List (GSC.AD_Task) (Fast).Offset) + Tick_Time;

   --  When an uplink comes the downlink is there: the aircraft's board answers
   --  that it wants to send it. So none is left out (LNK-7, docs/link.md, Two
   --  clocks).
   procedure A_Downlink_Waits_For_Its_Uplink (Item : Situation)
   with
     Global => null,
     Pre    => Is_In_Step (Item),
     Post   => Aircraft_Scan_Ends < Uplink_Comes (Item);

   --  When in the ground's frame the exchange is over: each of its first
   --  four messages has crossed the line.
   function Downlink_Comes (Line : Line_Delay) return Microseconds is
     (Ground_Scan_Ends + Exchange * Microseconds_Per_Character + 4 * Line);

   --  By how much later than in that frame the ground's TELIN takes it.
   function Taken_Later (Line : Line_Delay) return Microseconds is
     (if Downlink_Comes (Line) <=
        Time_Of (GSC.Task_List (GSC.TELIN_Task) (Fast).Offset)
      then 0
      else Frame_Time);

   --  On a wire, and up to a delay of 92 us, the exchange is over when the
   --  ground's TELIN runs; by a slower line, before it runs again.
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

   --  From the scan until the uplink comes, and from there on.
   function Sensor_To_CORE
     (Item : Situation; Line : Line_Delay) return Microseconds
   is
     (Uplink_Comes (Item) - Aircraft_Scan_Begins
      + Time_Of (GSC.Task_List (GSC.CORE_Task) (Fast).Offset)
      + Taken_Later (Line) - Ground_Scan_Ends - Least_On_Line (Line));

   --  With the 20 ms that a change may wait for its scan, 28 and 30 ms on a
   --  wire; by a line slower than 92 us a sensor takes a frame longer.
   procedure In_Step_Both_Are_Bounded (Item : Situation; Line : Line_Delay)
   with
     Global => null,
     Pre    => Is_In_Step (Item),
     Post   =>
       Stick_To_Servo (Item, Line) <= 7_987 + Line
       and then Sensor_To_CORE (Item, Line) <=
         9_892 - Line + Taken_Later (Line);

end Theorems.Latency;
