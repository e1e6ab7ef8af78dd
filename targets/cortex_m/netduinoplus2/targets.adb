--  SPDX-License-Identifier: Apache-2.0

--  The STM32F405 as QEMU emulates it (-M netduinoplus2, D-82): processor,
--  memory, SysTick and serial ports. The emulated serial ports send a
--  character in no time, and the emulated converter reads nothing. Here
--  SysTick therefore times the line's characters and the converter's
--  conversions.
--
--  The converter's words come from a tape in ROM. The serial ports 2 join two
--  emulators, which fly in lock-step: after each Quantum of character times
--  they exchange the characters of that quantum, while time stops. The line
--  therefore delays each character by Quantum - 1 character times, and the
--  flight is the same on every machine.

with Cortex_SysTick.Timers;
with Machine_Texts;        use Machine_Texts;
with Registers;            use Registers;
with Servo_Outputs;
with Stack_Marks;
with STM32_USART;          use STM32_USART;
with STM32_USART.Channels; use STM32_USART.Channels;
with STM32_USART.Registers;
with STM32_Watchdog.Timers;
with System.Storage_Elements; use System.Storage_Elements;
with Tapes;                use Tapes;

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

   procedure Leave
   with Import, Convention => C, External_Name => "urv_leave", No_Return;

   procedure Wait_For_Interrupt
   with Import, Convention => C, External_Name => "urv_wait";

   procedure Execute_Illegal_Instruction
   with Import, Convention => C, External_Name => "urv_illegal";

   function Take (Lock : access Lock_Byte) return Integer_32
   with Import, Convention => C, External_Name => "urv_test_and_set";

   Kept : array (0 .. 3) of Unsigned_32
   with Volatile, Import, Convention => C, External_Name => "urv_kept";

   Memory_Is_Kept : constant Unsigned_32 := 16#5450_454B#;   --  "KEPT"

   --  Time, in microseconds; character times and ticks begin together

   Cycles_Per_Microsecond : constant := 168;
   Character_Period       : constant := 96;
   Tick_Period            : constant := 2_000;

   --  The next character time and the next tick, with their times.
   Next_Character : Unsigned_32 := Character_Period;
   Next_Tick      : Unsigned_32 := 0;
   Characters     : Unsigned_32 := 0;
   Ticks          : Unsigned_32 := 0;

   --  The time of SysTick's present period, and of the next one.
   Has_Begun : Boolean     := False;

   --  The watchdog was started since the last reset of the chip, which stops
   --  it. It leaves the program at least 100 ms.
   Watchdog_Runs   : Boolean := False;
   Watchdog_Reload : constant STM32_Watchdog.Reload_Value :=
     STM32_Watchdog.Timers.Reload_For (100);
   Now       : Unsigned_32 := 0;
   Then_Time : Unsigned_32 := 0;

   --  The line's bus has 42 MHz, and the line 125 kbaud.
   Cycles_Per_Bit : constant := 42_000 / 125;

   --  The line's errors since power up.
   Errors : Error_Counts;

   --  A quantum of the line: the characters sent, and those received

   type Slot is record
      Is_There : Boolean     := False;
      Data     : Unsigned_32 := 0;
   end record;

   subtype Slot_Number is Unsigned_32 range 0 .. 7;
   type Slots is array (Slot_Number) of Slot;

   Sent, Heard : Slots;

   --  The conversion under way, if any.
   Is_Converting : Boolean                         := False;
   Channel       : Devices.AD_Board.Channel_Number := 0;

   Conversions_Per_Character : constant :=
     Character_Period / Devices.AD_Board.Microseconds_Per_Conversion;

   --  Cycles without work in the present tick, and the figures of the run.
   Idle        : Unsigned_32 := 0;
   Most_Busy   : Unsigned_32 := 0;
   All_Busy    : Unsigned_32 := 0;   --  in units of 16 cycles
   Counted     : Unsigned_32 := 0;

   procedure On_SysTick
   with Export, Convention => C, External_Name => "urv_systick";

   procedure Stop_Time;
   procedure Resume_Time;

   --  The end of the period that begins at this time.
   function Next_Event (After : Unsigned_32) return Unsigned_32;

   procedure Put_On (Port : Port_Name; Data : Byte);
   function Take_From_Line return Unsigned_32;

   --  Waits until the other node's emulator listens. QEMU drops a character
   --  that comes before the port is set up.
   procedure Join;

   --  Exchanges the characters at the end of a quantum.
   procedure Exchange;

   procedure Begin_Character;

   procedure Begin_Tick;

   --  Waits until an interrupt is pending, or plants a fault that is due.
   procedure Wait;

   procedure Count_Busy;

   procedure Put_Pulses;

   procedure End_Run with No_Return;

   procedure Stop_Time is
   begin
      Cortex_SysTick.Timers.Stop;
   end Stop_Time;

   procedure Resume_Time is
   begin
      Cortex_SysTick.Timers.Resume;
   end Resume_Time;

   function Next_Event (After : Unsigned_32) return Unsigned_32 is
     (Unsigned_32'Min
        (After + Character_Period - After mod Character_Period,
         After + Tick_Period - After mod Tick_Period));

   procedure Open_Console is
   begin
      STM32_USART.Registers.Write_Control_1
        (Console, (Port_On | Sender_On => True, others => False));
   end Open_Console;

   procedure Stop is
   begin
      Leave;
   end Stop;

   procedure Open is
   begin
      Open_Console;
      Set_Up (Line, Cycles_Per_Bit, Interrupt => True);
      System_Priorities := SysTick_Last;
      Servo_Outputs.Open;
      Watchdog_Runs := False;
      if not Has_Begun then
         Next_Tick := (1 + Tape.Lag) * Tick_Period;
         Configure (Tape.Flags, Tape.Line_Delay);
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
      if not Has_Begun then
         Has_Begun := True;
         Advance (0);
         if Tape.Quantum > 0 then
            Join;
         end if;
         Then_Time := Next_Event (0);
      end if;
      Cortex_SysTick.Timers.Start
        (Natural (Then_Time - Now) * Cycles_Per_Microsecond);
      Cortex_SysTick.Timers.Set_Next
        (Natural (Next_Event (Then_Time) - Then_Time)
         * Cycles_Per_Microsecond);
      Restore (0);
   end Start_Clock;

   procedure Put_On (Port : Port_Name; Data : Byte) is
      Is_Free : Boolean;
   begin
      loop
         Look_At_Sender (Port, Is_Free);
         exit when Is_Free;
      end loop;
      STM32_USART.Channels.Send (Port, Data);
   end Put_On;

   --  Sleeps until a byte comes, since the emulator has other work meanwhile.
   --  The interrupt wakes the processor but is never taken.
   function Take_From_Line return Unsigned_32 is
      Before : constant Mask_State := Mask;
      Result : Reception;
   begin
      Interrupt_Enable_2 := USART_2_Bit;
      loop
         Receive (Line, Errors, Result);
         exit when Result.Is_There;
         Wait_For_Interrupt;
      end loop;
      Interrupt_Disable_2 := USART_2_Bit;
      Interrupt_Clear_2 := USART_2_Bit;
      Restore (Before);
      return Unsigned_32 (Result.Data);
   end Take_From_Line;

   --  Each node calls until it hears the other, and then answers once. It has
   --  heard the answer: the other has heard it, and its next byte is data.
   procedure Join is
      Call   : constant Byte := 16#C0#;
      Answer : constant Byte := 16#A0#;
      Result : Reception;
      Last   : Unsigned_32;
   begin
      loop
         Put_On (Line, Call);
         for Look in 1 .. 10_000 loop
            Receive (Line, Errors, Result);
            exit when Result.Is_There;
         end loop;
         exit when Result.Is_There;
      end loop;
      Put_On (Line, Answer);
      Last := Unsigned_32 (Result.Data);
      while Last /= Unsigned_32 (Answer) loop
         Last := Take_From_Line;
      end loop;
   end Join;

   --  The first byte has a bit for each character sent. The characters follow.
   procedure Exchange is
      Bits : Unsigned_32 := 0;
   begin
      Stop_Time;
      for Place in Slot_Number loop
         if Sent (Place).Is_There then
            Bits := Bits or Shift_Left (1, Natural (Place));
         end if;
      end loop;
      Put_On (Line, Byte (Bits));
      for Each of Sent loop
         if Each.Is_There then
            Put_On (Line, Byte (Each.Data));
         end if;
      end loop;
      Sent := (others => <>);
      Heard := (others => <>);
      Bits := Take_From_Line;
      for Place in Slot_Number loop
         if (Bits and Shift_Left (1, Natural (Place))) /= 0 then
            Heard (Place) := (True, Take_From_Line);
         end if;
      end loop;
      if Characters >= Tape.Length then
         End_Run;
      end if;
      Resume_Time;
   end Exchange;

   procedure Begin_Character is
      Place : Unsigned_32;
   begin
      Characters := Characters + 1;
      if Tape.Quantum > 0 then
         Place := Characters mod Tape.Quantum;
         if Place = 0 then
            Exchange;
         end if;
      else
         Place := 0;
         Heard := (others => <>);
         if Characters >= Tape.Length then
            End_Run;
         end if;
      end if;
      On_Character_Time;
      if Heard (Place).Is_There then
         On_Character (Heard (Place).Data, 0);
      end if;
      On_Free_Sender;
      for Number in 1 .. Conversions_Per_Character loop
         exit when not Is_Converting;
         Is_Converting := False;
         On_Converted (Unsigned_32 (Word_Now (Natural (Channel))));
      end loop;
   end Begin_Character;

   procedure Count_Busy is
      Busy : constant Unsigned_32 :=
        Tick_Period * Cycles_Per_Microsecond - Idle;
   begin
      --  Omit the frame in which the run begins.
      if Ticks > 10 then
         Most_Busy := Unsigned_32'Max (Most_Busy, Busy);
         All_Busy := All_Busy + Busy / 16;
         Counted := Counted + 1;
      end if;
      Idle := 0;
   end Count_Busy;

   procedure Begin_Tick is
   begin
      Ticks := Ticks + 1;
      Count_Busy;
      Stop_Time;
      Advance (Ticks);
      if Ticks mod 10 = 0 then
         Put ("row");
         Put_Labelled ("frame", Ticks / 10 - 1);
         Put_Row;
      end if;
      Resume_Time;
      On_Tick;
   end Begin_Tick;

   --  SysTick has already reloaded the period that begins now. This value sets
   --  the one after it.
   procedure On_SysTick is
   begin
      Now := Then_Time;
      Then_Time := Next_Event (Now);
      Cortex_SysTick.Timers.Set_Next
        (Natural (Next_Event (Then_Time) - Then_Time)
         * Cycles_Per_Microsecond);
      if Now >= Next_Character then
         Next_Character := Next_Character + Character_Period;
         Begin_Character;
      end if;
      if Now >= Next_Tick then
         Next_Tick := Next_Tick + Tick_Period;
         Begin_Tick;
      end if;
   end On_SysTick;

   --  The lengths of the servos' pulses, in microseconds, as their timers have
   --  them.
   procedure Put_Pulses is
      type Compare_Registers is array (Unsigned_32 range 0 .. 3) of Register;
      type Timer_Number is mod 4;
   begin
      Put ("pulses");
      for Timer in Timer_Number loop
         declare
            Compare : Compare_Registers
            with
              Import,
              Address =>
                To_Address (16#4000_0034# + 16#400# * Integer_Address (Timer));
         begin
            for Each of Compare loop
               Put_Word (Unsigned_16 (Each and 16#FFFF#));
            end loop;
         end;
      end loop;
      Put_Line;
   end Put_Pulses;

   procedure End_Run is
   begin
      Put_Counts;
      Put_Pulses;
      Put ("cycles");
      Put_Labelled ("worst", Most_Busy);
      Put_Labelled
        ("mean", (if Counted = 0 then 0 else All_Busy / Counted * 16));
      Put_Labelled ("ticks", Ticks);
      Put_Line;
      Leave;
   end End_Run;

   --  Masked interrupts wake the processor, and are taken after Restore.
   procedure Sleep (Awake : not null access Flag) is
      Before : Mask_State;
   begin
      loop
         Before := Mask;
         exit when Awake.all = Up;
         Wait;
         Restore (Before);
      end loop;
      Restore (Before);
   end Sleep;

   procedure Wait is
      Left : Natural;
   begin
      case Event_Now is
         when None =>
            if (Interrupt_State and SysTick_Pending) = 0 then
               Cortex_SysTick.Timers.Look (Left);
               Idle := Idle + Unsigned_32 (Left);
            end if;
            Wait_For_Interrupt;

         when Illegal_Instruction =>
            Forget_Event;
            Execute_Illegal_Instruction;

         when Unexpected_Interrupt =>
            Forget_Event;
            Interrupt_Enable_1 := 2 ** 7;
            Interrupt_Trigger := 7;
            Restore (0);
      end case;
   end Wait;

   procedure Test_And_Set (Lock : in out Lock_Byte; Was_Free : out Boolean) is
      Place : aliased Lock_Byte with Import, Address => Lock'Address;
   begin
      Was_Free := Take (Place'Access) /= 0;
   end Test_And_Set;

   procedure Send (Data : Byte) is
      Place : constant Unsigned_32 :=
        (if Tape.Quantum = 0 then 0 else Characters mod Tape.Quantum);
   begin
      Sent (Place) := (True, Unsigned_32 (Data));
   end Send;

   procedure Convert (Channel : Devices.AD_Board.Channel_Number) is
   begin
      Targets.Channel := Channel;
      Is_Converting := True;
   end Convert;

   --  QEMU ignores the watchdog's registers.
   procedure Feed_Watchdog is
   begin
      if Watchdog_Runs then
         STM32_Watchdog.Timers.Feed;
      else
         STM32_Watchdog.Timers.Start (Watchdog_Reload);
         Watchdog_Runs := True;
      end if;
   end Feed_Watchdog;

   procedure Write_Servos (Area : Devices.PWM_Board.Data_Area) is
   begin
      Servo_Outputs.Write (Area);
   end Write_Servos;

   procedure Put (Text : String) is
   begin
      for Each of Text loop
         Put_On (Console, Character'Pos (Each));
      end loop;
   end Put;

   function Stack_Used return Unsigned_32 renames Stack_Marks.Used;

end Targets;
