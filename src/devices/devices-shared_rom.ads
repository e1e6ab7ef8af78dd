--  A processor board's program memory, read byte by byte (TST-1, TST-3).

with Devices.Memory_Bus; use Devices.Memory_Bus;
with URVOS;              use URVOS;
with URVOS.Memories;     use URVOS.Memories;

generic
   Board : Board_Number;
package Devices.Shared_ROM with SPARK_Mode is

   procedure Read (Where : Byte_Address; Data : out Byte)
   with
     Global => (Input => Cells),
     Pre    => Where <= Last_ROM_Byte;

end Devices.Shared_ROM;
