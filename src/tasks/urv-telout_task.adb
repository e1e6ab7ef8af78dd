--  SPDX-License-Identifier: Apache-2.0

with Telemetry;  use Telemetry;
with URV.Errors; use URV.Errors;

package body URV.TELOUT_Task with SPARK_Mode is

   procedure Run_Transaction is
      Item      : Messages.Message;
      Data      : Block_Data;
      Fresh     : Boolean;
      Overwrote : Boolean;
   begin
      TELOUT_Variable.Receive (Item, Fresh);

      if Fresh then
         Sealing.Close (Words_Of (Item), Data);
         Telemetry_Board.Put (Data, Overwrote);
         if Overwrote then
            Errors.Report (TELOUT_Overwrote_Block, 0);
         end if;
      else
         Errors.Report (No_Output, 0);
      end if;
   end Run_Transaction;

end URV.TELOUT_Task;
