with URV.AD_Scans; use URV.AD_Scans;

package body URV.ADINT_Handler
  with
    SPARK_Mode,
    Refined_State => (Current_Scan => Guarded_Scan)
is

   protected Guarded_Scan is

      procedure Restart;

      procedure Store
        (Value  : Word;
         Next   : out Next_Step;
         Result : out Scan);

   private
      Item : Scan;
   end Guarded_Scan;

   protected body Guarded_Scan is

      procedure Restart is
      begin
         Item := Restarted (Item);
      end Restart;

      procedure Store
        (Value  : Word;
         Next   : out Next_Step;
         Result : out Scan)
      is
      begin
         Store (Item, Value, Next);
         Result := Item;
      end Store;

   end Guarded_Scan;

   procedure Begin_Scan is
   begin
      Guarded_Scan.Restart;
      Start_Channel (0);
   end Begin_Scan;

   procedure Handle_Interrupt is
      Value   : Word;
      Next    : Next_Step;
      Result  : Scan;
      Success : Boolean;
   begin
      Read_Board (Value);
      Guarded_Scan.Store (Value, Next, Result);

      case Next is
         when AD_Scans.Start_Channel =>
            if not Is_Complete (Result) then
               Start_Channel (Channel_Number (Result.Current));
            end if;

         when Send_Words =>
            Send_ADINT (Result.Words, Success);
            if not Success then
               Report (Scan_Not_Consumed);
            end if;

         when Ignore =>
            Report (AD_Unexpected_Interrupt);
      end case;
   end Handle_Interrupt;

end URV.ADINT_Handler;
