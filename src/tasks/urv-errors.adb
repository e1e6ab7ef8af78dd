package body URV.Errors with SPARK_Mode is

   procedure Count_Error (Counts : in out Error_Counts; Kind : Error_Kind) is
   begin
      Counts (Kind) := Incremented (Counts (Kind));
   end Count_Error;

end URV.Errors;
