package body Devices.Shared_RAM with SPARK_Mode is

   procedure Read (Where : Word_Address; Data : out Word) is
   begin
      Read_RAM (Board, Where, Data);
   end Read;

   procedure Write (Where : Word_Address; Data : Word) is
   begin
      Write_RAM (Board, Where, Data);
   end Write;

end Devices.Shared_RAM;
