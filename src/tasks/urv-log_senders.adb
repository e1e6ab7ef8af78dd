--  SPDX-License-Identifier: Apache-2.0

with URVOS;           use URVOS;
with URVOS.Frames;    use URVOS.Frames;
with URV.Card_Status;
with URV.CORE_Memory; use URV.CORE_Memory;
with URV.Errors;      use URV.Errors;
with URV.LAW_Steps;
with URV.Law_Status;
with URV.Laws;
with URV.Surface_Monitor;

package body URV.Log_Senders with SPARK_Mode is

   --  The row of the laws or of the test cards.
   procedure Get_Laws_Row
     (Line : Outgoing; Row : out Log_Row; Has_Cards : out Boolean)
   with Global => (Input => (Law_Memory, Errors));

   procedure Get_Laws_Row
     (Line : Outgoing; Row : out Log_Row; Has_Cards : out Boolean)
   is
      Kept : constant URV.LAW_Steps.Kept := Law_Memory.Contents;
      Time : constant Clock_Tick         := Errors.Time;
   begin
      Has_Cards := Card_Status.Has_Cards (Kept.Cards);
      Row :=
        (if Cards_Are_Next (Line, Has_Cards)
         then Card_Status.To_Row
           (Card_Status.Report_Of (Kept.Cards, Line.Part))
         else Law_Status.To_Row
           (Law_Status.With_Age
              (Law_Status.Report_Of
                 (Kept.Flown, Surface_Monitor.Failed_Bits (Kept.Watched),
                  Kept.Set),
               Time)));
   end Get_Laws_Row;

   procedure Next (Item : out Piece) is
      All_Errors : constant Logs.Summary      := Errors.Summary;
      Is_Empty   : constant Boolean           := All_Errors.Total = 0;
      Set        : constant URV.Laws.Settings := Law_Settings.Contents;
      Line       : Outgoing                   := Progress.Contents;
      History    : Logs.History               := Errors.History_Of (Line.Kind);
      Kind       : Error_Kind;
      Laws_Row   : Log_Row;
      Has_Cards  : Boolean;
   begin
      if Laws_Are_Next (Line, Is_Empty, Set.On) then
         Get_Laws_Row (Line, Laws_Row, Has_Cards);
         Line := With_Laws (Line, Has_Cards, Laws_Row);
      elsif Is_Over (Line, History) then
         Kind := Errors.Next_Occurred (Line.Kind);
         History := Errors.History_Of (Kind);
         Line := With_Kind (Line, Kind, History);
      end if;
      Item := Next_Piece (Line, Is_Empty);
      Progress.Write (After (Line, Is_Empty));
   end Next;

   procedure Restart is
   begin
      Progress.Write ((others => <>));
   end Restart;

end URV.Log_Senders;
