--  SPDX-License-Identifier: Apache-2.0

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
with Targets;
with Telemetry.Boards.Dual_Ported; use Telemetry.Boards.Dual_Ported;
with URVOS;                       use URVOS;

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

   --  Nobody puts it up: all work is done in interrupts.
   Awake : aliased Targets.Flag := Targets.Down;

   package Line_Turns is new Line_Programs (Accept_Character, Next_Character);

   procedure On_Character (Data : Unsigned_32; Damaged : Unsigned_32)
   with Import, Convention => C, External_Name => "urv_character";
   procedure On_Free_Sender
   with Import, Convention => C, External_Name => "urv_free_sender";

   --  Gives the board this character, and those that have come after it.
   procedure Hear (Data : Byte; Is_Damaged : Boolean);
   pragma No_Inline (Hear);

   procedure Put_Errors;
   pragma No_Inline (Put_Errors);

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
      Is_Due : Boolean;
      Result : Reception;
   begin
      Take_Period (Line_Chip, Is_Due);
      if not Is_Due then
         return;
      end if;
      if not Is_Ready then
         Targets.Restart_Processor (Memory_Is_Taken);
      end if;
      Line_Turns.Count_Character_Time;
      Receive (Line, Errors, Result);
      if Result.Is_There then
         Hear (Result.Data, Is_Damaged (Result));
      end if;
      if Result.Sender_Is_Free then
         if Has_News then
            Line_Turns.Hurry;
         end if;
         if Line_Turns.Is_Due then
            On_Free_Sender;
         end if;
      end if;
      Targets.Feed_Watchdog;
      if Is_Over /= 0 then
         Put_Errors;
      end if;
   end On_Line;

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
      loop
         Targets.Sleep (Awake'Access);
      end loop;
   end Run;

   procedure Power_Up is
   begin
      Targets.Keep_Memory;
      Run (0);
   end Power_Up;

end Telemetry_Board_Program;
