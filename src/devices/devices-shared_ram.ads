--  A processor board's working memory, word by word, for its test (TST-1,
--  D-17).

with Devices.Memory_Bus; use Devices.Memory_Bus;
with URVOS;              use URVOS;
with URVOS.Memories;     use URVOS.Memories;

generic
   Board : Board_Number;
package Devices.Shared_RAM with SPARK_Mode is

   procedure Read (Where : Word_Address; Data : out Word)
   with
     Global => (Input => Cells),
     Pre    => Where <= Last_RAM_Word;

   procedure Write (Where : Word_Address; Data : Word)
   with
     Global => (In_Out => Cells),
     Pre    => Where <= Last_RAM_Word;

end Devices.Shared_RAM;
