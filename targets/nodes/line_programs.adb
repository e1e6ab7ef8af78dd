--  SPDX-License-Identifier: Apache-2.0

with Targets;

package body Line_Programs is

   --  Character times since the last report to the telemetry board's timer.
   --  Only interrupts use it. A turn of the board comes long before it wraps
   --  round.
   Passed : Unsigned_16 := 0;

   --  The telemetry board has its next turn when as many have passed.
   Next_Turn : Unsigned_16 := 0 with Volatile;

   --  Reports the character times to the telemetry board.
   procedure Elapse (Elapsed : out Character_Times)
   with Inline;

   procedure Elapse (Elapsed : out Character_Times) is
   begin
      Elapsed := Character_Times
        (Unsigned_16'Min (Passed, Unsigned_16 (Character_Times'Last)));
      Passed := 0;
   end Elapse;

   procedure Hurry is
   begin
      Next_Turn := 0;
   end Hurry;

   procedure Count_Character_Time is
   begin
      Passed := Passed + 1;
   end Count_Character_Time;

   function Is_Due return Boolean is (Passed >= Next_Turn);

   procedure On_Character_Time is
   begin
      Count_Character_Time;
   end On_Character_Time;

   procedure Hear (Data : Byte; Is_Damaged : Boolean) is
      Before    : constant Unsigned_16 := Next_Turn;
      Elapsed   : Character_Times;
      May_Speak : Boolean;
   begin
      --  The turn is now counted from this report on.
      Next_Turn := (if Before > Passed then Before - Passed else 0);
      Elapse (Elapsed);
      Accept_Character (Elapsed, Data, Is_Damaged, May_Speak);
      if May_Speak then
         Hurry;
      end if;
   end Hear;

   procedure On_Character (Data : Unsigned_32; Damaged : Unsigned_32) is
   begin
      Hear (Byte (Data and 255), Damaged /= 0);
   end On_Character;

   procedure Take_Turn is
      Elapsed   : Character_Times;
      Send      : Boolean;
      Data      : Byte;
      Time_Left : Character_Times;
   begin
      Elapse (Elapsed);
      Next_Character (Elapsed, Send, Data, Time_Left);
      if Send then
         Targets.Send (Data);
         Next_Turn := 1;
      else
         Next_Turn := Unsigned_16 (Time_Left);
      end if;
   end Take_Turn;

   procedure On_Free_Sender is
   begin
      if Is_Due then
         Take_Turn;
      end if;
   end On_Free_Sender;

end Line_Programs;
