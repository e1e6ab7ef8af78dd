with URV.CORE_Layout; use URV.CORE_Layout;

package body URV.CORE_Task
  with
    SPARK_Mode,
    Refined_State => (First_Run => Codes_Wanted)
is

   Codes_Wanted : Boolean := True;

   procedure Initialise is
   begin
      Codes_Wanted := True;
   end Initialise;

   procedure Run_Transaction is
      Uplink   : Uplink_Buffer;
      Downlink : Downlink_Buffer;
      Fresh    : Boolean;
   begin
      if Codes_Wanted then
         Write_Codes
           (Uplink_Type_Codes, Downlink_Type_Codes, Status_Type_Codes);
         Codes_Wanted := False;
      end if;

      Receive_Uplink (Uplink, Fresh);
      if Fresh then
         Write_Uplink (To_Words (Uplink));
      else
         Report (CORE_No_Uplink, 0);
      end if;

      Receive_Downlink (Downlink, Fresh);
      if Fresh then
         Write_Downlink (To_Words (Downlink));
      else
         Report (CORE_No_Downlink, 0);
      end if;
   end Run_Transaction;

end URV.CORE_Task;
