package body URV.Shared_Errors
  with
    SPARK_Mode,
    Refined_State => (Shared_Log => Guarded_Log)
is

   protected Guarded_Log is

      procedure Set_Time (Tick_Now : Clock_Tick);

      procedure Report
        (Error     : Error_Kind;
         How_Often : Logs.Positive_Count;
         Detail    : Word);

      procedure Clear;

      function Snapshot return Error_Log;

   private
      Contents : Error_Log  := Logs.Empty_Log;
      Now      : Clock_Tick := 0;
   end Guarded_Log;

   protected body Guarded_Log is

      procedure Set_Time (Tick_Now : Clock_Tick) is
      begin
         Now := Tick_Now;
      end Set_Time;

      procedure Report
        (Error     : Error_Kind;
         How_Often : Logs.Positive_Count;
         Detail    : Word)
      is
      begin
         Logs.Add (Contents, Error, Now, Detail, How_Often);
      end Report;

      procedure Clear is
      begin
         Contents := Logs.Empty_Log;
      end Clear;

      function Snapshot return Error_Log is (Contents);

   end Guarded_Log;

   procedure Set_Time (Now : Clock_Tick) is
   begin
      Guarded_Log.Set_Time (Now);
   end Set_Time;

   procedure Report (Error : Error_Kind; Detail : Word) is
   begin
      Guarded_Log.Report (Error, 1, Detail);
   end Report;

   procedure Report_Several
     (Error     : Error_Kind;
      How_Often : Logs.Positive_Count;
      Detail    : Word)
   is
   begin
      Guarded_Log.Report (Error, How_Often, Detail);
   end Report_Several;

   procedure Clear is
   begin
      Guarded_Log.Clear;
   end Clear;

   procedure Inspect (Snapshot : out Error_Log) is
   begin
      Snapshot := Guarded_Log.Snapshot;
   end Inspect;

end URV.Shared_Errors;
