--  SPDX-License-Identifier: Apache-2.0

with Targets;

package body Line_Programs is

   --  Character times since the clock began, and the last one reported to the
   --  telemetry board's timer. Both wrap round.
   Character_Count : Unsigned_32 := 0 with Volatile;
   Told            : Unsigned_32 := 0 with Volatile;

   --  The character time of the telemetry board's next turn.
   Next_Turn : Unsigned_32 := 0 with Volatile;

   --  Character times since the last report to the telemetry board.
   procedure Elapse (Elapsed : out Character_Times);

   procedure Elapse (Elapsed : out Character_Times) is
      Passed : constant Unsigned_32 := Character_Count - Told;
   begin
      Elapsed := Character_Times
        (Unsigned_32'Min (Passed, Unsigned_32 (Character_Times'Last)));
      Told := Told + Passed;
   end Elapse;

   procedure Hurry is
   begin
      Next_Turn := Character_Count;
   end Hurry;

   procedure Count_Character_Time is
   begin
      Character_Count := Character_Count + 1;
   end Count_Character_Time;

   --  The count may be beyond the turn, and may wrap round.
   function Is_Due return Boolean is (Character_Count - Next_Turn < 2 ** 31);

   procedure On_Character_Time is
   begin
      Count_Character_Time;
   end On_Character_Time;

   procedure On_Character (Data : Unsigned_32; Damaged : Unsigned_32) is
      Elapsed   : Character_Times;
      May_Speak : Boolean;
   begin
      Elapse (Elapsed);
      Accept_Character
        (Elapsed, Byte (Data and 255), Damaged /= 0, May_Speak);
      if May_Speak then
         Hurry;
      end if;
   end On_Character;

   procedure On_Free_Sender is
      Elapsed   : Character_Times;
      Send      : Boolean;
      Data      : Byte;
      Time_Left : Character_Times;
   begin
      if Is_Due then
         Elapse (Elapsed);
         Next_Character (Elapsed, Send, Data, Time_Left);
         if Send then
            Targets.Send (Data);
            Next_Turn := Character_Count + 1;
         else
            Next_Turn := Character_Count + Unsigned_32 (Time_Left);
         end if;
      end if;
   end On_Free_Sender;

end Line_Programs;
