--  SPDX-License-Identifier: Apache-2.0

with URV.Recorder_Blocks; use URV.Recorder_Blocks;
with URV.Recorder_Rings;  use URV.Recorder_Rings;
with URV.Recorder_Rows;   use URV.Recorder_Rows;

package body URV.Recorder_Senders with SPARK_Mode is

   procedure Restart is
   begin
      Progress.Write ((others => <>));
   end Restart;

   procedure Next
     (Sensors : Downlink_Buffer;
      Block   : out Downlink_Buffer;
      Is_Sent : out Boolean)
   is
      On_Ground : constant Boolean := Is_On_Ground (Sensors);
      Kept      : constant Ring    := Recorder.Contents;
      Sending   : Line             := Progress.Contents;
      Item      : Uplink_Buffer;
      Is_New    : Boolean;
      Next_Row  : Row;
   begin
      Requests.Look (Item, Is_New);
      if Is_New and then Is_Whole (Item) then
         Sending := Asked (Request_Of (Item), Kept, On_Ground);
         if Sending.Reply /= Flies then
            Recorder.Stop;
         end if;
      end if;

      Block := Sensors;
      Is_Sent := Has_Block (Sending, Kept, On_Ground);
      if Is_Sent then
         if Sending.Now = Report then
            Block := Report_Of (Sending.Reply, Kept);
         else
            Next_Row := Recorder.Row_At (Sending.Next);
            Block := Block_Of (Next_Row, Sending.Which);
         end if;
      end if;
      Progress.Write (After (Sending, Kept, On_Ground));
   end Next;

end URV.Recorder_Senders;
