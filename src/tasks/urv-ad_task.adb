--  SPDX-License-Identifier: Apache-2.0

with URVOS;      use URVOS;
with URV.Errors; use URV.Errors;
with URV.Routing;

package body URV.AD_Task with SPARK_Mode is

   procedure Initialise is
      Unused_Reached : Channel_Count;
   begin
      Begin_Scan (Unused_Reached);
   end Initialise;

   procedure Run_Transaction is
      Item    : Channel_Words;
      Fresh   : Boolean;
      Success : Boolean;
      Reached : Channel_Count;
   begin
      ADINT_Variable.Receive (Item, Fresh);
      AD_Variable.Send (Routing.Stamped (Item, Fresh), Success);
      if not Success then
         Errors.Report (Image_Not_Consumed, 0);
      end if;

      Begin_Scan (Reached);
      if not Fresh then
         Errors.Report (AD_No_Scan, Word (Reached));
      end if;
   end Run_Transaction;

end URV.AD_Task;
