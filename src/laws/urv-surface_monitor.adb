--  SPDX-License-Identifier: Apache-2.0

package body URV.Surface_Monitor with SPARK_Mode is

   procedure Advance (This : in out Monitor; Sensors : Downlink_Buffer) is
      Is_New : constant Boolean := not Is_Old (Sensors);
      Place  : Demand;
      Doubt  : Doubt_Level;
   begin
      for Which in Surface loop
         pragma Assert
           (Words_Of (This, Which) = Words_Of (This'Loop_Entry, Which)
            and then This.Ranges (Which) = This.Ranges'Loop_Entry (Which)
            and then
              Bounds_After (This, Which) =
                Bounds_After (This'Loop_Entry, Which));
         This.Ranges (Which) := Bounds_After (This, Which);
         pragma Assert
           (for all Done in Surface'First .. Which =>
              This.Ranges (Done) = Bounds_After (This'Loop_Entry, Done));
         if Is_New then
            Place := Demand_Of (Sensors (Sensor_Of (Which)));
            Doubt := Next_Doubt
              (This.Doubts (Which), Off (Which, This.Ranges (Which), Place));
            if Doubt = Certainty and then This.Doubts (Which) < Certainty then
               This.Failed (Which) := True;
            end if;
            This.Doubts (Which) := Doubt;
            This.Places (Which) := Place;
         end if;
         pragma Assert
           (This.Places (Which) =
              (if Is_Old (Sensors) then This.Places'Loop_Entry (Which)
               else Places_Of (Sensors) (Which)));

         pragma Loop_Invariant
           (This.Unknown = This.Unknown'Loop_Entry
            and then This.Sent = This.Sent'Loop_Entry
            and then This.Sent_Before = This.Sent_Before'Loop_Entry
            and then This.Sent_First = This.Sent_First'Loop_Entry
            and then This.Engine = This.Engine'Loop_Entry
            and then This.Power = This.Power'Loop_Entry);
         pragma Loop_Invariant
           (for all Done in Surface'First .. Which =>
              This.Ranges (Done) = Bounds_After (This'Loop_Entry, Done)
              and then
                (if This.Failed'Loop_Entry (Done) then This.Failed (Done))
              and then
                This.Places (Done) =
                  (if Is_Old (Sensors) then This.Places'Loop_Entry (Done)
                   else Places_Of (Sensors) (Done))
              and then
                (if This.Failed (Done)
                   and then not This.Failed'Loop_Entry (Done)
                 then not Is_Old (Sensors)
                   and then
                     Off_Now (This'Loop_Entry, Sensors, Done) > Allowance
                   and then This.Doubts'Loop_Entry (Done) >=
                              Certainty - (Most_Off - Allowance))
              and then
                (if Is_Old (Sensors)
                 then This.Doubts (Done) = This.Doubts'Loop_Entry (Done)
                 else This.Doubts (Done) =
                     Next_Doubt
                       (This.Doubts'Loop_Entry (Done),
                        Off_Now (This'Loop_Entry, Sensors, Done))
                   and then
                     (if This.Doubts (Done) = Certainty
                        and then This.Doubts'Loop_Entry (Done) < Certainty
                      then This.Failed (Done))));
         pragma Loop_Invariant
           (for all Later in Surface =>
              (if Later > Which
               then This.Ranges (Later) = This.Ranges'Loop_Entry (Later)
                 and then This.Failed (Later) = This.Failed'Loop_Entry (Later)
                 and then This.Places (Later) = This.Places'Loop_Entry (Later)
                 and then
                   This.Doubts (Later) = This.Doubts'Loop_Entry (Later)));
      end loop;
   end Advance;

   function Next (This : Monitor; Sensors : Downlink_Buffer) return Monitor
   is
   begin
      return After : Monitor := This do
         Advance (After, Sensors);
      end return;
   end Next;

   procedure Note_Sent (This : in out Monitor; Sent : Surface_Demands) is
   begin
      This.Sent_First := This.Sent_Before;
      This.Sent_Before := This.Sent;
      This.Sent := Sent;
      This.Unknown := Integer'Max (This.Unknown - 1, 0);
   end Note_Sent;

   procedure Note_None_Sent (This : in out Monitor) is
   begin
      This.Sent_First := This.Sent_Before;
      This.Sent_Before := This.Sent;
   end Note_None_Sent;

end URV.Surface_Monitor;
