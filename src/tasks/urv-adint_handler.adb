--  SPDX-License-Identifier: Apache-2.0

with Devices.AD_Board; use Devices.AD_Board;
with URVOS;            use URVOS;
with URV.Errors;       use URV.Errors;

package body URV.ADINT_Handler
  with
    SPARK_Mode,
    Refined_State => (Current_Scan => Guarded_Scan)
is

   protected Guarded_Scan is

      procedure Restart (Reached : out Channel_Count);

      procedure Store
        (Value   : Word;
         Next    : out Next_Step;
         Current : out Channel_Count);

      function Words return Channel_Words;

   private
      Item : Scan;
   end Guarded_Scan;

   --  The scan is complete, or the interrupt was not expected: rare, and out
   --  of the path of all other interrupts.
   procedure End_Scan (Is_Complete : Boolean; Value : Word)
   with
     No_Inline,
     Global =>
       (Input => Guarded_Scan, In_Out => (ADINT_Variable, Errors));

   protected body Guarded_Scan is

      procedure Restart (Reached : out Channel_Count) is
      begin
         Reached := Item.Current;
         Begin_Again (Item);
      end Restart;

      procedure Store
        (Value   : Word;
         Next    : out Next_Step;
         Current : out Channel_Count)
      is
      begin
         Store (Item, Value, Next);
         Current := Item.Current;
      end Store;

      function Words return Channel_Words is (Item.Words);

   end Guarded_Scan;

   procedure Begin_Scan (Reached : out Channel_Count) is
   begin
      Guarded_Scan.Restart (Reached);
      AD_Board.Start (0);
   end Begin_Scan;

   procedure End_Scan (Is_Complete : Boolean; Value : Word) is
      Item    : Channel_Words;
      Success : Boolean;
   begin
      if Is_Complete then
         Item := Guarded_Scan.Words;
         ADINT_Variable.Send (Item, Success);
         if not Success then
            Errors.Report (Scan_Not_Consumed, 0);
         end if;
      else
         Errors.Report (AD_Unexpected_Interrupt, Value);
      end if;
   end End_Scan;

   procedure Handle_Interrupt is
      Value   : constant Word := AD_Board.Data;
      Next    : Next_Step;
      Current : Channel_Count;
   begin
      Guarded_Scan.Store (Value, Next, Current);
      if Next /= Start_Channel then
         End_Scan (Next = Send_Words, Value);
      elsif Current <= Channel_Count (Channel'Last) then
         AD_Board.Start (Channel_Number (Current));
      end if;
   end Handle_Interrupt;

end URV.ADINT_Handler;
