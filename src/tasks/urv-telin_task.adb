--  SPDX-License-Identifier: Apache-2.0

with URV.Errors; use URV.Errors;
with URV.Handshakes; use URV.Handshakes;
with URVOS;      use URVOS;

package body URV.TELIN_Task with SPARK_Mode is

   procedure Initialise is
   begin
      Previous.Write ((others => <>));
   end Initialise;

   procedure Run_Transaction (Now : Clock_Tick) is
      Kept          : Kept_Message := Previous.Contents;
      Data          : Block_Data;
      Fresh         : Boolean;
      Ever_Received : Boolean;
      What          : Outcome;
      Success       : Boolean;
   begin
      Telemetry_Board.Take (Data, Fresh, Ever_Received);
      Sealing.Set_Time (Now);
      Sealing.Open (Data, Fresh, What);
      if What in Refused then
         Errors.Report
           (Block_Refused,
            Word (Outcome'Pos (What) - Outcome'Pos (Refused'First) + 1));
      end if;

      if What in Taken then
         Kept := (Decode (Data), Has_Message => True);
      else
         Kept.Buffer := As_Old (Kept.Buffer);
         if Ever_Received then
            Errors.Report (TELIN_No_Block, 0);
         end if;
      end if;
      Previous.Write (Kept);

      if Kept.Has_Message then
         TELIN_Variable.Send (Kept.Buffer, Success);
         if not Success then
            Errors.Report (Input_Not_Consumed, 0);
         end if;
      end if;
   end Run_Transaction;

end URV.TELIN_Task;
