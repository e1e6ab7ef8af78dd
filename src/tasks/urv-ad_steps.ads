--  SPDX-License-Identifier: Apache-2.0

--  The decision of the AD task (D-70): the image that it hands on, and in the
--  fast schedule when it begins a scan, waits for it, and hands it on (report,
--  4.1; AD-1, FRM-5, SAF-5). The task receives, calls these functions, begins
--  scans, sends and reports; Theorems.Safety calls the same functions. Each is
--  an expression function: its text is its contract.

with URVOS.Frames; use URVOS.Frames;
with URVOS.Waits;  use URVOS.Waits;
with URV.AD_Scans; use URV.AD_Scans;
with URV.Buffers;  use URV.Buffers;
with URV.Routing;  use URV.Routing;

package URV.AD_Steps with Pure, SPARK_Mode is

   --  In the fast schedule the task waits for a scan. Otherwise: whether the
   --  last frame had a scan in time.
   type Activity is (Had_Scan, Had_No_Scan, Scanning);

   --  The task keeps from step to step: the scans of this frame that it has
   --  received, and how long it still waits.
   type Progress is record
      Doing    : Activity   := Had_Scan;
      Received : Scan_Count := 0;
      Timeout  : Wait       := Begun (0, 0);
   end record;

   --  The report's schedule hands on the last frame's scan, marked with an
   --  error when there was none.
   function Last_Image (Item : Channel_Words; Fresh : Boolean) return AD_Image
   is (Stamped (Item, Fresh))
   with Global => null;

   --  The first step of a frame begins a scan, and waits for it a tick.
   function Scan_Begun (Now : Clock_Tick) return Progress is
     ((Doing => Scanning, Received => 0, Timeout => Begun (Now, 1)))
   with Global => null;

   --  The progress after a look for a scan.
   function Counted (Kept : Progress; Fresh : Boolean) return Progress is
     ((Kept with delta
         Received =>
           (if Fresh and then Kept.Received < Scan_Count'Last
            then Kept.Received + 1 else Kept.Received)))
   with Global => null;

   type Action is (Begin_Another_Scan, Hand_On_Image, Wait_For_Scan);

   --  Up to Most scans follow one another, while the tick lasts.
   function Next_Action
     (Kept       : Progress;
      Fresh      : Boolean;
      Look_Again : Boolean;
      Most       : Scan_Count;
      Now        : Clock_Tick) return Action
   is
     (if Fresh
        and then Kept.Received < Most
        and then not Is_Over (Kept.Timeout, Now)
      then Begin_Another_Scan
      elsif Look_Again then Wait_For_Scan
      else Hand_On_Image)
   with Global => null;

   --  The newest scan of the frame, marked with an error when there was none.
   function Newest_Image (Item : Channel_Words; Kept : Progress)
                          return AD_Image
   is (Stamped (Item, Fresh => Kept.Received > 0))
   with Global => null;

   --  The progress after the chosen action.
   function After (Kept : Progress; Chosen : Action) return Progress is
     (if Chosen /= Hand_On_Image then Kept
      else
        (Kept with delta
           Doing =>
             (if Kept.Received > 0 then Had_Scan else Had_No_Scan)))
   with Global => null;

end URV.AD_Steps;
