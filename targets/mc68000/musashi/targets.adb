--  SPDX-License-Identifier: Apache-2.0

--  The MC68000's board as board.c emulates it (BRD-4, D-83): two MC68681, the
--  converter's and the servos' boards, and registers of the emulator for the
--  settings of a flight and for its record.
--
--  The timer of the first MC68681 gives the character times, that of the
--  second one the ticks. The receiver's characters are taken at each character
--  time: its interrupt would cost as much again, and it holds four.

with Machine_Texts;           use Machine_Texts;
with MC68681;                 use MC68681;
with MC68681.Channels;        use MC68681.Channels;
with MC68681.Registers;
with MC68681.Timers;          use MC68681.Timers;
with Stack_Marks;
with System.Storage_Elements; use System.Storage_Elements;

package body Targets is

   --  The handlers; see targets.ads

   procedure On_Tick
   with Import, Convention => C, External_Name => "urv_tick";
   procedure On_Character_Time
   with Import, Convention => C, External_Name => "urv_character_time";
   procedure On_Character (Data : Unsigned_32; Damaged : Unsigned_32)
   with Import, Convention => C, External_Name => "urv_character";
   procedure On_Free_Sender
   with Import, Convention => C, External_Name => "urv_free_sender";
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

   --  Interrupts by vector, as in start.s

   Line_Vector  : constant Byte := 16#41#;
   Clock_Vector : constant Byte := 16#42#;

   --  The chips' clock has 4 MHz: 96 us, 2 ms. The timer takes half of it.
   Counts_Per_Character : constant := 4 * 96 / 2;
   Counts_Per_Tick      : constant := 4 * 2_000 / 2;

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
      Stop_Time  : Board_Word;    --  1: no time passes
      End_Run    : Board_Word;
   end record;

   Emulator : Emulator_Board
   with Import, Volatile, Address => To_Address (16#F3_0000#);

   Ticks     : Unsigned_32 := 0;
   Has_Begun : Boolean     := False;

   --  The line's errors since power up.
   Errors : Error_Counts;

   procedure On_Line
   with Export, Convention => C, External_Name => "urv_line_interrupt";

   procedure On_Clock
   with Export, Convention => C, External_Name => "urv_clock_interrupt";

   procedure On_Converter
   with Export, Convention => C, External_Name => "urv_converter_interrupt";

   procedure End_Run;

   --  Gives the board this character, and those that have come after it.
   procedure Hear (Data : Byte; Is_Damaged : Boolean);
   pragma No_Inline (Hear);

   procedure Put_Errors;

   procedure Open is
   begin
      Set_Up (Line);
      MC68681.Registers.Write_Command (Console, Switch_On_Sender);
      Converter.Vector := Board_Word (Devices.AD_Board.Interrupt_Vector);
      Converter.Interrupt := 1;
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
      MC68681.Timers.Start (Line_Chip, Counts_Per_Character);
      Use_Interrupts (Clock_Chip, Clock_Vector, Receiver => False);
      Use_Interrupts (Line_Chip, Line_Vector, Receiver => False);
      Restore (16#2000#);
   end Start_Clock;

   procedure Put_Errors is
   begin
      Put ("line");
      Put_Labelled ("lost_characters", Unsigned_32 (Errors.Overruns));
      Put_Labelled ("parity_errors", Unsigned_32 (Errors.Parity_Errors));
      Put_Labelled ("framing_errors", Unsigned_32 (Errors.Framing_Errors));
      Put_Line;
   end Put_Errors;

   procedure End_Run is
   begin
      Emulator.Stop_Time := 1;
      Put_Counts;
      Put_Errors;
      Emulator.End_Run := 1;
   end End_Run;

   --  Apart, so that the usual path saves and restores fewer registers.
   procedure Hear (Data : Byte; Is_Damaged : Boolean) is
      Result : Reception;
   begin
      On_Character (Unsigned_32 (Data), (if Is_Damaged then 1 else 0));
      loop
         Receive (Line, Errors, Result);
         exit when not Result.Is_There;
         On_Character
           (Unsigned_32 (Result.Data),
            (if MC68681.Channels.Is_Damaged (Result) then 1 else 0));
      end loop;
   end Hear;

   procedure On_Line is
      Is_Due : Boolean;
      Result : Reception;
   begin
      Take_Period (Line_Chip, Is_Due);
      if not Is_Due then
         return;
      end if;
      On_Character_Time;
      Receive (Line, Errors, Result);
      if Result.Is_There then
         Hear (Result.Data, Is_Damaged (Result));
      end if;
      if Result.Sender_Is_Free then
         On_Free_Sender;
      end if;
   end On_Line;

   procedure On_Clock is
      Unused_Is_Due : Boolean;
   begin
      Take_Period (Clock_Chip, Unused_Is_Due);
      Ticks := Ticks + 1;
      if Emulator.Is_Over = 1 then
         End_Run;
      end if;
      if Ticks mod 10 = 0 then
         Emulator.Stop_Time := 1;
         Put ("row");
         Put_Labelled ("frame", Ticks / 10 - 1);
         Put_Row;
         Emulator.Stop_Time := 0;
      end if;
      On_Tick;
   end On_Clock;

   procedure On_Converter is
   begin
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
