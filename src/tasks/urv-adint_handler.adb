--  SPDX-License-Identifier: Apache-2.0

with URV.Errors; use URV.Errors;

package body URV.ADINT_Handler with SPARK_Mode is

   procedure Send_Scan
   with Global => (Input => AD_Board, In_Out => (ADINT_Variable, Errors));

   procedure Begin_Scan (Reached : out Channel_Count) is
   begin
      AD_Board.Begin_Scan (Reached);
   end Begin_Scan;

   procedure Send_Scan is
      Item    : constant Channel_Words := AD_Board.Words;
      Success : Boolean;
   begin
      ADINT_Variable.Send (Item, Success);
      if not Success then
         Errors.Report (Scan_Not_Consumed, 0);
      end if;
   end Send_Scan;

   procedure Handle_End (Next : Successor; Value : Word) is
   begin
      if Next = Scan_Complete then
         Send_Scan;
      elsif Next = Not_Expected then
         Errors.Report (AD_Unexpected_Interrupt, Value);
      end if;
   end Handle_End;

   procedure Handle_Interrupt is
      Value : Word;
      Next  : Next_Step;
   begin
      AD_Board.Take_Value (Value, Next);
      if Next = Send_Words then
         Handle_End (Scan_Complete, Value);
      elsif Next = Ignore then
         Handle_End (Not_Expected, Value);
      end if;
   end Handle_Interrupt;

end URV.ADINT_Handler;
