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

   protected body Guarded_Scan is

      procedure Restart (Reached : out Channel_Count) is
      begin
         Reached := Item.Current;
         Item := Restarted (Item);
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
      Start_Channel (0);
   end Begin_Scan;

   procedure Handle_Interrupt is
      Value   : Word;
      Next    : Next_Step;
      Current : Channel_Count;
      Words   : Channel_Words;
      Success : Boolean;
   begin
      Read_Board (Value);
      Guarded_Scan.Store (Value, Next, Current);

      case Next is
         when AD_Scans.Start_Channel =>
            if Current <= Channel_Count (Channel'Last) then
               Start_Channel (Channel_Number (Current));
            end if;

         when Send_Words =>
            Words := Guarded_Scan.Words;
            Send_ADINT (Words, Success);
            if not Success then
               Report (Scan_Not_Consumed, 0);
            end if;

         when Ignore =>
            Report (AD_Unexpected_Interrupt, Value);
      end case;
   end Handle_Interrupt;

end URV.ADINT_Handler;
