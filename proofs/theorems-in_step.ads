--  SPDX-License-Identifier: Apache-2.0

--  The aircraft's frames come in step with the ground's from any phase and
--  stay in step, while both clocks are within 200 ppm and at least one uplink
--  in 25 frames arrives (FRM-6). Whatever the lock requests, a frame has 9, 10
--  or 11 ticks, and no release is skipped or repeated. Longer gaps between
--  uplinks are outside this theorem.
--
--  The model of the phase: times are microseconds of the aircraft's clock.
--  Before is the time from an uplink's arrival to the TELIN that takes it; if
--  several arrive, the newest counts. 200 ppm of a frame of 20,000 us are 4
--  us.

with URVOS;              use URVOS;
with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frame_Locks;  use URVOS.Frame_Locks;
with URVOS.Frames;       use URVOS.Frames;

package Theorems.In_Step with Pure, SPARK_Mode, Ghost is

   --  The clock

   --  The clock never runs back. It skips at most a last minor frame, in which
   --  no task is released (Theorems.Order).
   procedure The_Clock_Keeps_Its_Order
     (Clock   : Frame_Clock;
      Request : Frame_Request)
   with
     Global => null,
     Post   =>
       Ticked (Clock, Request).Now in Clock.Now .. Clock.Now + 2
       and then
         (if Ticked (Clock, Request).Now = Clock.Now and then not Clock.Held
            and then Clock.Now < Last_Tick
          then Minor_Frame_Of (Clock.Now) = Minor_Frame'Last
            and then Ticked (Clock, Request).Held)
       and then
         (if Ticked (Clock, Request).Now = Clock.Now + 2
          then Minor_Frame_Of (Clock.Now + 1) = Minor_Frame'Last);

   --  The request at each tick of a frame.
   type Tick_Count is range 0 .. 11;
   type Request_List is array (Tick_Count range 1 .. 11) of Frame_Request;

   --  The clock this number of ticks after a frame began.
   function After
     (Start    : Clock_Tick;
      Requests : Request_List;
      Ticks    : Tick_Count) return Frame_Clock
   is
     (if Ticks = 0 then (Start, Held => False)
      else Ticked (After (Start, Requests, Ticks - 1), Requests (Ticks)))
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Ticks);

   --  A frame lasts 9 to 11 ticks, whatever is requested and however requests
   --  change.
   procedure A_Frame_Lasts_9_To_11_Ticks
     (Start    : Clock_Tick;
      Requests : Request_List)
   with
     Global => null,
     Pre    => Start mod Ticks_Per_Major_Frame = 0
       and then Start <= Last_Tick - 20,
     Post   =>
       (for all Ticks in Tick_Count range 0 .. 8 =>
          After (Start, Requests, Ticks) = (Start + Tick (Ticks), False))
       and then After (Start, Requests, 9).Now in Start + 9 .. Start + 10
       and then
         (if After (Start, Requests, 9).Now = Start + 9
          then After (Start, Requests, 10).Now in Start + 9 .. Start + 10
            and then
              (if After (Start, Requests, 10).Now = Start + 9
               then After (Start, Requests, 11).Now = Start + 10));

   --  A clock without a request for its frame.
   procedure No_Request_No_Change (Clock : Frame_Clock)
   with
     Global => null,
     Pre    => not Clock.Held
       and then Frame_Of (Clock.Now) /= No_Request.Frame,
     Post   =>
       Ticked (Clock, No_Request) = (Advanced (Clock.Now), Held => False);

   --  Without an uplink nothing is requested. A request is for the frame in
   --  which an uplink was taken

   procedure Without_Uplink_No_Request (Item : Lock_State; Frame : Clock_Tick)
   with
     Global => null,
     Post   => Taken (Item, False, Frame).Request.Length = Usual_Length;

   procedure A_Request_Is_For_One_Frame
     (Item       : Lock_State;
      Fresh      : Boolean;
      Frame, Now : Clock_Tick)
   with
     Global => null,
     Pre    => Frame_Of (Now) /= Frame,
     Post   =>
       Length_Of (Now, Taken (Item, Fresh, Frame).Request) = Usual_Length;

   --  The phase

   Tick_Time  : constant := Microseconds_Per_Tick;
   Frame_Time : constant := Microseconds_Per_Tick * Ticks_Per_Major_Frame;

   --  The time from the uplink's arrival to TELIN.
   subtype Phase is Integer range 0 .. Frame_Time - 1;

   --  The largest drift between two uplinks that are taken at most 25 frames
   --  apart: 200 ppm of these frames, rounded up.
   Most_Drift : constant := 25 * 4 + 1;
   subtype Drift is Integer range -Most_Drift .. Most_Drift;

   type Situation is record
      Before : Phase;
      Out_Of : Out_Count;
   end record;

   --  The lock's state when it takes the uplink.
   function Found (Item : Situation) return Lock_State is
     ((Is_Waiting  => True,
       Waited      => Wait_Count (Item.Before / Tick_Time),
       Out_Of_Step => Item.Out_Of,
       others      => <>))
   with Global => null;

   function In_Frame (Distance : Integer) return Phase is
     (if Distance < 0 then Distance + Frame_Time
      elsif Distance >= Frame_Time then Distance - Frame_Time
      else Distance)
   with
     Global => null,
     Pre    => Distance in -Frame_Time .. 2 * Frame_Time - 1;

   --  The situation at the next uplink that is taken.
   function Next (Item : Situation; Apart : Drift) return Situation is
     (Before =>
        In_Frame
          (Item.Before + Apart
           + (Integer (Length_Asked (Found (Item)))
              - Ticks_Per_Major_Frame) * Tick_Time),
      Out_Of => Next_Out (Found (Item)))
   with Global => null;

   --  In step: the uplink comes one to two ticks before TELIN, or beside this
   --  by the drift before the lock answers.
   function Is_In_Step (Item : Situation) return Boolean is
     (Item.Before in
        Tick_Time - Most_Drift * (Integer (Item.Out_Of) + 1) ..
          2 * Tick_Time - 1 + Most_Drift * (Integer (Item.Out_Of) + 1))
   with Global => null;

   --  An uplink in step therefore comes 1.59 to 4.41 ms before TELIN.
   procedure In_Step_Is_In_Time (Item : Situation)
   with
     Global => null,
     Pre    => Is_In_Step (Item),
     Post   => Item.Before in 1_596 .. 4_403;

   procedure It_Stays_In_Step (Item : Situation; Apart : Drift)
   with
     Global => null,
     Pre    => Is_In_Step (Item),
     Post   => Is_In_Step (Next (Item, Apart));

   --  40 uplinks, 25 frames apart: 1,000 frames, 20 s.
   Uplinks : constant := 40;
   type Uplink_Count is range 0 .. Uplinks;
   type Drift_List is array (Uplink_Count range 1 .. Uplinks) of Drift;

   --  From any phase, 40 uplinks bring the frames in step.
   procedure Hear_Uplinks (Item : in out Situation; Drifts : Drift_List)
   with
     Global => null,
     Post   => Is_In_Step (Item);

end Theorems.In_Step;
