--  SPDX-License-Identifier: Apache-2.0

package body URV.Test_Runs with SPARK_Mode is

   function Next_Loaded (Deck : Card_Deck; From : Slot_Or_None)
                         return Slot_Or_None
   is
      Which : Slot_Or_None := From;
   begin
      for Step in Slot loop
         Which := (if Which = Slot'Last then 1 else Which + 1);
         pragma Loop_Invariant
           (Which > 0 and then Between (From, Which) = Number (Step) - 1);
         pragma Loop_Invariant
           (for all Other in Slot =>
              (if Between (From, Other) < Number (Step) - 1
               then not Is_Loaded (Deck (Other))));
         if Is_Loaded (Deck (Which)) then
            return Which;
         end if;
      end loop;
      return 0;
   end Next_Loaded;

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
       and then Is_Selected (This, Selected'Result, Deck, Sight);

   function Selected (This : Run; Deck : Card_Deck; Sight : Situation)
                      return Run
   is
      Reason : Verdict;
   begin
      if This.Running = 0 then
         if not Is_Started (This, Sight) then
            return This;
         end if;
         Reason := Start_Of (This, Deck, Sight);
         if Reason /= Well then
            return Ended (This, This.Chosen, Reason);
         end if;
         return
           (This with delta
              Running    => This.Chosen,
              Frame      => 0,
              Phase      => 0,
              Roll_Rest  => Demand_Of (Sight.Heard (Roll)),
              Pitch_Rest => Demand_Of (Sight.Heard (Pitch)),
              Yaw_Rest   => Demand_Of (Sight.Heard (Yaw)),
              Last_Run   => This.Chosen,
              Reason     => Well,
              Place      => Place_Of (Deck (This.Chosen)));
      end if;
      Reason := End_Of (This, Deck, Sight);
      case Reason is
         when Well =>
            return
              (This with delta
                 Frame => This.Frame + 1,
                 Phase =>
                   Next_Phase (Deck (This.Running), This.Frame, This.Phase));
         when Complete =>
            return
              (Ended (This, This.Running, Complete) with delta
                 Chosen => Next_Loaded (Deck, This.Running));
         when others =>
            return Ended (This, This.Running, Reason);
      end case;
   end Selected;

   function Next (This : Run; Deck : Card_Deck; Sight : Situation) return Run
   is
      After : Run := Selected (This, Deck, Sight);
   begin
      if Sight.Is_New then
         After.Was_On := Is_On (Sight.Heard (Switch_5));
      end if;
      After.Added :=
        (if Sight.Is_Cut then Nothing_Added
         else
           (for Which in Test_Surface =>
              Moved
                (This.Added (Which), Signal_Of (After, Deck, Which), Which)));
      return After;
   end Next;

end URV.Test_Runs;
