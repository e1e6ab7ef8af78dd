--  SPDX-License-Identifier: Apache-2.0

with Checks;                use Checks;
with Devices.Memory_Bus;    use Devices.Memory_Bus;
with Devices.Processor_Memories;
with Expectations;          use Expectations;
with Host.Memory_Hardware;  use Host.Memory_Hardware;
with URVOS;                 use URVOS;
with URVOS.Image_Sums;      use URVOS.Image_Sums;
with URVOS.Memories;        use URVOS.Memories;
with URVOS.Processor_Tests; use URVOS.Processor_Tests;
with URVOS.RAM_Models;      use URVOS.RAM_Models;
with URVOS.RAM_Tests;
with URVOS.RAM_Walks;       use URVOS.RAM_Walks;
with URVOS.ROM_Checks;
with URVOS.Self_Tests;      use URVOS.Self_Tests;
with URVOS.Start_Tests;
with URVOS.Starts;
with URV.Buffers;           use URV.Buffers;
with URV.CORE_Memory;       use URV.CORE_Memory;
with URV.Errors;            use URV.Errors;
with URV.Self_Test_Task;
with URV.Shared_CORE_Memory;
with URV.Shared_Errors;
with URV.Shared_Status;

separate (Node_Suite)
package body Self_Test_Tests is

   --  The tests, in order.
   procedure Known_Answer;
   procedure Every_Byte_Of_A_Small_Image;
   procedure Bytes_Of_The_Whole_Image;
   procedure Blank_Images;
   procedure Three_Wrong_Bits;
   procedure Single_Cells;
   procedure Coupled_Cells;
   procedure Linked_Cells;
   procedure Wrong_Decoding;
   procedure Faults_In_All_The_RAM;
   procedure Zeros_After;
   procedure Thousand_Starts;
   procedure Order_Of_Tests;
   procedure Operands_Are_Looked_At;
   procedure Slices;
   procedure Failure_In_Flight;
   procedure Result_Words;
   procedure Walk_In_Flight;

   --  Board 1 is tested; the others show that boards are independent.

   package Memories is new Devices.Processor_Memories (Board => 1);

   --  The number of accesses to the RAM.
   Accesses : Natural := 0;

   procedure Read_RAM (Where : Word_Address; Data : out Word);
   procedure Write_RAM (Where : Word_Address; Data : Word);

   package Whole is new URVOS.RAM_Tests
     (Address    => Word_Address,
      First      => 0,
      Last       => Last_RAM_Word,
      Step       => 1,
      Write      => Write_RAM,
      Read       => Read_RAM,
      Wide       => Word,
      Wide_Step  => 1,
      Write_Wide => Write_RAM,
      Read_Wide  => Read_RAM);

   --  The RAM's first six words, for all pairs of cells.
   Small_Last : constant RAM_Address := 5;

   package Small is new URVOS.RAM_Tests
     (Address    => Word_Address,
      First      => 0,
      Last       => Small_Last,
      Step       => 1,
      Write      => Write_RAM,
      Read       => Read_RAM,
      Wide       => Word,
      Wide_Step  => 1,
      Write_Wide => Write_RAM,
      Read_Wide  => Read_RAM);

   --  The same words, two at once for the backgrounds. A bus of 16 bits
   --  writes them in turn.

   procedure Read_Long (Where : Word_Address; Data : out Long);
   procedure Write_Long (Where : Word_Address; Data : Long);

   package Small_By_Longs is new URVOS.RAM_Tests
     (Address    => Word_Address,
      First      => 0,
      Last       => Small_Last,
      Step       => 1,
      Write      => Write_RAM,
      Read       => Read_RAM,
      Wide       => Long,
      Wide_Step  => 2,
      Write_Wide => Write_Long,
      Read_Wide  => Read_Long);

   package Start is new URVOS.Start_Tests
     (Last_Long => Last_ROM_Long,
      Last_Word => Last_RAM_Word,
      Read_ROM  => Memories.Read_ROM,
      Read_RAM  => Read_RAM,
      Write_RAM => Write_RAM);

   --  The surroundings of the tasks in flight

   CORE   : URV.Shared_CORE_Memory.Board;
   Status : URV.Shared_Status.Status;
   Errors : URV.Shared_Errors.Shared_Log;

   package In_Flight is new URV.Self_Test_Task
     (Last            => Last_ROM_Long,
      Longs_Per_Frame => 32,
      CORE_Memory     => CORE,
      Node_Status     => Status,
      Errors          => Errors,
      Read_ROM        => Memories.Read_ROM);

   package Long_By_Long is new URV.Self_Test_Task
     (Last            => Last_ROM_Long,
      Longs_Per_Frame => 1,
      CORE_Memory     => CORE,
      Node_Status     => Status,
      Errors          => Errors,
      Read_ROM        => Memories.Read_ROM);

   --  A slice that does not divide the image.
   package Odd is new URV.Self_Test_Task
     (Last            => Last_ROM_Long,
      Longs_Per_Frame => 250,
      CORE_Memory     => CORE,
      Node_Status     => Status,
      Errors          => Errors,
      Read_ROM        => Memories.Read_ROM);

   --  Clears all findings and reports.
   procedure Clear_Results;

   --  CORE's counts of the passes, and the log's count.

   function Good return Word is (CORE.Contents.Status (ROM_Passes));
   function Bad return Word is (CORE.Contents.Status (ROM_Failures));
   function Results return Natural is (Natural (Good) + Natural (Bad));

   function Failures return Logs.History is
     (Logs.History_Of (Errors.Contents, ROM_Check_Failed));
   function Reports return Natural is (Natural (Failures.Occurrences));

   --  The small memory with one fault, and with two.
   procedure Expect_Found (What : String; Planted : Fault);
   function Is_Found (First, Second : Fault) return Boolean;

   --  The whole memory with a fault.
   procedure Expect_Found_In_All (What : String; Planted : Fault);

   procedure Expect_Start (What : String; Expected : Test_Result);

   --  A cell of the small memory.
   type Cell_Number is range 0 .. 16 * (Natural (Small_Last) + 1) - 1;

   function Place_Of (Cell : Cell_Number) return Bit_Place is
     ((Where => RAM_Address (Cell / 16), Bit => Bit_Number (Cell mod 16)));

   function Text (Place : Bit_Place) return String is
     ("bit" & Place.Bit'Image & " of word" & Place.Where'Image);

   procedure Read_RAM (Where : Word_Address; Data : out Word) is
   begin
      Accesses := Accesses + 1;
      Memories.Read_RAM (Where, Data);
   end Read_RAM;

   procedure Write_RAM (Where : Word_Address; Data : Word) is
   begin
      Accesses := Accesses + 1;
      Memories.Write_RAM (Where, Data);
   end Write_RAM;

   procedure Read_Long (Where : Word_Address; Data : out Long) is
      High, Low : Word;
   begin
      Read_RAM (Where, High);
      Read_RAM (Where + 1, Low);
      Data := Long (High) * 2 ** 16 + Long (Low);
   end Read_Long;

   procedure Write_Long (Where : Word_Address; Data : Long) is
   begin
      Write_RAM (Where, Word (Data / 2 ** 16));
      Write_RAM (Where + 1, Word (Data mod 2 ** 16));
   end Write_Long;

   procedure Clear_Results is
   begin
      CORE.Clear;
      Errors.Clear;
      Status.Write (0);
   end Clear_Results;

   procedure Expect_Found (What : String; Planted : Fault) is
      Sound : Boolean;
      Where : Word_Address;
   begin
      Repair (1);
      Plant (1, Planted);
      Small.Run (Sound, Where);
      if not Sound then
         Repair (1);
         Plant (1, Planted);
         Small_By_Longs.Run (Sound, Where);
      end if;
      --  The text is made only when needed, since there are many tests.
      if Sound then
         Expect
           (What & " at " & Text (Planted.Cell) & " from "
            & Text (Planted.Source) & Planted.Edge'Image
            & Planted.Value'Image & ": found",
            False, True);
      end if;
   end Expect_Found;

   function Is_Found (First, Second : Fault) return Boolean is
      Sound : Boolean;
      Where : Word_Address;
   begin
      Repair (1);
      Plant (1, First, 1);
      Plant (1, Second, 2);
      Small.Run (Sound, Where);
      if Sound then
         return False;
      end if;
      Repair (1);
      Plant (1, First, 1);
      Plant (1, Second, 2);
      Small_By_Longs.Run (Sound, Where);
      return not Sound;
   end Is_Found;

   procedure Expect_Found_In_All (What : String; Planted : Fault) is
      Sound : Boolean;
      Where : Word_Address;
   begin
      Repair (1);
      Plant (1, Planted);
      Whole.Run (Sound, Where);
      Expect (What & " at " & Text (Planted.Cell) & ": passes", Sound, False);
      if Planted.Kind in Stuck | No_Transition then
         Expect_Number
           (What & ": the word", Natural (Where),
            Natural (Planted.Cell.Where));
      end if;
   end Expect_Found_In_All;

   procedure Expect_Start (What : String; Expected : Test_Result) is
      Result : Test_Result;
   begin
      Start.Run (URVOS.Starts.Warm_Reset, Result);
      Expect (What & ": passed", Result.Passed, Expected.Passed);
      Expect (What & ": result", To_Word (Result), To_Word (Expected));
      Start.Run (URVOS.Starts.Processor_Restart, Result);
      Expect (What & ": restart", To_Word (Result), To_Word (All_Passed));
   end Expect_Start;

   procedure Known_Answer is
      Sums : Sum := First_Value;
   begin
      --  By division of polynomials, in another language.
      for Data of Image'(16#3132_3334#, 16#3536_3738#, 16#DEAD_BEEF#) loop
         Sums := Next (Sums, Data);
      end loop;
      Expect ("parity", Sums.Parity = 16#2556_451C#, True);
      Expect ("remainder", Sums.Remainder = 16#8FF6_E1EC#, True);
   end Known_Answer;

   --  The long of four bytes of the ROM, with some bits changed.
   function Long_At (Where : ROM_Address; Flips : Long := 0) return Long;

   function Long_At (Where : ROM_Address; Flips : Long := 0) return Long is
     ((Long (Programmed (Where)) * 2 ** 24
       + Long (Programmed (Where + 1)) * 2 ** 16
       + Long (Programmed (Where + 2)) * 2 ** 8
       + Long (Programmed (Where + 3))) xor Flips);

   --  The ROM as it is now passes.
   function ROM_Is_Good return Boolean;

   function ROM_Is_Good return Boolean is
      Sums : Sum := First_Value;
      Data : Long;
   begin
      for Number in 0 .. Last_ROM_Long loop
         Memories.Read_ROM (Bytes_Per_Long * Byte_Address (Number), Data);
         Sums := Next (Sums, Data);
      end loop;
      return Sums = Good_Image;
   end ROM_Is_Good;

   procedure Every_Byte_Of_A_Small_Image is
      subtype Small_Image is Image (0 .. 31);
      Right : Small_Image;
      Sums  : Sum := First_Value;

      --  A whole pass finds the image good.
      function Is_Good (Spoilt : Small_Image) return Boolean;

      function Is_Good (Spoilt : Small_Image) return Boolean is
         package Small_Checks is new URVOS.ROM_Checks (Small_Image'Last);
         use Small_Checks;
         State   : Check := New_Check;
         Outcome : Outcome_Kind := Under_Way;
      begin
         for Data of Spoilt loop
            Take_Long (State, Data, Outcome);
         end loop;
         Expect ("passes", State.Good_Passes + State.Bad_Passes, 1);
         return Outcome = Found_Good;
      end Is_Good;

      Spoilt : Small_Image;
   begin
      for I in Right'First .. Right'Last - 2 loop
         Right (I) := Long_At (Bytes_Per_Long * Byte_Address (I));
         Sums := Next (Sums, Right (I));
      end loop;
      for Place in Kept_Place loop
         Right (Right'Last - 1 + Long_Address (Place)) :=
           Kept_Long (Sums, Place);
      end loop;
      Expect ("the image is good", Is_Good (Right), True);

      for I in Right'Range loop
         Spoilt := Right;
         for Place in 0 .. 3 loop
            for Flips in Long range 1 .. 255 loop
               Spoilt (I) := Right (I) xor Shift_Left (Flips, 8 * Place);
               Expect
                 ("long" & I'Image & " is missed", Is_Good (Spoilt), False);
            end loop;
         end loop;
      end loop;
   end Every_Byte_Of_A_Small_Image;

   procedure Bytes_Of_The_Whole_Image is
   begin
      Repair (1);
      Expect ("the image is good", ROM_Is_Good, True);
      for Where in ROM_Address loop
         if Where mod 499 = 0 or else Where > ROM_Address'Last - 9 then
            Spoil_ROM (1, Where, Byte (Where mod 255) + 1);
            Expect ("byte" & Where'Image & " is missed", ROM_Is_Good, False);
            Repair (1);
         end if;
      end loop;
   end Bytes_Of_The_Whole_Image;

   procedure Blank_Images is
   begin
      for Data in Byte loop
         Blank_ROM (1, Data);
         Expect ("a ROM of" & Data'Image & " passes", ROM_Is_Good, False);
      end loop;
      Blank_ROM (1, 16#FF#);
      Expect_Start ("erased", Failure (URVOS.Self_Tests.ROM));
      Blank_ROM (1, 0);
      Expect_Start ("zeros", Failure (URVOS.Self_Tests.ROM));
      Repair (1);
   end Blank_Images;

   procedure Three_Wrong_Bits is
      --  The places of the wrong bits, from a simple generator.
      State : Long := 7;
      function New_Place return ROM_Address;

      function New_Place return ROM_Address is
      begin
         State := State * 1_664_525 + 1_013_904_223;
         return ROM_Address (Shift_Right (State, 16));
      end New_Place;

      Where, Other : ROM_Address;
   begin
      for Wrong in 2 .. 3 loop
         for Run in 1 .. 50 loop
            Repair (1);
            for Bit in 1 .. Wrong loop
               Where := New_Place;
               Spoil_ROM
                 (1, Where, Shift_Left (1, Natural (State / 2 ** 8 mod 8)));
            end loop;
            Expect
              ("wrong bits:" & Wrong'Image & " are missed", ROM_Is_Good,
               False);
         end loop;
      end loop;

      --  The same change of two longs keeps their parity.
      for Run in 1 .. 50 loop
         Repair (1);
         Where := New_Place;
         Other := New_Place / 4 * 4 + Where mod 4;
         if Where /= Other then
            Spoil_ROM (1, Where, 16#5A#);
            Spoil_ROM (1, Other, 16#5A#);
            Expect ("two longs are missed", ROM_Is_Good, False);
         end if;
      end loop;
      Repair (1);
   end Three_Wrong_Bits;

   procedure Single_Cells is
   begin
      for Cell in Cell_Number loop
         for Value in Bit_Value loop
            Expect_Found
              ("stuck",
               (Stuck, Place_Of (Cell), Place_Of (Cell), 1, Value));
            Expect_Found
              ("no transition",
               (No_Transition, Place_Of (Cell), Place_Of (Cell), 1, Value));
         end loop;
      end loop;
      Repair (1);
   end Single_Cells;

   procedure Coupled_Cells is
   begin
      for Cell in Cell_Number loop
         for Source in Cell_Number loop
            if Cell /= Source then
               for Edge in Bit_Value loop
                  Expect_Found
                    ("inversion",
                     (Inversion, Place_Of (Cell), Place_Of (Source), Edge,
                      0));
                  for Value in Bit_Value loop
                     Expect_Found
                       ("idempotent",
                        (Idempotent, Place_Of (Cell), Place_Of (Source),
                         Edge, Value));
                     Expect_Found
                       ("state",
                        (State_Coupling, Place_Of (Cell), Place_Of (Source),
                         Edge, Value));
                  end loop;
               end loop;
            end if;
         end loop;
      end loop;
      Repair (1);
   end Coupled_Cells;

   procedure Linked_Cells is
      --  Two changes disturb one cell, by one other cell or by two, on either
      --  side of it, so one fault may undo the effect of the other.
      Missed : Natural := 0;
      All_Of : Natural := 0;

      --  Between equal bits of two words.
      function Word_Fault
        (Kind         : Fault_Kind;
         Cell, Source : RAM_Address;
         Edge, Value  : Bit_Value) return Fault
      is
        ((Kind, (Cell, 3), (Source, 3), Edge, Value));

      procedure Try (First, Second : Fault);

      procedure Try (First, Second : Fault) is
      begin
         --  Two faults from one change of one cell are one fault, possibly
         --  none.
         if First.Source /= Second.Source
           or else First.Edge /= Second.Edge
         then
            All_Of := All_Of + 1;
            if not Is_Found (First, Second) then
               Missed := Missed + 1;
            end if;
         end if;
      end Try;

   begin
      for Cell in RAM_Address range 0 .. Small_Last loop
         for First in RAM_Address range 0 .. Small_Last loop
            for Second in RAM_Address range 0 .. Small_Last loop
               if Cell /= First and then Cell /= Second then
                  for Edge_1 in Bit_Value loop
                     for Edge_2 in Bit_Value loop
                        for Value in Bit_Value loop
                           Try
                             (Word_Fault
                                (Idempotent, Cell, First, Edge_1, Value),
                              Word_Fault
                                (Idempotent, Cell, Second, Edge_2,
                                 1 - Value));
                        end loop;
                     end loop;
                  end loop;
               end if;
            end loop;
         end loop;
      end loop;
      Repair (1);
      Expect_Number
        ("linked faults", All_Of, 6 * 5 * 4 * 8 + 6 * 5 * 4);
      Expect_Number ("missed", Missed, 0);
   end Linked_Cells;

   procedure Wrong_Decoding is
      Start : constant Bit_Place := (0, 0);
   begin
      for Where in RAM_Address range 0 .. Small_Last loop
         for Value in Bit_Value loop
            Expect_Found
              ("no cells", (No_Cells, (Where, 0), Start, 1, Value));
         end loop;
         for Other in RAM_Address range 0 .. Small_Last loop
            if Other /= Where then
               Expect_Found
                 ("other cells",
                  (Other_Cells, (Where, 0), (Other, 0), 1, 0));
               for Value in Bit_Value loop
                  Expect_Found
                    ("both cells",
                     (Both_Cells, (Where, 0), (Other, 0), 1, Value));
               end loop;
            end if;
         end loop;
      end loop;
      Repair (1);
   end Wrong_Decoding;

   procedure Faults_In_All_The_RAM is
      Where : RAM_Address;
      Bit   : Bit_Number;
      Line  : Word_Address := 1;
   begin
      for Number in 0 .. 40 loop
         Where := RAM_Address (Number * 8_191 / 40);
         Bit := Bit_Number (Number mod 16);
         for Value in Bit_Value loop
            Expect_Found_In_All
              ("stuck", (Stuck, (Where, Bit), (0, 0), 1, Value));
            Expect_Found_In_All
              ("no transition",
               (No_Transition, (Where, Bit), (0, 0), 1, Value));
         end loop;
      end loop;

      --  A broken address line, and coupled cells with addresses that this
      --  line distinguishes.
      while Line <= Last_RAM_Word loop
         Expect_Found_In_All
           ("line", (Other_Cells, (Line, 0), (0, 0), 1, 0));
         Expect_Found_In_All
           ("line", (Both_Cells, (0, 0), (Line, 0), 1, 1));
         for Edge in Bit_Value loop
            Expect_Found_In_All
              ("inversion", (Inversion, (Line, 5), (0, 5), Edge, 0));
            Expect_Found_In_All
              ("idempotent", (Idempotent, (0, 9), (Line, 2), Edge, Edge));
         end loop;
         Line := Line * 2;
      end loop;
      Repair (1);
   end Faults_In_All_The_RAM;

   procedure Zeros_After is
      Sound : Boolean;
      Where : Word_Address;
      Data  : Word;
   begin
      Repair (1);
      for Place in RAM_Address loop
         Memories.Write_RAM (Place, 16#1234#);
      end loop;
      Accesses := 0;
      Whole.Run (Sound, Where);
      Expect ("passes", Sound, True);
      Expect_Number ("accesses", Accesses, 34 * 8_192);
      for Place in RAM_Address loop
         Memories.Read_RAM (Place, Data);
         Expect ("word" & Place'Image, Data, 0);
      end loop;
   end Zeros_After;

   procedure Thousand_Starts is
   begin
      Repair (1);

      --  A fault of another board does not concern this one.
      Spoil_ROM (2, 100, 1);
      Plant (2, (Stuck, (7, 7), (0, 0), 1, 1));
      for Number in 1 .. 1_000 loop
         Expect_Start ("start" & Number'Image, All_Passed);
      end loop;
      Repair (2);
   end Thousand_Starts;

   procedure Order_Of_Tests is
      Broken : constant Fault := (Stuck, (16#1235#, 3), (0, 0), 1, 1);
   begin
      Repair (1);
      Spoil_ROM (1, 0, 16#80#);
      Plant (1, Broken);
      Accesses := 0;
      Expect_Start ("both", Failure (URVOS.Self_Tests.ROM));
      Expect_Number ("accesses to the RAM", Accesses, 0);
      Repair (1);
      Plant (1, Broken);
      Expect_Start ("RAM", Failure (URVOS.Self_Tests.RAM, 16#1235#));
      Repair (1);
      Expect_Start ("repaired", All_Passed);
   end Order_Of_Tests;

   procedure Operands_Are_Looked_At is
      Seen : array (Processor_Test) of Natural := (others => 0);
      Here : Boolean;
   begin
      for Test in Processor_Test loop
         Expect (Test'Image, Passes (Test, Known_Operands), True);
      end loop;
      Expect
        ("nothing to divide by",
         Passes (Arithmetic, (Known_Operands with delta Seven => 0)), False);
      for Name in Operand_Name loop
         for Bit in 0 .. 15 loop
            Here := False;
            for Test in Processor_Test loop
               if not Passes
                 (Test,
                  (Known_Operands with delta
                     Name => Known_Operands (Name)
                       xor Shift_Left (Word (1), Bit)))
               then
                  Seen (Test) := Seen (Test) + 1;
                  Here := True;
               end if;
            end loop;
            Expect
              (Name'Image & ", bit" & Bit'Image & " is seen", Here, True);
         end loop;
      end loop;
      for Test in Processor_Test loop
         Expect
           (Test'Image & " looks at its operands", Seen (Test) > 0,
            Test /= Floating_Point);
      end loop;

      --  A bit that cannot be cleared is found even if it was set, changed and
      --  read back correctly.
      Expect
        ("a bit that stays",
         Passes
           (Bit_Manipulation,
            (Known_Operands with delta
               Zero => 1, One => 2, Pattern => 16#A5C2#)),
         False);
   end Operands_Are_Looked_At;

   procedure Slices is
   begin
      Repair (1);
      Clear_Results;
      In_Flight.Initialise;
      for Frame in 1 .. 3 * 512 loop
         In_Flight.Run_Transaction;
         Expect_Number ("results", Results, Frame / 512);
      end loop;
      Expect ("good passes", Good, 3);
      Expect ("bad passes", Bad, 0);

      --  For any slice, a pass ends with the last long.
      Clear_Results;
      Long_By_Long.Initialise;
      Odd.Initialise;
      for Frame in 1 .. 16_384 loop
         Long_By_Long.Run_Transaction;
         Expect_Number ("results", Results, Frame / 16_384);
      end loop;
      Clear_Results;
      for Frame in 1 .. 200 loop
         Odd.Run_Transaction;
         Expect_Number ("results", Results, Frame * 250 / 16_384);
      end loop;
      Expect ("good passes", Good, 3);
      Expect_Number ("reports", Reports, 0);
      Expect ("status", Status.Contents, 0);
   end Slices;

   procedure Failure_In_Flight is
   begin
      Repair (1);
      Clear_Results;
      In_Flight.Initialise;
      for Frame in 1 .. 5 * 512 loop
         if Frame = 512 + 300 then
            --  This pass is already beyond the byte.
            Spoil_ROM (1, 1_000, 1);
         elsif Frame = 4 * 512 then
            --  This pass has already read it.
            Repair (1);
         elsif Frame = 4 * 512 + 100 then
            --  The march in flight has found a cell.
            Status.Write (ROM_Differs or URV.Buffers.Self_Test_Failed);
         end if;
         In_Flight.Run_Transaction;
         Expect_Number
           ("reports in frame" & Frame'Image, Reports,
            (if Frame < 3 * 512 then 0 elsif Frame < 4 * 512 then 1 else 2));
         Expect
           ("status in frame" & Frame'Image, Status.Contents,
            (if Frame < 3 * 512 then 0
             elsif Frame < 4 * 512 + 100 then ROM_Differs
             else ROM_Differs or URV.Buffers.Self_Test_Failed));
      end loop;
      Expect ("good passes", Good, 3);
      Expect ("bad passes", Bad, 2);
      Expect ("detail", Failures.Last_Detail, 2);
      In_Flight.Initialise;
      for Frame in 1 .. 512 loop
         In_Flight.Run_Transaction;
      end loop;
      Expect ("good passes after a start", Good, 1);
      Expect ("bad passes after a start", Bad, 0);
   end Failure_In_Flight;

   procedure Result_Words is
   begin
      Expect ("all well", To_Word (All_Passed), 0);
      Expect ("ROM", To_Word (Failure (URVOS.Self_Tests.ROM)), 16#1000#);
      Expect
        ("RAM", To_Word (Failure (URVOS.Self_Tests.RAM, 16#1FFF#)),
         16#21FF#);
      Expect
        ("far RAM", To_Word (Failure (URVOS.Self_Tests.RAM, 16#7F_FFFF#)),
         16#2FFF#);
      Expect ("registers", To_Word (Failure (Registers)), 16#C000#);
   end Result_Words;

   --  A small memory, two cells a tick: 5 cells of scratchpad and 4 of
   --  variables.
   procedure Walk_In_Flight is
      Parts : constant Part_Sizes := (Scratchpad => 5, Variables => 4);
      Now   : Walk;
      Seen  : array (Part_Name, Cell_Count range 0 .. 4) of Natural :=
        (others => (others => 0));
      Here  : Place;
   begin
      Expect ("has a cell before the first tick", Has_Cell (Now), False);
      for Tick in 1 .. 9 loop
         Now := After_Tick (Now, Cells => 2);
         while Has_Cell (Now) loop
            Here := Place_Of (Now.Next, Parts);
            Seen (Here.Part, Here.Cell) := Seen (Here.Part, Here.Cell) + 1;
            Now := After_Cell (Now, Parts);
         end loop;
      end loop;
      for Part in Part_Name loop
         for Cell in Cell_Count range 0 .. 4 loop
            Expect_Number
              (Part'Image & Cell'Image, Seen (Part, Cell),
               (if Cell < Parts (Part) then 2 else 0));
         end loop;
      end loop;
      Expect_Number ("begins again", Natural (Now.Next), 0);
      Expect_Number ("address of a word", Natural (Word_Of (7)), 14);
   end Walk_In_Flight;

   procedure Add_To
     (Suite : AUnit.Test_Suites.Access_Test_Suite; Briefly : Boolean) is
   begin
      Add
        (Suite, "TST-1 the sums of three longs are known",
         Known_Answer'Access);
      Add
        (Suite, "TST-1 every change of every byte of an image is found",
         Every_Byte_Of_A_Small_Image'Access);
      Add
        (Suite, "TST-1 a changed byte anywhere in the ROM is found",
         Bytes_Of_The_Whole_Image'Access);
      Add
        (Suite, "TST-1 an erased or absent ROM is found",
         Blank_Images'Access);
      Add
        (Suite, "TST-1 two or three wrong bits, or equal changes, are found",
         Three_Wrong_Bits'Access);
      Add
        (Suite, "TST-1 stuck and unchanging cells of the RAM are found",
         Single_Cells'Access);
      Add
        (Suite, "TST-1 any coupling of any two cells of the RAM is found",
         Coupled_Cells'Access);
      Add
        (Suite, "TST-1 two couplings that hide each other are found",
         Linked_Cells'Access);
      Add
        (Suite, "TST-1 wrong address decoding in the RAM is found",
         Wrong_Decoding'Access);
      Add
        (Suite, "TST-1 faults anywhere in 16 KiB are found, with the word",
         Faults_In_All_The_RAM'Access);
      Add
        (Suite, "TST-1 D-17 the RAM is left zeros, after 34 accesses a word",
         Zeros_After'Access);
      if not Briefly then
         Add
           (Suite, "TST-1 1000 starts raise no false alarm",
            Thousand_Starts'Access);
      end if;
      Add
        (Suite, "TST-1 ROM before RAM before processor, TST-4 and where",
         Order_Of_Tests'Access);
      Add
        (Suite, "TST-2 each test of the processor looks at its operands",
         Operands_Are_Looked_At'Access);
      Add
        (Suite, "TST-3 slices of any length make the same passes",
         Slices'Access);
      Add
        (Suite, "TST-3 a ROM that fails in flight is found in a pass or two",
         Failure_In_Flight'Access);
      Add
        (Suite, "TST-4 a result is a word with the test and the place",
         Result_Words'Access);
      Add
        (Suite, "TST-5 the walk comes to each cell of both parts once a pass",
         Walk_In_Flight'Access);
   end Add_To;

end Self_Test_Tests;
