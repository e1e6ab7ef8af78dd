package body Devices.Shared_PWM_Board
  with
    SPARK_Mode,
    Refined_State => (Board => Guarded_Board)
is

   protected Guarded_Board is

      procedure Write (Area : Data_Area);

      function Contents return Data_Area;

   private
      Words : Data_Area := Power_Up;
   end Guarded_Board;

   protected body Guarded_Board is

      procedure Write (Area : Data_Area) is
      begin
         Words := Area;
      end Write;

      function Contents return Data_Area is (Words);

   end Guarded_Board;

   procedure Write (Area : Data_Area) is
   begin
      Guarded_Board.Write (Area);
   end Write;

   procedure Read (Area : out Data_Area) is
   begin
      Area := Guarded_Board.Contents;
   end Read;

end Devices.Shared_PWM_Board;
