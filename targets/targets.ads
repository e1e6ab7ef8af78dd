--  SPDX-License-Identifier: Apache-2.0

--  The machine of a node (BRD-1). Each machine's folder has a body of this
--  specification. Its start.s and image.ld have the vectors, the start-up and
--  the memory map.
--
--  The machine calls the node at its interrupts, by the names below
--  (Handlers). These calls do not interrupt each other.

with Devices.AD_Board;
with Devices.PWM_Board;
with Interfaces; use Interfaces;
with URVOS;      use URVOS;

package Targets is

   --  Makes lines, converter and servos ready and opens the console. No
   --  interrupt comes yet.
   procedure Open;

   --  From now on the clock ticks every 2 ms, and interrupts are taken.
   procedure Start_Clock;

   --  Handlers, which the node's main program exports:
   --
   --    urv_tick                           each 2 ms
   --    urv_character_time                 each 96 us, before the next two
   --    urv_character (Data, Damaged)      the line has brought a character;
   --                                       Damaged: parity, framing, overrun
   --    urv_free_sender                    each 96 us while the line's sender
   --                                       takes a character
   --    urv_converted (Value)              a conversion has ended

   --  The interrupt mask. Each lock of a protected object uses it.

   type Mask_State is new Integer_32;

   function Mask return Mask_State
   with Import, Convention => C, External_Name => "urv_mask_interrupts";

   procedure Restore (Before : Mask_State)
   with Import, Convention => C, External_Name => "urv_restore_interrupts";

   --  Called once, at power up: all variables have their first values, and the
   --  next reset keeps the memory.
   procedure Keep_Memory;

   --  Sleeps until an interrupt has put the flag up.

   type Flag is (Down, Up) with Size => 8, Volatile;

   procedure Sleep (Awake : not null access Flag);

   --  One indivisible cycle reads the lock and takes it

   type Lock_Byte is new Unsigned_8 with Volatile;

   Free : constant Lock_Byte := 0;

   procedure Test_And_Set (Lock : in out Lock_Byte; Was_Free : out Boolean);

   --  The telemetry line: 125 kbaud, 8 bits, even parity, 2 stop bits

   --  Only urv_free_sender may call it.
   procedure Send (Data : Byte);

   --  Starts a conversion of the analog board. Its interrupt comes 16 us
   --  later.
   procedure Convert (Channel : Devices.AD_Board.Channel_Number)
   with Inline;

   --  The watchdog restarts the processor if this call stays away for 100 ms
   --  (BRD-7). It waits for the first call after a start.
   procedure Feed_Watchdog
   with Inline;

   --  Writes the servos' words.
   procedure Write_Servos (Area : Devices.PWM_Board.Data_Area);

   procedure Put (Text : String);

   --  These two need no variables. Open_Console lets Put write. Stop ends the
   --  program: only power up or the reset switch begins another.

   procedure Open_Console;

   procedure Stop with No_Return;

   --  The largest number of stack bytes ever in use.
   function Stack_Used return Unsigned_32;

   --  Restarts the processor at any point, as after an unexpected interrupt.
   --  Memory and the node's clock are kept.
   procedure Restart_Processor (Reason : Unsigned_32)
   with
     Import,
     Convention    => C,
     External_Name => "urv_restart_processor",
     No_Return;

end Targets;
