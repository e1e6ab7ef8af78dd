package body Devices.Shared_CORE_Memory
  with
    SPARK_Mode,
    Refined_State => (CORE => Guarded_Memory)
is

   protected Guarded_Memory is

      procedure Clear;

      procedure Write_Codes
        (Uplink_Codes   : Uplink_Words;
         Downlink_Codes : Downlink_Words;
         Status_Codes   : Status_Words);

      procedure Write_Uplink (Words : Uplink_Words);

      procedure Write_Downlink (Words : Downlink_Words);

      procedure Write_Status (Words : Status_Array);

      procedure Write_Log (Which : Log_Row_Number; Row : Log_Row);

      procedure Write_Aircraft_Log (Which : Log_Row_Number; Row : Log_Row);

      function Snapshot return Memory;

   private
      Contents : Memory;
   end Guarded_Memory;

   protected body Guarded_Memory is

      procedure Clear is
      begin
         Contents := Cleared;
      end Clear;

      procedure Write_Codes
        (Uplink_Codes   : Uplink_Words;
         Downlink_Codes : Downlink_Words;
         Status_Codes   : Status_Words)
      is
      begin
         Contents.Uplink_Codes := Uplink_Codes;
         Contents.Downlink_Codes := Downlink_Codes;
         Contents.Status_Codes := Status_Codes;
      end Write_Codes;

      procedure Write_Uplink (Words : Uplink_Words) is
      begin
         Contents.Uplink := Words;
      end Write_Uplink;

      procedure Write_Downlink (Words : Downlink_Words) is
      begin
         Contents.Downlink := Words;
      end Write_Downlink;

      procedure Write_Status (Words : Status_Array) is
      begin
         Contents.Status (Words'Range) := Words;
      end Write_Status;

      procedure Write_Log (Which : Log_Row_Number; Row : Log_Row) is
      begin
         Contents.Log (Which) := Row;
      end Write_Log;

      procedure Write_Aircraft_Log (Which : Log_Row_Number; Row : Log_Row) is
      begin
         Contents.Aircraft_Log (Which) := Row;
      end Write_Aircraft_Log;

      function Snapshot return Memory is (Contents);

   end Guarded_Memory;

   procedure Clear is
   begin
      Guarded_Memory.Clear;
   end Clear;

   procedure Write_Codes
     (Uplink_Codes   : Uplink_Words;
      Downlink_Codes : Downlink_Words;
      Status_Codes   : Status_Words)
   is
   begin
      Guarded_Memory.Write_Codes
        (Uplink_Codes, Downlink_Codes, Status_Codes);
   end Write_Codes;

   procedure Write_Uplink (Words : Uplink_Words) is
   begin
      Guarded_Memory.Write_Uplink (Words);
   end Write_Uplink;

   procedure Write_Downlink (Words : Downlink_Words) is
   begin
      Guarded_Memory.Write_Downlink (Words);
   end Write_Downlink;

   procedure Write_Status (Words : Status_Array) is
   begin
      Guarded_Memory.Write_Status (Words);
   end Write_Status;

   procedure Write_Log (Which : Log_Row_Number; Row : Log_Row) is
   begin
      Guarded_Memory.Write_Log (Which, Row);
   end Write_Log;

   procedure Write_Aircraft_Log (Which : Log_Row_Number; Row : Log_Row) is
   begin
      Guarded_Memory.Write_Aircraft_Log (Which, Row);
   end Write_Aircraft_Log;

   procedure Inspect (Snapshot : out Memory) is
   begin
      Snapshot := Guarded_Memory.Snapshot;
   end Inspect;

end Devices.Shared_CORE_Memory;
