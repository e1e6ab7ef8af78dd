--  SPDX-License-Identifier: Apache-2.0

with URVOS.Frames;    use URVOS.Frames;
with URV.CORE_Memory; use URV.CORE_Memory;
with URV.Errors;      use URV.Errors;
with URV.LAW_Steps;
with URV.Law_Status;
with URV.Laws;
with URV.Surface_Monitor;

package body URV.Log_Senders with SPARK_Mode is

   procedure Get_Laws_Row (Row : out Log_Row)
   with Global => (Input => (Law_Memory, Errors));

   procedure Get_Laws_Row (Row : out Log_Row) is
      Kept : constant URV.LAW_Steps.Kept := Law_Memory.Contents;
      Time : constant Clock_Tick         := Errors.Time;
   begin
      Row := Law_Status.With_Age
        (Law_Status.To_Row
           (Kept.Flown, Surface_Monitor.Failed_Bits (Kept.Watched), Kept.Set),
         Time);
   end Get_Laws_Row;

   procedure Next (Item : out Piece) is
      Log      : constant Error_Log         := Errors.Contents;
      Set      : constant URV.Laws.Settings := Law_Settings.Contents;
      Line     : Outgoing                   := Progress.Contents;
      Laws_Row : Log_Row                    := No_Errors;
   begin
      if Laws_Are_Next (Line, Log, Set.On) then
         Get_Laws_Row (Laws_Row);
      end if;
      Line := Selected (Line, Log, Set.On, Laws_Row);
      Item := Next_Piece (Line, Log);
      Progress.Write (After (Line, Log));
   end Next;

end URV.Log_Senders;
