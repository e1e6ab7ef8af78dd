--  SPDX-License-Identifier: Apache-2.0

with URVOS; use URVOS;
with URV.CORE_Layout;

package body URV.Log_Senders with SPARK_Mode is

   procedure Next (Item : out Piece) is
      Log  : constant Error_Log := Errors.Contents;
      Line : Outgoing           := Progress.Contents;
   begin
      --  The next kind that has happened, round the list: after a row, and
      --  when the log was cleared.
      if Line.Sent = Place'Last
        or else Logs.History_Of (Log, Line.Kind).Occurrences = 0
      then
         for Step in Error_Kind loop
            Line.Kind :=
              (if Line.Kind = Error_Kind'Last then Error_Kind'First
               else Error_Kind'Succ (Line.Kind));
            exit when Logs.History_Of (Log, Line.Kind).Occurrences > 0;
         end loop;
         Line.Row := CORE_Layout.To_Row (Logs.History_Of (Log, Line.Kind));
         Line.Sent := 0;
      end if;

      if Logs.Total (Log) = 0 or else Line.Sent = Place'Last then
         Item := No_Piece;
      else
         Line.Sent := Line.Sent + 1;
         Item :=
           Piece_At (CORE_Layout.Row_Of (Line.Kind), Line.Row, Line.Sent);
      end if;
      Progress.Write (Line);
   end Next;

end URV.Log_Senders;
