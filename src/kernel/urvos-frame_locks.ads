--  SPDX-License-Identifier: Apache-2.0

--  Keeps a node's frames in step with those of the node from which it receives
--  (FRM-6).
--
--  At each tick the caller says whether a message waits to be taken. A message
--  came on time if it has waited one tick when it is taken, that is, one to
--  two ticks. A later message risks being missed; an earlier one is older than
--  necessary. After four fresh messages in a row off time, the frame in which
--  the fourth was taken becomes a tick longer or shorter. A frame without a
--  fresh message changes nothing and has the usual length.

with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frames;       use URVOS.Frames;

package URVOS.Frame_Locks with Pure, SPARK_Mode is

   --  The ticks that a message has waited. The last value means 11 or more.
   type Wait_Count is range 0 .. 11;

   --  Fresh messages in a row off time before the frame is corrected.
   Frames_To_Correct : constant := 4;

   type Out_Count is range 0 .. Frames_To_Correct - 1;

   type Lock_State is record
      --  A message waits, and for how many ticks.
      Is_Waiting  : Boolean    := False;
      Waited      : Wait_Count := 0;

      --  The fresh messages off time since the last one on time, or since the
      --  last correction of a frame.
      Out_Of_Step : Out_Count  := 0;

      Request : Frame_Request;

      --  For monitors: fresh messages come on time, or one tick beside it,
      --  since the frame that began with tick Since; and the numbers of frames
      --  shortened and lengthened.
      Is_In_Step  : Boolean    := False;
      Since       : Clock_Tick := 0;
      Shortened   : Count      := 0;
      Lengthened  : Count      := 0;
   end record;

   At_Start : constant Lock_State := (others => <>);

   --  The state after a start: nothing is known of the messages. The request
   --  for the present frame remains.
   function Restarted (This : Lock_State) return Lock_State is
     ((This with delta
         Is_Waiting  => False,
         Waited      => 0,
         Out_Of_Step => 0,
         Is_In_Step  => False))
   with Global => null;

   --  The clock ticks; Available says whether a message waits.
   function Ticked
     (This      : Lock_State;
      Available : Boolean) return Lock_State
   is
     ((This with delta
         Is_Waiting => Available,
         Waited     =>
           (if Available and then This.Is_Waiting
            then Wait_Count'Min (This.Waited, Wait_Count'Last - 1) + 1
            else 0)))
   with Global => null;

   --  The same in place
   procedure Take_Tick (This : in out Lock_State; Available : Boolean)
   with
     Inline,
     Global => null,
     Post   => This = Ticked (This'Old, Available);

   --  The frame length that brings a message with this wait nearer to its
   --  time, the shorter way round.
   function Length_For (Waited : Wait_Count) return Frame_Length is
     (case Waited is
         when 1      => Usual_Length,
         when 2 .. 5 => Frame_Length'First,
         when others => Frame_Length'Last)
   with Global => null;

   --  The frame length requested when a fresh message is taken now.
   function Length_Asked (This : Lock_State) return Frame_Length is
     (if This.Out_Of_Step = Out_Count'Last then Length_For (This.Waited)
      else Usual_Length)
   with Global => null;

   function Next_Out (This : Lock_State) return Out_Count is
     (if Length_For (This.Waited) = Usual_Length
        or else This.Out_Of_Step = Out_Count'Last
      then 0
      else This.Out_Of_Step + 1)
   with Global => null;

   --  The task that takes messages has run in this frame. Fresh says whether
   --  it found a fresh one.
   function Taken
     (This  : Lock_State;
      Fresh : Boolean;
      Frame : Clock_Tick) return Lock_State
   is
     (if not Fresh
      then (This with delta
              Is_Waiting => False,
              Waited     => 0,
              Request    => (Frame, Usual_Length))
      else (This with delta
              Is_Waiting  => False,
              Waited      => 0,
              Request     => (Frame, Length_Asked (This)),
              Out_Of_Step => Next_Out (This),
              Is_In_Step  =>
                This.Waited <= 2
                and then (This.Waited = 1 or else This.Is_In_Step),
              Since       =>
                (if This.Waited = 1 and then not This.Is_In_Step
                 then Frame else This.Since),
              Shortened   =>
                (if Length_Asked (This) < Usual_Length
                 then Incremented (This.Shortened) else This.Shortened),
              Lengthened  =>
                (if Length_Asked (This) > Usual_Length
                 then Incremented (This.Lengthened) else This.Lengthened)))
   with Global => null;

end URVOS.Frame_Locks;
