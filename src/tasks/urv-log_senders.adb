with Devices.CORE_Memory; use Devices.CORE_Memory;
with URVOS;               use URVOS;
with URV.CORE_Layout;

package body URV.Log_Senders
  with
    SPARK_Mode,
    Refined_State => (Progress => (Kind, Row, Sent))
is

   --  The row that is on its way, and how many of its pieces have gone.
   Kind : Error_Kind  := Error_Kind'Last;
   Row  : Log_Row     := No_Errors;
   Sent : Place_Count := Place'Last;

   procedure Next (Item : out Piece) is
      Log : Error_Log;
   begin
      Inspect_Log (Log);

      --  The next kind that has happened, round the list: after a row, and
      --  when the log was cleared.
      if Sent = Place'Last
        or else Logs.History_Of (Log, Kind).Occurrences = 0
      then
         for Step in Error_Kind loop
            Kind :=
              (if Kind = Error_Kind'Last then Error_Kind'First
               else Error_Kind'Succ (Kind));
            exit when Logs.History_Of (Log, Kind).Occurrences > 0;
         end loop;
         Row := CORE_Layout.To_Row (Logs.History_Of (Log, Kind));
         Sent := 0;
      end if;

      if Logs.Total (Log) = 0 or else Sent = Place'Last then
         Item := No_Piece;
      else
         Sent := Sent + 1;
         Item := Piece_At (CORE_Layout.Row_Of (Kind), Row, Sent);
      end if;
   end Next;

end URV.Log_Senders;
