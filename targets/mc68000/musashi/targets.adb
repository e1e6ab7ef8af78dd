--  SPDX-License-Identifier: Apache-2.0

--  The MC68000's controller as board.c emulates it (BRD-4, D-83): two MC68681,
--  the converter's and the servos' boards, and registers of the emulator for
--  the settings of a flight and for its record. The first MC68681 has the
--  console; the timer of the second one gives the ticks. The line is on the
--  telemetry board (Telemetry_Board_Program), which uses the console, Sleep
--  and Feed_Watchdog of this package, too.

with Machine_Texts;           use Machine_Texts;
with MC68681;                 use MC68681;
with MC68681.Channels;        use MC68681.Channels;
with MC68681.Registers;
with MC68681.Timers;          use MC68681.Timers;
with Stack_Marks;
with System.Machine_Code;     use System.Machine_Code;
with System.Storage_Elements; use System.Storage_Elements;
with Telemetry.Boards.Dual_Ported;

package body Targets is

   --  The handlers; see targets.ads

   procedure On_Tick
   with Import, Convention => C, External_Name => "urv_tick";
   procedure On_Converted (Value : Unsigned_32)
   with Import, Convention => C, External_Name => "urv_converted";

   procedure Configure (Flags : Unsigned_32; Line_Delay : Unsigned_32)
   with Import, Convention => C, External_Name => "urv_configure";
   procedure Put_Row
   with Import, Convention => C, External_Name => "urv_put_row";
   procedure Put_Counts
   with Import, Convention => C, External_Name => "urv_put_counts";

   procedure Sleep_Until (Awake : not null access Flag)
   with Import, Convention => C, External_Name => "urv_sleep";

   function Take (Lock : access Lock_Byte) return Integer_32
   with Import, Convention => C, External_Name => "urv_test_and_set";

   Kept : array (0 .. 3) of Unsigned_32
   with Volatile, Import, Convention => C, External_Name => "urv_kept";

   Memory_Is_Kept : constant Unsigned_32 := 16#4B45_5054#;   --  "KEPT"

   --  Its interrupt's vector, as in start.s
   Clock_Vector : constant Byte := 16#42#;

   --  The chip's clock has 4 MHz: 2 ms. The timer takes half of it.
   Counts_Per_Tick : constant := 4 * 2_000 / 2;

   --  The converter's board

   type Board_Word is new Unsigned_16 with Volatile;

   type Converter_Board is limited record
      Channel   : Board_Word;   --  a write starts a conversion
      Data      : Board_Word;
      Vector    : Board_Word;
      Interrupt : Board_Word;   --  1: enabled
   end record;

   Converter : Converter_Board
   with Import, Volatile, Address => To_Address (16#F1_0000#);

   Servos : Devices.PWM_Board.Data_Area
   with Import, Volatile, Address => To_Address (16#F2_0000#);

   Watchdog : Board_Word
   with Import, Address => To_Address (16#F4_0000#);

   --  The emulator's registers

   type Emulator_Board is limited record
      Flags      : Unsigned_32;
      Line_Delay : Unsigned_32;
      Is_Over    : Unsigned_32;   --  1 after the flight's time
      Stop_Time  : Board_Word;    --  1: no time passes; read: see Is_Due
      End_Run    : Board_Word;
   end record;

   Emulator : Emulator_Board
   with Import, Volatile, Address => To_Address (16#F3_0000#);

   --  Read at a tick: 0 unless a row of the record is due, or the flight is
   --  over. The emulator counts, so that the processor's time is its own.
   Is_Due : Board_Word renames Emulator.Stop_Time;

   Row_Is_Due : constant Board_Word := 1;

   --  The frame of the flight's record.
   Frame     : Unsigned_32 := 0;
   Has_Begun : Boolean     := False;

   --  The vectors lead here: the compiler saves the registers. The handlers do
   --  not interrupt each other.

   procedure On_Clock
   with Export, Convention => C, External_Name => "urv_on_clock";
   pragma Machine_Attribute (On_Clock, "interrupt_handler");

   procedure On_Converter
   with Export, Convention => C, External_Name => "urv_on_converter";
   pragma Machine_Attribute (On_Converter, "interrupt_handler");

   procedure Mask_Others
   with Inline;

   procedure End_Run;

   --  Puts the row that is due, and ends a flight that is over.
   procedure Serve_Emulator;
   pragma No_Inline (Serve_Emulator);

   procedure Mask_Others is
   begin
      Asm ("move.w #0x2700, %%sr", Volatile => True);
   end Mask_Others;

   procedure Open_Console is
   begin
      MC68681.Registers.Write_Command (Console, Switch_On_Sender);
   end Open_Console;

   procedure Stop is
   begin
      Emulator.End_Run := 1;
      loop
         null;
      end loop;
   end Stop;

   procedure Open is
   begin
      Open_Console;
      Converter.Vector := Board_Word (Devices.AD_Board.Interrupt_Vector);
      Converter.Interrupt := 1;
      Telemetry.Boards.Dual_Ported.Recover;
      if not Has_Begun then
         Configure (Emulator.Flags, Emulator.Line_Delay);
      end if;
      if Kept (3) > 0 then
         Put ("restarts");
         Put_Labelled ("count", Kept (3));
         Put_Labelled ("reason", Kept (2));
         Put_Line;
      end if;
   end Open;

   procedure Keep_Memory is
   begin
      Kept (0) := Memory_Is_Kept;
   end Keep_Memory;

   procedure Start_Clock is
   begin
      Has_Begun := True;
      MC68681.Timers.Start (Clock_Chip, Counts_Per_Tick);
      Use_Interrupts (Clock_Chip, Clock_Vector, Receiver => False);
      Restore (16#2000#);
   end Start_Clock;

   procedure End_Run is
   begin
      Put_Counts;
      Emulator.End_Run := 1;
   end End_Run;

   procedure Serve_Emulator is
      Due : constant Board_Word := Is_Due;
   begin
      if Emulator.Is_Over = 1 then
         End_Run;
      end if;
      if (Due and Row_Is_Due) /= 0 then
         Emulator.Stop_Time := 1;
         Put ("row");
         Put_Labelled ("frame", Frame);
         Put_Row;
         Frame := Frame + 1;
         Emulator.Stop_Time := 0;
      end if;
   end Serve_Emulator;

   procedure On_Clock is
      Unused_Is_Due : Boolean;
   begin
      Mask_Others;
      Take_Period (Clock_Chip, Unused_Is_Due);
      if Is_Due /= 0 then
         Serve_Emulator;
      end if;
      On_Tick;
   end On_Clock;

   procedure On_Converter is
   begin
      Mask_Others;
      On_Converted (Unsigned_32 (Converter.Data));
   end On_Converter;

   procedure Sleep (Awake : not null access Flag) is
   begin
      Sleep_Until (Awake);
   end Sleep;

   procedure Test_And_Set (Lock : in out Lock_Byte; Was_Free : out Boolean) is
      Place : aliased Lock_Byte with Import, Address => Lock'Address;
   begin
      Was_Free := Take (Place'Access) /= 0;
   end Test_And_Set;

   procedure Send (Data : Byte) is
   begin
      MC68681.Channels.Send (Line, Data);
   end Send;

   procedure Convert (Channel : Devices.AD_Board.Channel_Number) is
   begin
      Converter.Channel := Board_Word (Channel);
   end Convert;

   procedure Feed_Watchdog is
   begin
      Watchdog := 0;
   end Feed_Watchdog;

   procedure Write_Servos (Area : Devices.PWM_Board.Data_Area) is
   begin
      Servos := Area;
   end Write_Servos;

   procedure Put (Text : String) is
      Is_Free : Boolean;
   begin
      for Each of Text loop
         loop
            Look_At_Sender (Console, Is_Free);
            exit when Is_Free;
         end loop;
         MC68681.Channels.Send (Console, Character'Pos (Each));
      end loop;
   end Put;

   function Stack_Used return Unsigned_32 renames Stack_Marks.Used;

end Targets;
