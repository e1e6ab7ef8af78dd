package body URV.TELIN_Task
  with
    SPARK_Mode,
    Refined_State => (Previous => (TELIN_Buffer, Has_Message))
is

   TELIN_Buffer : Message := Neutral;
   Has_Message  : Boolean := False;

   procedure Initialise is
   begin
      TELIN_Buffer := Neutral;
      Has_Message := False;
   end Initialise;

   procedure Run_Transaction is
      Data          : Block_Data;
      Fresh         : Boolean;
      Ever_Received : Boolean;
      Success       : Boolean;
   begin
      Take_Block (Data, Fresh, Ever_Received);

      if Fresh then
         TELIN_Buffer := Decode (Data);
         Has_Message := True;
      else
         TELIN_Buffer := As_Old (TELIN_Buffer);
         if Ever_Received then
            Report (TELIN_No_Block, 0);
         end if;
      end if;

      if Has_Message then
         Send_TELIN (TELIN_Buffer, Success);
         if not Success then
            Report (Input_Not_Consumed, 0);
         end if;
      end if;
   end Run_Transaction;

end URV.TELIN_Task;
