--  SPDX-License-Identifier: Apache-2.0

with URVOS.Image_Sums; use URVOS.Image_Sums;

package body Host.Memory_Hardware is

   type ROM_Image is array (ROM_Address) of Byte;
   type RAM_Cells is array (RAM_Address) of Word;
   type Fault_List is array (Fault_Number) of Fault;

   type Board_Memory is record
      ROM    : ROM_Image;
      RAM    : RAM_Cells := (others => 16#DEAD#);
      Faults : Fault_List;

      --  The board has a fault.
      Is_Faulty : Boolean := False;

      --  The bits of each word that read as 0.
      Stuck  : RAM_Cells := (others => 0);

      --  The next read of the ROM fails.
      Broken : Boolean := False;
   end record;

   --  The long of these four bytes.
   function Long_At (ROM : ROM_Image; Where : ROM_Address) return Long;

   --  Numbers in place of a program, and their sum.
   function New_Image return ROM_Image;

   function Mask (Bit : Bit_Number) return Word is
     (Shift_Left (1, Natural (Bit)));

   function Bit_At (Data : Word; Bit : Bit_Number) return Bit_Value is
     (if (Data and Mask (Bit)) = 0 then 0 else 1);

   function Changed
     (Data : Word; Bit : Bit_Number; Value : Bit_Value) return Word
   is
     (if Value = 0 then Data and not Mask (Bit) else Data or Mask (Bit));

   --  Drives a word onto its cells.
   procedure Drive (Memory : in out Board_Memory;
                    Where  : RAM_Address;
                    Data   : Word);

   --  Applies the couplings between cells that act at once.
   procedure Settle (Memory : in out Board_Memory);

   function Long_At (ROM : ROM_Image; Where : ROM_Address) return Long is
     (Long (ROM (Where)) * 2 ** 24 + Long (ROM (Where + 1)) * 2 ** 16
      + Long (ROM (Where + 2)) * 2 ** 8 + Long (ROM (Where + 3)));

   function New_Image return ROM_Image is
      Sums  : Sum  := First_Value;
      State : Long := 1;
      Kept  : Long;
   begin
      return Result : ROM_Image do
         for Where in 0 .. ROM_Address'Last - 8 loop
            State := State * 1_664_525 + 1_013_904_223;
            Result (Where) := Byte (Shift_Right (State, 24));
            if Where mod 4 = 3 then
               Sums := Next (Sums, Long_At (Result, Where - 3));
            end if;
         end loop;
         for Place in Kept_Place loop
            Kept := Kept_Long (Sums, Place);
            for Byte_In_Long in ROM_Address range 0 .. 3 loop
               Result
                 (ROM_Address'Last - 7 + 4 * ROM_Address (Place)
                  + Byte_In_Long) :=
                 Byte (Shift_Right (Kept, 24 - 8 * Natural (Byte_In_Long))
                       and 16#FF#);
            end loop;
         end loop;
      end return;
   end New_Image;

   Original : constant ROM_Image := New_Image;

   Boards : array (Board_Number) of Board_Memory :=
     (others => (ROM => Original, others => <>));

   function Programmed (Where : ROM_Address) return Byte is
     (Original (Where));

   procedure Spoil_ROM
     (Board : Board_Number;
      Where : ROM_Address;
      Flips : Byte)
   is
      ROM : ROM_Image renames Boards (Board).ROM;
   begin
      ROM (Where) := ROM (Where) xor Flips;
   end Spoil_ROM;

   procedure Blank_ROM (Board : Board_Number; Data : Byte) is
   begin
      Boards (Board).ROM := (others => Data);
   end Blank_ROM;

   procedure Fail_Next_Read (Board : Board_Number) is
   begin
      Boards (Board).Broken := True;
   end Fail_Next_Read;

   procedure Stick_RAM
     (Board : Board_Number;
      Where : RAM_Address;
      Bits  : Word)
   is
      Stuck : Word renames Boards (Board).Stuck (Where);
   begin
      Stuck := Stuck or Bits;
   end Stick_RAM;

   procedure Plant
     (Board   : Board_Number;
      Planted : Fault;
      Number  : Fault_Number := 1)
   is
   begin
      Boards (Board).Faults (Number) := Planted;
      Boards (Board).Is_Faulty := True;
      Settle (Boards (Board));
   end Plant;

   procedure Repair (Board : Board_Number) is
   begin
      Boards (Board).ROM := Original;
      Boards (Board).Faults := (others => <>);
      Boards (Board).Is_Faulty := False;
      Boards (Board).Stuck := (others => 0);
      Boards (Board).Broken := False;
   end Repair;

   procedure Settle (Memory : in out Board_Memory) is
   begin
      for Item of Memory.Faults loop
         declare
            Suffers : Word renames Memory.RAM (Item.Cell.Where);
         begin
            if Item.Kind = Stuck
              or else
                (Item.Kind = State_Coupling
                 and then Bit_At (Memory.RAM (Item.Source.Where),
                                  Item.Source.Bit) = Item.Edge)
            then
               Suffers := Changed (Suffers, Item.Cell.Bit, Item.Value);
            end if;
         end;
      end loop;
   end Settle;

   procedure Drive (Memory : in out Board_Memory;
                    Where  : RAM_Address;
                    Data   : Word)
   is
      Before : constant Word := Memory.RAM (Where);
      After  : Word := Data;
   begin
      for Item of Memory.Faults loop
         if Item.Kind = No_Transition
           and then Item.Cell.Where = Where
           and then Bit_At (Before, Item.Cell.Bit) /= Item.Value
         then
            After := Changed (After, Item.Cell.Bit, 1 - Item.Value);
         end if;
      end loop;
      Memory.RAM (Where) := After;

      --  Effects of one cell's change on another, after the write.
      for Item of Memory.Faults loop
         if Item.Kind in Inversion | Idempotent
           and then Item.Source.Where = Where
           and then Bit_At (Before, Item.Source.Bit) /= Item.Edge
           and then Bit_At (After, Item.Source.Bit) = Item.Edge
         then
            declare
               Suffers : Word renames Memory.RAM (Item.Cell.Where);
            begin
               Suffers :=
                 (if Item.Kind = Inversion
                  then Suffers xor Mask (Item.Cell.Bit)
                  else Changed (Suffers, Item.Cell.Bit, Item.Value));
            end;
         end if;
      end loop;
      Settle (Memory);
   end Drive;

   procedure Read_ROM
     (Board : Board_Number;
      Where : Byte_Address;
      Data  : out Long)
   is
      Memory : Board_Memory renames Boards (Board);
   begin
      Data := Long_At (Memory.ROM, ROM_Address (Where));
      if Memory.Broken then
         Memory.Broken := False;
         raise Bus_Error;
      end if;
   end Read_ROM;

   procedure Read_RAM
     (Board : Board_Number;
      Where : Word_Address;
      Data  : out Word)
   is
      Memory : Board_Memory renames Boards (Board);
   begin
      --  A start tests every word of the RAM.
      if not Memory.Is_Faulty then
         Data := Memory.RAM (Where) and not Memory.Stuck (Where);
         return;
      end if;

      Data := Memory.RAM (Where);
      for Item of Memory.Faults loop
         if Item.Cell.Where = Where then
            case Item.Kind is
               when No_Cells =>
                  Data := (if Item.Value = 0 then 0 else 16#FFFF#);
               when Other_Cells =>
                  Data := Memory.RAM (Item.Source.Where);
               when Both_Cells =>
                  Data :=
                    (if Item.Value = 0
                     then Data and Memory.RAM (Item.Source.Where)
                     else Data or Memory.RAM (Item.Source.Where));
               when others =>
                  null;
            end case;
         end if;
      end loop;
      Data := Data and not Memory.Stuck (Where);
   end Read_RAM;

   procedure Write_RAM
     (Board : Board_Number;
      Where : Word_Address;
      Data  : Word)
   is
      Memory      : Board_Memory renames Boards (Board);
      Reaches_Own : Boolean := True;
   begin
      if not Memory.Is_Faulty then
         Memory.RAM (Where) := Data;
         return;
      end if;

      for Item of Memory.Faults loop
         if Item.Cell.Where = Where then
            case Item.Kind is
               when No_Cells =>
                  Reaches_Own := False;
               when Other_Cells =>
                  Reaches_Own := False;
                  Drive (Memory, Item.Source.Where, Data);
               when Both_Cells =>
                  Drive (Memory, Item.Source.Where, Data);
               when others =>
                  null;
            end case;
         end if;
      end loop;
      if Reaches_Own then
         Drive (Memory, Where, Data);
      end if;
   end Write_RAM;

end Host.Memory_Hardware;
