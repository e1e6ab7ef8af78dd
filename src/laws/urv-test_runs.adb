--  SPDX-License-Identifier: Apache-2.0

package body URV.Test_Runs with SPARK_Mode is

   function Next_Loaded (Deck : Card_Deck; From : Slot_Or_None)
                         return Slot_Or_None
   is
      Which : Slot_Or_None := From;
   begin
      for Step in Slot loop
         Which := (if Which = Slot'Last then 1 else Which + 1);
         if Is_Loaded (Deck (Which)) then
            return Which;
         end if;
      end loop;
      return 0;
   end Next_Loaded;

   --  The inputs after a frame with these targets.
   function Moved (Before : Increments; Targets : Increments)
                   return Increments
   with
     Global => null,
     Post   =>
       (for all Which in Test_Surface =>
          abs (Moved'Result (Which) - Before (Which)) <= Rate_Step (Which)
          and then
            abs Moved'Result (Which) <=
              Integer'Max
                (abs Targets (Which),
                 abs Before (Which) - Rate_Step (Which)));

   function Moved (Before : Increments; Targets : Increments)
                   return Increments
   is
     ((for Which in Test_Surface =>
         Stepped (Before (Which), Targets (Which), Rate_Step (Which))));

   --  Ends the running card, or the attempt to start one.
   function Ended (This : Run; Which : Slot_Or_None; Reason : Verdict)
                   return Run
   is
     ((This with delta
         Running  => 0,
         Last_Run => Which,
         Reason   => Reason))
   with Global => null;

   --  The run after a frame, before its inputs.
   function Selected (This : Run; Deck : Card_Deck; Sight : Situation)
                      return Run
   with
     Global => null,
     Post   =>
       Selected'Result.Added = This.Added
       and then Selected'Result.Was_On = This.Was_On
       and then
         (if This.Running = 0 and then not Is_Started (This, Sight)
          then Selected'Result = This)
       and then
         (if This.Added /= Nothing_Added
          then Selected'Result.Place = This.Place)
       and then
         (if Selected'Result.Running > 0
          then Is_Ready (Deck, Selected'Result.Running)
            and then Judged (Deck (Selected'Result.Running), Sight) = Well
            and then Are_Resting (Selected'Result, Sight.Heard)
            and then Selected'Result.Frame <
                       Length_Of (Deck (Selected'Result.Running))
            and then Selected'Result.Place =
                       Place_Of (Deck (Selected'Result.Running))
            and then
              (if This.Running = 0
               then Is_Started (This, Sight)
                 and then Selected'Result.Running = This.Chosen
                 and then Selected'Result.Frame = 0
               else Selected'Result.Running = This.Running
                 and then Selected'Result.Frame = This.Frame + 1
                 and then Selected'Result.Roll_Rest = This.Roll_Rest
                 and then Selected'Result.Pitch_Rest = This.Pitch_Rest
                 and then Selected'Result.Yaw_Rest = This.Yaw_Rest));

   function Started (This : Run; Deck : Card_Deck; Sight : Situation)
                     return Run
   is
     (if not Is_Ready (Deck, This.Chosen)
      then Ended (This, This.Chosen, Not_Loaded)
      elsif Judged (Deck (This.Chosen), Sight) /= Well
      then Ended (This, This.Chosen, Judged (Deck (This.Chosen), Sight))
      elsif This.Added /= Nothing_Added
        and then Place_Of (Deck (This.Chosen)) /= This.Place
      then Ended (This, This.Chosen, Inputs_Remain)
      else
        (This with delta
           Running    => This.Chosen,
           Frame      => 0,
           Phase      => 0,
           Roll_Rest  => Demand_Of (Sight.Heard (Roll)),
           Pitch_Rest => Demand_Of (Sight.Heard (Pitch)),
           Yaw_Rest   => Demand_Of (Sight.Heard (Yaw)),
           Last_Run   => This.Chosen,
           Reason     => Well,
           Place      => Place_Of (Deck (This.Chosen))))
   with Global => null;

   function Selected (This : Run; Deck : Card_Deck; Sight : Situation)
                      return Run
   is
      Which  : constant Slot_Or_None := This.Running;
      Reason : Verdict;
   begin
      if Which = 0 then
         return
           (if Is_Started (This, Sight) then Started (This, Deck, Sight)
            else This);
      elsif not Is_Ready (Deck, Which)
        or else Place_Of (Deck (Which)) /= This.Place
      then
         return Ended (This, Which, Not_Loaded);
      end if;
      Reason := Judged (Deck (Which), Sight);
      if Reason = Well and then not Are_Resting (This, Sight.Heard) then
         Reason := Stick_Moved;
      end if;
      if Reason /= Well then
         return Ended (This, Which, Reason);
      elsif This.Frame >= Length_Of (Deck (Which)) - 1 then
         return
           (Ended (This, Which, Complete) with delta
              Chosen => Next_Loaded (Deck, Which));
      else
         return
           (This with delta
              Frame => This.Frame + 1,
              Phase => Next_Phase (Deck (Which), This.Frame, This.Phase));
      end if;
   end Selected;

   --  The signals of the running card.
   function Targets_Of (This : Run; Deck : Card_Deck) return Increments
   with
     Global => null,
     Pre    =>
       (if This.Running > 0
        then Is_Ready (Deck, This.Running)
          and then This.Frame < Length_Of (Deck (This.Running))),
     Post   =>
       (for all Which in Test_Surface =>
          abs Targets_Of'Result (Which) <= Authority (Deck, This, Which));

   function Targets_Of (This : Run; Deck : Card_Deck) return Increments is
     ((for Which in Test_Surface =>
         (if This.Running > 0
          then Signal (Deck (This.Running), This.Frame, This.Phase, Which)
          else 0)));

   function Next (This : Run; Deck : Card_Deck; Sight : Situation) return Run
   is
      After : Run := Selected (This, Deck, Sight);
   begin
      if Sight.Is_New then
         After.Was_On := Is_On (Sight.Heard (Switch_5));
      end if;
      After.Added :=
        (if Sight.Is_Cut then Nothing_Added
         else Moved (This.Added, Targets_Of (After, Deck)));
      return After;
   end Next;

end URV.Test_Runs;
