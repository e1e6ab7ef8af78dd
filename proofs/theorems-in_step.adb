--  SPDX-License-Identifier: Apache-2.0

package body Theorems.In_Step with SPARK_Mode is

   --  The distance from being in step, the shorter way round, reduced for each
   --  counted uplink, in quarters of microseconds. Each uplink taken reduces
   --  it by Step.

   Step      : constant := 1_375;
   For_Count : constant := 2_000;
   Farthest  : constant := 40_000;

   function Distance (Before : Phase) return Integer is
     (if Before in Tick_Time .. 2 * Tick_Time - 1 then 0
      elsif Before in 2 * Tick_Time .. 6 * Tick_Time - 1
      then 5 * (Before - 2 * Tick_Time + 1)
      elsif Before < Tick_Time then 4 * (Tick_Time - Before)
      else 4 * (Tick_Time + Frame_Time - Before))
   with
     Global => null,
     Post   => Distance'Result in 0 .. Farthest;

   function Rank (Item : Situation) return Integer is
     (Distance (Item.Before) - For_Count * Integer (Item.Out_Of))
   with
     Global => null,
     Post   => Rank'Result in -3 * For_Count .. Farthest;

   --  An uplink brings the frames nearer, or they are in step.
   procedure It_Comes_Nearer (Item : Situation; Apart : Drift)
   with
     Global => null,
     Pre    => not Is_In_Step (Item),
     Post   =>
       Is_In_Step (Next (Item, Apart))
       or else Rank (Next (Item, Apart)) <= Rank (Item) - Step;

   --  The same for one uplink after another.
   procedure It_Goes_On
     (Item  : Situation;
      Apart : Drift;
      Bound : Integer)
   with
     Global => null,
     Pre    => Bound in -100_000 .. 100_000
       and then (Is_In_Step (Item) or else Rank (Item) <= Bound),
     Post   =>
       Is_In_Step (Next (Item, Apart))
       or else Rank (Next (Item, Apart)) <= Bound - Step;

   procedure The_Clock_Keeps_Its_Order
     (Clock   : Frame_Clock;
      Request : Frame_Request) is null;

   procedure A_Frame_Lasts_9_To_11_Ticks
     (Start    : Clock_Tick;
      Requests : Request_List) is
   begin
      for Ticks in Tick_Count range 0 .. 8 loop
         pragma Assert
           (After (Start, Requests, Ticks) = (Start + Tick (Ticks), False));
         pragma Loop_Invariant
           (for all Earlier in Tick_Count range 0 .. Ticks =>
              After (Start, Requests, Earlier) =
                (Start + Tick (Earlier), False));
      end loop;
      pragma Assert
        (After (Start, Requests, 9) =
           Ticked (After (Start, Requests, 8), Requests (9)));
      pragma Assert
        (After (Start, Requests, 10) =
           Ticked (After (Start, Requests, 9), Requests (10)));
      pragma Assert
        (After (Start, Requests, 11) =
           Ticked (After (Start, Requests, 10), Requests (11)));
   end A_Frame_Lasts_9_To_11_Ticks;

   procedure No_Request_No_Change (Clock : Frame_Clock) is null;

   procedure Without_Uplink_No_Request (Item : Lock_State; Frame : Clock_Tick)
   is null;

   procedure A_Request_Is_For_One_Frame
     (Item       : Lock_State;
      Fresh      : Boolean;
      Frame, Now : Clock_Tick) is null;

   procedure In_Step_Is_In_Time (Item : Situation) is null;

   procedure It_Stays_In_Step (Item : Situation; Apart : Drift) is
   begin
      pragma Assert
        (Found (Item).Waited =
           (if Item.Before < Tick_Time then 0
            elsif Item.Before < 2 * Tick_Time then 1
            else 2));
      pragma Assert
        (Next (Item, Apart).Out_Of = Next_Out (Found (Item)));
   end It_Stays_In_Step;

   procedure It_Comes_Nearer (Item : Situation; Apart : Drift) is
   begin
      pragma Assert
        (Length_For (Found (Item).Waited) =
           (if Item.Before in Tick_Time .. 2 * Tick_Time - 1 then 10
            elsif Item.Before in 2 * Tick_Time .. 6 * Tick_Time - 1 then 9
            else 11));
      pragma Assert
        (Next (Item, Apart).Out_Of = Next_Out (Found (Item)));
   end It_Comes_Nearer;

   procedure It_Goes_On
     (Item  : Situation;
      Apart : Drift;
      Bound : Integer) is
   begin
      pragma Assert (Is_In_Step (Item) or else Rank (Item) <= Bound);
      if Is_In_Step (Item) then
         It_Stays_In_Step (Item, Apart);
      else
         It_Comes_Nearer (Item, Apart);
      end if;
   end It_Goes_On;

   procedure Hear_Uplinks (Item : in out Situation; Drifts : Drift_List) is
   begin
      for Number in Drifts'Range loop
         It_Goes_On
           (Item, Drifts (Number), Farthest - Step * (Integer (Number) - 1));
         Item := Next (Item, Drifts (Number));
         pragma Loop_Invariant
           (Is_In_Step (Item)
            or else Rank (Item) <= Farthest - Step * Integer (Number));
      end loop;
   end Hear_Uplinks;

end Theorems.In_Step;
