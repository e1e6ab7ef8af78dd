--  SPDX-License-Identifier: Apache-2.0

package body URV.Surface_Monitor with SPARK_Mode is

   function Next (This : Monitor; Sensors : Downlink_Buffer) return Monitor
   is
      Measured : constant Surface_Demands := Places_Of (Sensors);
      After    : Monitor := This;
   begin
      for Which in Surface loop
         After.Ranges (Which) := Bounds_After (This, Which);

         if not Is_Old (Sensors) then
            After.Places (Which) := Measured (Which);
            After.Doubts (Which) := Next_Doubt
              (This.Doubts (Which),
               Off (Which, After.Ranges (Which), Measured (Which)));
            After.Failed (Which) :=
              This.Failed (Which)
              or else (After.Doubts (Which) = Certainty
                       and then This.Doubts (Which) < Certainty);
         end if;

         pragma Loop_Invariant
           (After.Unknown = This.Unknown
            and then After.Sent = This.Sent
            and then After.Sent_Before = This.Sent_Before
            and then After.Sent_First = This.Sent_First);
         pragma Loop_Invariant
           (for all Done in Surface'First .. Which =>
              After.Ranges (Done) = Bounds_After (This, Done)
              and then
                (if This.Failed (Done) then After.Failed (Done))
              and then
                After.Places (Done) =
                  (if Is_Old (Sensors) then This.Places (Done)
                   else Places_Of (Sensors) (Done))
              and then
                (if After.Failed (Done) and then not This.Failed (Done)
                 then not Is_Old (Sensors)
                   and then Off_Now (This, Sensors, Done) > Allowance
                   and then This.Doubts (Done) >=
                              Certainty - (Most_Off - Allowance))
              and then
                (if Is_Old (Sensors)
                 then After.Doubts (Done) = This.Doubts (Done)
                 else After.Doubts (Done) =
                     Next_Doubt
                       (This.Doubts (Done), Off_Now (This, Sensors, Done))
                   and then
                     (if After.Doubts (Done) = Certainty
                        and then This.Doubts (Done) < Certainty
                      then After.Failed (Done))));
         pragma Loop_Invariant
           (for all Later in Surface =>
              (if Later > Which
               then After.Failed (Later) = This.Failed (Later)
                 and then After.Places (Later) = This.Places (Later)
                 and then After.Doubts (Later) = This.Doubts (Later)));
      end loop;
      return After;
   end Next;

end URV.Surface_Monitor;
