--  SPDX-License-Identifier: Apache-2.0

package body URV.Surface_Monitor with SPARK_Mode is

   function Next (This : Monitor; Sensors : Downlink_Buffer) return Monitor
   is
      Measured : constant Surface_Demands := Places_Of (Sensors);
      After    : Monitor := This;
   begin
      for Which in Surface loop
         After.Models (Which) := Model_After (This, Which);

         if not Is_Old (Sensors) then
            After.Places (Which) := Measured (Which);
            if This.Settling > 0 then
               After.Models (Which) := At_Rest (Measured (Which));
            else
               After.Doubts (Which) := Next_Doubt
                 (This.Doubts (Which),
                  Off (After.Models (Which), Measured (Which)));
               After.Failed (Which) :=
                 This.Failed (Which)
                 or else (After.Doubts (Which) = Certainty
                          and then This.Doubts (Which) < Certainty);
            end if;
         end if;

         pragma Loop_Invariant
           (for all Done in Surface'First .. Which =>
              (if This.Failed (Done) then After.Failed (Done))
              and then
                (if After.Failed (Done) and then not This.Failed (Done)
                 then This.Settling = 0
                   and then not Is_Old (Sensors)
                   and then Off (Model_After (This, Done),
                                 Measured (Done)) > Allowance
                   and then This.Doubts (Done) >=
                              Certainty - (Most_Off - Allowance))
              and then
                (if This.Settling = 0 and then not Is_Old (Sensors)
                 then After.Doubts (Done) =
                     Next_Doubt
                       (This.Doubts (Done),
                        Off (Model_After (This, Done), Measured (Done)))
                   and then
                     (if After.Doubts (Done) = Certainty
                        and then This.Doubts (Done) < Certainty
                      then After.Failed (Done))));
         pragma Loop_Invariant
           (for all Later in Surface =>
              (if Later > Which
               then After.Failed (Later) = This.Failed (Later)));
      end loop;

      if not Is_Old (Sensors) and then This.Settling > 0 then
         After.Settling := This.Settling - 1;
      end if;
      return After;
   end Next;

end URV.Surface_Monitor;
