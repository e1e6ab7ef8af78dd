--  SPDX-License-Identifier: Apache-2.0

with Devices.Memory_Bus;          use Devices.Memory_Bus;
with Devices.Processor_Memories;
with Last_Chance;
pragma Unreferenced (Last_Chance);
with Line_Programs;
with Machine_Needs;
pragma Unreferenced (Machine_Needs);
with Machine_Texts;               use Machine_Texts;
with MC68681;                     use MC68681;
with MC68681.Channels;            use MC68681.Channels;
with MC68681.Registers;
with MC68681.Timers;              use MC68681.Timers;
with System.Storage_Elements;     use System.Storage_Elements;
with Power_Up_Tests;
pragma Unreferenced (Power_Up_Tests);
with Targets;
with Telemetry.Boards.Dual_Ported; use Telemetry.Boards.Dual_Ported;
with URVOS;                       use URVOS;
with URVOS.Self_Tests;            use URVOS.Self_Tests;
with URVOS.Start_Tests;
with URVOS.Starts;                use URVOS.Starts;

package body Telemetry_Board_Program is

   --  The interrupt's vector, as in start.s
   Line_Vector : constant Byte := 16#41#;

   --  The chip's clock has 4 MHz: 96 us. The timer takes half of it.
   Counts_Per_Character : constant := 4 * 96 / 2;

   --  The reason of a restart because the controller initialises the memory.
   Memory_Is_Taken : constant := 32;

   Kept : array (0 .. 3) of Unsigned_32
   with Volatile, Import, Convention => C, External_Name => "urv_kept";

   --  The emulator's registers: 1 when the flight is over, and the end

   Is_Over : Unsigned_32
   with Import, Volatile, Address => To_Address (16#F3_0008#);

   End_Run : Unsigned_16
   with Import, Volatile, Address => To_Address (16#F3_000E#);

   --  The line's errors since power up.
   Errors : Error_Counts;

   --  All work is done in interrupts.
   procedure Serve_Interrupts
   with
     Import,
     Convention    => C,
     External_Name => "urv_serve_interrupts",
     No_Return;

   package Line_Turns is new Line_Programs (Accept_Character, Next_Character);

   --  The tests of ROM, scratchpad and processor, as on the controller.

   package Memories is new Devices.Processor_Memories (Board => 1);

   package Tests is new URVOS.Start_Tests
     (Last_Long => Last_ROM_Long,
      Last_Word => Last_RAM_Word,
      Read_ROM  => Memories.Read_ROM,
      Read_RAM  => Memories.Read_RAM,
      Write_RAM => Memories.Write_RAM);

   --  A board that fails a test stops: it sends nothing, and does not touch
   --  the dual-ported memory.
   procedure Test (Condition : Integer_32);

   --  Gives the board the characters that have come. Then it may speak.
   procedure Hear (First : Arrival);
   pragma No_Inline (Hear);

   procedure Hear_Faulty;
   pragma No_Inline (Hear_Faulty);

   --  The sender is free: the board speaks if it has its turn.
   procedure Look_For_Turn
   with Inline;

   procedure Speak;
   pragma No_Inline (Speak);

   procedure Put_Errors;
   pragma No_Inline (Put_Errors);

   --  Rare paths are apart, so that the usual path saves and restores no
   --  registers.

   procedure Speak is
   begin
      Line_Turns.Take_Turn;
      if Is_Over /= 0 then
         Put_Errors;
      end if;
   end Speak;

   procedure Look_For_Turn is
   begin
      if Has_News then
         Line_Turns.Hurry;
      end if;
      if Line_Turns.Is_Due then
         Speak;
      end if;
   end Look_For_Turn;

   procedure Hear_Faulty is
      Result : Reception;
   begin
      Receive (Line, Errors, Result);
      if Result.Is_There then
         Line_Turns.Hear (Result.Data, Is_Damaged (Result));
      end if;
   end Hear_Faulty;

   procedure Hear (First : Arrival) is
      Next           : Arrival := First;
      Data           : Byte;
      Sender_Is_Free : Boolean;
   begin
      loop
         if Next = Good then
            Take (Line, Data);
            Line_Turns.Hear (Data, Is_Damaged => False);
         else
            Hear_Faulty;
         end if;
         Look (Line, Next, Sender_Is_Free);
         exit when Next = Nothing;
      end loop;
      --  News can wait for a character time without a character.
      if Sender_Is_Free and then Line_Turns.Is_Due then
         Speak;
      end if;
   end Hear;

   procedure Put_Errors is
   begin
      Put ("line");
      Put_Labelled ("lost_characters", Unsigned_32 (Errors.Overruns));
      Put_Labelled ("parity_errors", Unsigned_32 (Errors.Parity_Errors));
      Put_Labelled ("framing_errors", Unsigned_32 (Errors.Framing_Errors));
      Put_Line;
      End_Run := 1;
   end Put_Errors;

   procedure On_Line is
      Is_Due         : Boolean;
      First          : Arrival;
      Sender_Is_Free : Boolean;
   begin
      Take_Period (Line_Chip, Is_Due);
      if not Is_Due then
         return;
      end if;
      if Is_Taken then
         Targets.Restart_Processor (Memory_Is_Taken);
      end if;
      Targets.Feed_Watchdog;
      Line_Turns.Count_Character_Time;
      Look (Line, First, Sender_Is_Free);
      if First /= Nothing then
         Hear (First);
      elsif Sender_Is_Free then
         Look_For_Turn;
      end if;
   end On_Line;

   procedure Test (Condition : Integer_32) is
      Result : Test_Result;
   begin
      Tests.Run
        ((case Condition is
             when 0      => Cold_Start,
             when 1      => Warm_Reset,
             when others => Processor_Restart),
         Result);
      if not Result.Passed then
         Put ("telemetry board refused,");
         Put_Labelled ("test", Unsigned_32 (Test_Number (Result.Failed)));
         Put_Line;
         Targets.Stop;
      end if;
   end Test;

   procedure Run (Condition : Integer_32) is
   begin
      Set_Up (Line);
      MC68681.Registers.Write_Command (Console, Switch_On_Sender);
      if Kept (3) > 0 then
         Put ("restarts");
         Put_Labelled ("count", Kept (3));
         Put_Labelled ("reason", Kept (2));
         Put_Line;
      end if;
      Test (Condition);
      while not Is_Ready loop
         null;
      end loop;
      Recover;
      Start;
      Put_Line
        (if Condition = 0 then "telemetry board cold start"
         elsif Condition = 1 then "telemetry board warm reset"
         else "telemetry board processor restart");
      MC68681.Timers.Start (Line_Chip, Counts_Per_Character);
      Use_Interrupts (Line_Chip, Line_Vector, Receiver => False);
      Serve_Interrupts;
   end Run;

   procedure Power_Up is
   begin
      Targets.Keep_Memory;
      Run (0);
   end Power_Up;

end Telemetry_Board_Program;
