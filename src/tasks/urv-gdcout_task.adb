--  SPDX-License-Identifier: Apache-2.0

with URVOS;            use URVOS;
with URV.Buffers;      use URV.Buffers;
with URV.Errors;       use URV.Errors;
with URV.GDCOUT_Steps; use URV.GDCOUT_Steps;
with URV.Routing;      use URV.Routing;

package body URV.GDCOUT_Task with SPARK_Mode is

   procedure Run_Transaction is
      Bits       : constant Word := Node_Status.Contents;
      Unknown    : constant Unknown_Count := First_Unknown_Command (Codes);
      Image      : AD_Image;
      Message    : Uplink_Buffer;
      Order      : Uplink_Buffer;
      Fresh      : Boolean;
      Is_Ordered : Boolean;
      Success    : Boolean;
   begin
      AD_Variable.Receive (Image, Fresh);
      Message := Message_Of (Image, Fresh, Codes, Bits);
      if Unknown > 0 then
         Errors.Report (Unknown_Code, Codes (Channel (Unknown - 1)));
      end if;
      if not Fresh then
         Errors.Report (No_Image, 0);
      end if;

      Uplink_Variable.Send (Message, Success);
      if not Success then
         Errors.Report (Uplink_Not_Consumed, 0);
      end if;
      Console_Orders.Look (Order, Is_Ordered);
      TELOUT_Variable.Send (For_Link (Message, Order, Is_Ordered), Success);
      if not Success then
         Errors.Report (Output_Not_Consumed, 0);
      end if;
   end Run_Transaction;

end URV.GDCOUT_Task;
