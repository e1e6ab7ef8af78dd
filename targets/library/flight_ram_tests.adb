--  SPDX-License-Identifier: Apache-2.0

with Devices.Memory_Sizes;    use Devices.Memory_Sizes;
with Interfaces;              use Interfaces;
with System.Storage_Elements; use System.Storage_Elements;
with URVOS.RAM_Walks;         use URVOS.RAM_Walks;

package body Flight_RAM_Tests is

   --  image.ld has these addresses.

   Scratchpad_First : Storage_Element
   with Import, Convention => C, External_Name => "urv_tested_ram";
   RAM_First : Storage_Element
   with Import, Convention => C, External_Name => "urv_ram";

   Words_Per_Cell : constant := 2;
   Bytes_Per_Cell : constant := 4;

   Parts : constant Part_Sizes :=
     (Scratchpad => Cell_Count (Last_RAM_Word + 1) / Words_Per_Cell,
      Variables  => RAM_Cells);

   Progress : Walk;

   --  Tests the cell at this address; 1 if it is sound.
   function March (Where : System.Address) return Integer_32
   with Import, Convention => C, External_Name => "urv_march";

   procedure Begin_Tick is
   begin
      Progress := After_Tick (Progress, RAM_Cells_Per_Tick);
   end Begin_Tick;

   function Has_Cell return Boolean is (Has_Cell (Progress));

   procedure Test_Cell (Is_Sound : out Boolean; Where : out Word_Address) is
      Here  : constant Place := Place_Of (Progress.Next, Parts);
      First : constant System.Address :=
        (case Here.Part is
            when Scratchpad => Scratchpad_First'Address,
            when Variables  => RAM_First'Address);
   begin
      Is_Sound :=
        March (First + Bytes_Per_Cell * Storage_Offset (Here.Cell)) /= 0;
      Where := Word_Of (Progress.Next);
      Progress := After_Cell (Progress, Parts);
   end Test_Cell;

end Flight_RAM_Tests;
