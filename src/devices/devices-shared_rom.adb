package body Devices.Shared_ROM with SPARK_Mode is

   procedure Read (Where : Byte_Address; Data : out Byte) is
   begin
      Read_ROM (Board, Where, Data);
   end Read;

end Devices.Shared_ROM;
