--  SPDX-License-Identifier: Apache-2.0

with URV.Errors; use URV.Errors;

package body URV.ADINT_Handler with SPARK_Mode is

   --  The scan is complete, or the interrupt was not expected: rare, and out
   --  of the path of all other interrupts.
   procedure End_Scan (Next : Next_Step; Value : Word)
   with
     No_Inline,
     Global => (Input => AD_Board, In_Out => (ADINT_Variable, Errors)),
     Pre    => Next in Send_Words | Ignore;

   procedure Begin_Scan (Reached : out Channel_Count) is
   begin
      AD_Board.Begin_Scan (Reached);
   end Begin_Scan;

   procedure End_Scan (Next : Next_Step; Value : Word) is
      Item    : Channel_Words;
      Success : Boolean;
   begin
      if Next = Send_Words then
         Item := AD_Board.Words;
         ADINT_Variable.Send (Item, Success);
         if not Success then
            Errors.Report (Scan_Not_Consumed, 0);
         end if;
      else
         Errors.Report (AD_Unexpected_Interrupt, Value);
      end if;
   end End_Scan;

   procedure Handle_Interrupt is
      Value : Word;
      Next  : Next_Step;
   begin
      AD_Board.Take_Value (Value, Next);
      if Next in Send_Words | Ignore then
         End_Scan (Next, Value);
      end if;
   end Handle_Interrupt;

   procedure Handle_Value (Value : Word; Channel : out Channel_Count) is
      Next : Next_Step;
   begin
      AD_Board.Pass_Value (Value, Next, Channel);
      if Next in Send_Words | Ignore then
         End_Scan (Next, Value);
      end if;
   end Handle_Value;

end URV.ADINT_Handler;
