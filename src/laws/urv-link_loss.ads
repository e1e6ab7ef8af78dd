--  SPDX-License-Identifier: Apache-2.0

--  The aircraft's reaction to a lost link, as a state machine (EXT-5).
--
--      Waiting --fresh--> Linked --0.5 s--> Holding --5 s--> Orbiting
--                           ^                  |                | 120 s
--                           +---fresh count----+----------------+
--                           |                                   v
--                           +------the ground's order---- Terminated
--
--  A frame is silent if it has brought no fresh uplink. After the link is
--  lost, silent frames are counted until it is back.
--
--  A lost link returns on a proportion of fresh frames (D-35). Each fresh
--  frame adds 1 to a count; each silent frame takes 2 from it, not below 0. At
--  50 the link is back: after 50 fresh frames in a row, or after any n frames
--  with at most (n - 50) / 3 silent ones. A link that loses a third of its
--  frames or more does not return. A gap that would lose a link, 25 silent
--  frames, always clears the count.
--
--  Only an order that no fault imitates ends Terminated: fresh uplinks with
--  the disconnect switch off up to a count of 50, then with the switch on up
--  to a second count of 50.

with URV.Law_Gains; use URV.Law_Gains;

package URV.Link_Loss with Pure, SPARK_Mode is

   type Link_State is
     (Waiting,      --  nothing was received yet; no law flies
      Linked,       --  the pilot flies
      Holding,      --  wings level, altitude and airspeed held
      Orbiting,     --  the same in a standard-rate turn
      Terminated);  --  throttle idle, wings level, a glide

   subtype Lost is Link_State range Holding .. Terminated;

   Longest : constant := 1_000_000;
   type Frame_Count is range 0 .. Longest;
   subtype Return_Count is Frame_Count range 0 .. Return_After;

   --  The numbers of silent frames that lead to each state. No state is
   --  skipped.
   type Times is record
      Hold      : Frame_Count := Hold_After;
      Orbit     : Frame_Count := Orbit_After;
      Terminate_At : Frame_Count := Terminate_After;
   end record
   with Predicate =>
     Times.Hold >= 1
     and then Times.Orbit > Times.Hold
     and then Times.Terminate_At > Times.Orbit;

   type Link_Memory is record
      State  : Link_State   := Waiting;

      --  Silent frames: in a row while linked, all since the loss while lost.
      Silent : Frame_Count  := 0;

      --  The count for the link's return while it is lost; the counts of the
      --  order's first and second half while terminated.
      Fresh  : Return_Count := 0;
      Off    : Return_Count := 0;
      On     : Return_Count := 0;
   end record;

   --  A count of frames stops at its last value.
   function More (Item : Frame_Count) return Frame_Count is
     (if Item = Frame_Count'Last then Item else Item + 1)
   with Global => null;

   function More_Of_Return (Item : Return_Count) return Return_Count is
     (if Item = Return_Count'Last then Item else Item + 1)
   with Global => null;

   --  A silent frame removes the count of two fresh ones.
   function Less_Of_Return (Item : Return_Count) return Return_Count is
     (if Item > Silence_Cost then Item - Silence_Cost else 0)
   with Global => null;

   Linked_Again : constant Link_Memory :=
     (State => Linked, Silent => 0, Fresh => 0, Off => 0, On => 0);

   --  A frame without a fresh uplink.
   function After_Silence
     (This : Link_Memory; By : Times) return Link_Memory
   is
     (State  =>
        (case This.State is
            when Waiting    => Waiting,
            when Linked     =>
              (if More (This.Silent) >= By.Hold then Holding else Linked),
            when Holding    =>
              (if More (This.Silent) >= By.Orbit
               then Orbiting else Holding),
            when Orbiting   =>
              (if More (This.Silent) >= By.Terminate_At
               then Terminated else Orbiting),
            when Terminated => Terminated),
      Silent => (if This.State = Waiting then 0 else More (This.Silent)),
      Fresh  =>
        (if This.State in Holding | Orbiting
         then Less_Of_Return (This.Fresh) else 0),

      --  A silent frame reduces the count of the order's present half.
      Off    =>
        (if This.State /= Terminated then 0
         elsif This.On > 0 then This.Off
         else Less_Of_Return (This.Off)),
      On     =>
        (if This.State = Terminated then Less_Of_Return (This.On) else 0))
   with Global => null;

   --  The ground's order is complete with this frame.
   function Is_Ordered
     (This : Link_Memory; Disconnect : Boolean) return Boolean
   is
     (Disconnect
      and then This.Off = Return_After
      and then This.On >= Return_After - 1)
   with Global => null;

   --  A frame with a fresh uplink, and the state of its disconnect switch.
   function After_Uplink
     (This : Link_Memory; Disconnect : Boolean) return Link_Memory
   is
     (case This.State is
         when Waiting | Linked     => Linked_Again,
         when Holding | Orbiting   =>
           (if This.Fresh >= Return_After - 1
            then Linked_Again
            else (This with delta Fresh => This.Fresh + 1)),
         when Terminated           =>
           (if Is_Ordered (This, Disconnect)
            then Linked_Again
            elsif not Disconnect
            then (This with delta
                    On  => 0,
                    Off =>
                      (if This.On > 0 then 1
                       else More_Of_Return (This.Off)))
            elsif This.Off = Return_After
            then (This with delta On => More_Of_Return (This.On))
            else (This with delta On => 0, Off => 0)))
   with Global => null;

   function Next
     (This       : Link_Memory;
      Is_Fresh   : Boolean;
      Disconnect : Boolean;
      By         : Times) return Link_Memory
   is
     (if Is_Fresh then After_Uplink (This, Disconnect)
      else After_Silence (This, By))
   with
     Global => null,
     Post   =>

       --  No state is skipped.
       (if Next'Result.State /= This.State
        then (case Next'Result.State is
                 when Waiting    => False,
                 when Linked     => Is_Fresh,
                 when Holding    => This.State = Linked,
                 when Orbiting   => This.State = Holding,
                 when Terminated => This.State = Orbiting))

       --  After a loss the count begins at 0. Only a full count returns the
       --  link.
       and then
         (if This.State = Linked and then Next'Result.State = Holding
          then Next'Result.Fresh = 0)
       and then
         (if This.State in Holding | Orbiting
            and then Next'Result.State = Linked
          then This.Fresh >= Return_After - 1)

       --  A returned link has the same state as one that was never lost.
       and then
         (if This.State /= Linked and then Next'Result.State = Linked
          then Next'Result = Linked_Again)

       --  Only the ground's order ends termination.
       and then
         (if This.State = Terminated and then Next'Result.State /= Terminated
          then Is_Fresh and then Is_Ordered (This, Disconnect));

end URV.Link_Loss;
