--  SPDX-License-Identifier: Apache-2.0

--  Keeps a node's frames in step with those of the node that it hears
--  (FRM-6).
--
--  Each tick tells whether a message waits to be taken. A message that has
--  waited for one tick when it is taken came where it should: between one and
--  two ticks before. One that came later must not become late, one that came
--  earlier is older than it need be: when so many fresh messages after each
--  other did, the frame in which the last of them was taken is made a tick
--  longer or shorter. A frame without a fresh message tells nothing, and
--  lasts as long as ever.

with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frames;       use URVOS.Frames;

package URVOS.Frame_Locks with Pure, SPARK_Mode is

   --  Ticks that a message has waited for; the last stands for more.
   type Wait_Count is range 0 .. 11;

   --  So many messages that do not come where they should, and the frame is
   --  changed.
   Patience : constant := 4;

   type Out_Count is range 0 .. Patience - 1;

   type Lock_State is record
      --  A message waits, and since when.
      Is_Waiting  : Boolean    := False;
      Waited      : Wait_Count := 0;

      --  The fresh messages since the last one that came where it should, or
      --  since a frame was changed.
      Out_Of_Step : Out_Count  := 0;

      Request : Frame_Request;

      --  For who watches: messages come where they should, or at the tick
      --  beside, since the frame that began with this tick; and how many
      --  frames were changed.
      Is_In_Step  : Boolean    := False;
      Since       : Clock_Tick := 0;
      Shortened   : Count      := 0;
      Lengthened  : Count      := 0;
   end record;

   At_Start : constant Lock_State := (others => <>);

   --  Nothing is known of the messages. Frames stay as they were to be.
   function Restarted (This : Lock_State) return Lock_State is
     ((This with delta
         Is_Waiting  => False,
         Waited      => 0,
         Out_Of_Step => 0,
         Is_In_Step  => False))
   with Global => null;

   --  The clock ticks, and there is a message to be taken, or none.
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

   --  The length that brings a message that has waited so long nearer: the
   --  shorter way round.
   function Length_For (Waited : Wait_Count) return Frame_Length is
     (case Waited is
         when 1      => Usual_Length,
         when 2 .. 5 => Frame_Length'First,
         when others => Frame_Length'Last)
   with Global => null;

   --  A message is taken now, and is fresh: how long the frame is to last.
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

   --  The task that takes messages has run in this frame, and found a fresh
   --  one or none.
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
