--  SPDX-License-Identifier: Apache-2.0

with Telemetry;        use Telemetry;
with URV.Errors;       use URV.Errors;
with URV.Handshakes;   use URV.Handshakes;
with URV.Plain_Blocks; use URV.Plain_Blocks;

package body URV.TELIN_Task with SPARK_Mode is

   procedure Initialise is
   begin
      Previous.Write ((others => <>));
   end Initialise;

   procedure Run_Transaction (Now : Clock_Tick; Is_New : out Boolean) is
      Kept          : Steps.Kept_Message := Previous.Contents;
      Data          : Block_Data;
      Words         : Block_Words;
      Fresh         : Boolean;
      Ever_Received : Boolean;
      Result        : Outcome;
      Success       : Boolean;
   begin
      Telemetry_Board.Take (Data, Fresh, Ever_Received);
      Sealing.Set_Time (Now);
      Sealing.Open (Data, Fresh, Words, Result);
      Kept := Steps.Next (Kept, Result, Words);
      Previous.Write (Kept);
      Is_New := Steps.Is_New (Kept);

      if Result in Refused then
         Errors.Report (Block_Refused, Steps.Reason (Result));
      end if;
      if Steps.Is_Missed (Result, Ever_Received) then
         Errors.Report (TELIN_No_Block, 0);
      end if;

      if Steps.Is_Sent (Kept) then
         TELIN_Variable.Send (Kept.Buffer, Success);
         if not Success then
            Errors.Report (Input_Not_Consumed, 0);
         end if;
      end if;
   end Run_Transaction;

end URV.TELIN_Task;
