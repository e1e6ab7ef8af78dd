package body URV.Shared_Status
  with
    SPARK_Mode,
    Refined_State => (Status => Guarded_Status)
is

   protected Guarded_Status is

      procedure Write (New_Bits : Word);

      function Bits return Word;

   private
      Current : Word := 0;
   end Guarded_Status;

   protected body Guarded_Status is

      procedure Write (New_Bits : Word) is
      begin
         Current := New_Bits;
      end Write;

      function Bits return Word is (Current);

   end Guarded_Status;

   procedure Write (Bits : Word) is
   begin
      Guarded_Status.Write (Bits);
   end Write;

   procedure Read (Bits : out Word) is
   begin
      Bits := Guarded_Status.Bits;
   end Read;

end URV.Shared_Status;
