--  SPDX-License-Identifier: Apache-2.0

--  The telemetry board's turns at the line (report, appendix A; BRD-1, BRD-8),
--  with the handlers of the line that targets.ads lists. An image has one
--  instance, on the processor that serves the line.

with Interfaces; use Interfaces;
with Telemetry;  use Telemetry;
with URVOS;      use URVOS;

generic
   --  Operations of the board; see Telemetry.Shared_Boards.

   with procedure Accept_Character
     (Elapsed      : Character_Times;
      Data         : Byte;
      Parity_Error : Boolean;
      May_Speak    : out Boolean);

   with procedure Next_Character
     (Elapsed   : Character_Times;
      Send      : out Boolean;
      Data      : out Byte;
      Time_Left : out Character_Times);
package Line_Programs is

   --  An image has one instance.
   pragma Warnings (Off, "all instances of * same external name");

   --  Gives the telemetry board its turn at the next character time.
   procedure Hurry
   with Inline;

   --  A character time has begun; urv_character_time does the same.
   procedure Count_Character_Time
   with Inline;

   --  The telemetry board has its turn at this character time; without it
   --  urv_free_sender does nothing.
   function Is_Due return Boolean
   with Inline;

   --  The line has brought a character; urv_character does the same.
   procedure Hear (Data : Byte; Is_Damaged : Boolean)
   with Inline;

   --  The turn of the telemetry board, which Is_Due has shown: urv_free_sender
   --  does both.
   procedure Take_Turn;

private

   procedure On_Character_Time
   with Export, Convention => C, External_Name => "urv_character_time";

   procedure On_Character (Data : Unsigned_32; Damaged : Unsigned_32)
   with Export, Convention => C, External_Name => "urv_character";

   procedure On_Free_Sender
   with Export, Convention => C, External_Name => "urv_free_sender";

end Line_Programs;
