--  SPDX-License-Identifier: Apache-2.0

with URVOS;            use URVOS;
with URV.Buffers;      use URV.Buffers;
with URV.Errors;       use URV.Errors;
with URV.GDCOUT_Steps; use URV.GDCOUT_Steps;
with URV.Routing;      use URV.Routing;

package body URV.GDCOUT_Task with SPARK_Mode is

   Unknown : constant Unknown_Count := First_Unknown_Command (Codes);

   --  The message of an image, to all consumers.
   procedure Pass_On (Image : AD_Image; Fresh : Boolean);

   procedure Run_Transaction is
      Image : AD_Image;
      Fresh : Boolean;
   begin
      AD_Variable.Receive (Image, Fresh);
      Pass_On (Image, Fresh);
   end Run_Transaction;

   procedure Pass_On (Image : AD_Image; Fresh : Boolean) is
      Bits       : constant Word := Node_Status.Contents;
      Message    : Uplink_Buffer := Commands_Of (Image, Codes);
      Order      : Uplink_Buffer;
      Is_Ordered : Boolean;
      Success    : Boolean;
   begin
      Mark (Message, (if Fresh then Bits else Bits or Stale_Data));
      pragma Assert (Message = Message_Of (Image, Fresh, Codes, Bits));
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
   end Pass_On;

end URV.GDCOUT_Task;
