--  SPDX-License-Identifier: Apache-2.0

with URVOS; use URVOS;
with URVOS.Frames; use URVOS.Frames;
with URV.CORE_Layout;
with URV.LAW_Steps;
with URV.Law_Status;
with URV.Laws;
with URV.Surface_Monitor;

package body URV.Log_Senders with SPARK_Mode is

   --  Selects the next kind that has occurred, round the list.
   procedure Go_On (Line : in out Outgoing; Log : Error_Log)
   with Global => null;

   procedure Go_On (Line : in out Outgoing; Log : Error_Log) is
   begin
      for Step in Error_Kind loop
         Line.Kind :=
           (if Line.Kind = Error_Kind'Last then Error_Kind'First
            else Error_Kind'Succ (Line.Kind));
         exit when Logs.History_Of (Log, Line.Kind).Occurrences > 0;
      end loop;
      Line.Row := CORE_Layout.To_Row (Logs.History_Of (Log, Line.Kind));
      Line.Is_Laws := False;
      Line.Sent := 0;
   end Go_On;

   procedure Next (Item : out Piece) is
      Log      : constant Error_Log         := Errors.Contents;
      Set      : constant URV.Laws.Settings := Law_Settings.Contents;
      Kept     : constant URV.LAW_Steps.Kept := Law_Memory.Contents;
      Time     : constant Clock_Tick        := Errors.Time;
      Is_Empty : constant Boolean           := Logs.Total (Log) = 0;
      Line     : Outgoing                   := Progress.Contents;
   begin
      --  The laws' row follows each row, and is sent when the log is empty.
      if Set.On
        and then not Line.Is_Laws
        and then (Is_Empty or else Line.Sent = Place'Last)
      then
         Line.Row := Law_Status.With_Age
           (Law_Status.To_Row
              (Kept.Flown, Surface_Monitor.Failed_Bits (Kept.Watched),
               Kept.Set),
            Time);
         Line.Is_Laws := True;
         Line.Sent := 0;
      elsif Line.Sent = Place'Last
        or else
          (not Line.Is_Laws
           and then Logs.History_Of (Log, Line.Kind).Occurrences = 0)
      then
         Go_On (Line, Log);
      end if;

      if (Is_Empty and then not Line.Is_Laws)
        or else Line.Sent = Place'Last
      then
         Item := No_Piece;
      else
         Line.Sent := Line.Sent + 1;
         Item :=
           Piece_At
             ((if Line.Is_Laws then Law_Status.Row_Number
               else CORE_Layout.Row_Of (Line.Kind)),
              Line.Row, Line.Sent);
      end if;
      Progress.Write (Line);
   end Next;

end URV.Log_Senders;
