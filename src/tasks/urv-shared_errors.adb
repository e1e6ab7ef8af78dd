package body URV.Shared_Errors
  with
    SPARK_Mode,
    Refined_State => (Counts => Guarded_Counts)
is

   protected Guarded_Counts is

      procedure Report (Kind : Error_Kind);

      procedure Clear;

      function Snapshot return Error_Counts;

   private
      Contents : Error_Counts := No_Errors;
   end Guarded_Counts;

   protected body Guarded_Counts is

      procedure Report (Kind : Error_Kind) is
      begin
         Count_Error (Contents, Kind);
      end Report;

      procedure Clear is
      begin
         Contents := No_Errors;
      end Clear;

      function Snapshot return Error_Counts is (Contents);

   end Guarded_Counts;

   procedure Report (Kind : Error_Kind) is
   begin
      Guarded_Counts.Report (Kind);
   end Report;

   procedure Clear is
   begin
      Guarded_Counts.Clear;
   end Clear;

   procedure Inspect (Snapshot : out Error_Counts) is
   begin
      Snapshot := Guarded_Counts.Snapshot;
   end Inspect;

end URV.Shared_Errors;
