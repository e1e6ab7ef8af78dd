--  SPDX-License-Identifier: Apache-2.0

with Host.Option_Values;
with Host.Text_Numbers; use Host.Text_Numbers;
with Partitions.Clocks; use Partitions.Clocks;

package body Partitions.Round_Trips is

   use type Host.Text_Numbers.Number;
   use type Telemetry.Character_Times;

   Character_Time : constant Time_Span :=
     Microseconds (Telemetry.Microseconds_Per_Character);

   --  The answer's own time: the other board's guard time and a character.
   Answers_In : constant Time_Span :=
     Integer (Telemetry.Guard_Time + 1) * Character_Time;

   --  About a second of answers, and half of one.
   Enough    : constant := 50;
   Of_A_Kind : constant := 25;

   Round_Trip : Telemetry.Round_Trip_Time := 0;

   --  In whole microseconds, so that it has room for 60 ms.
   Times : Distribution;

   --  Successive answers: the number that were late or in time, and the sum of
   --  the round trips of the first that make a kind.
   type Row is record
      Are_Late : Boolean := False;
      Length   : Total   := 0;
      Sum      : Measure := 0;
   end record;

   function Mean (Item : Row) return Measure is (Item.Sum / Item.Length)
     with Pre => Item.Length > 0;

   protected Answers is
      procedure Add (Is_Late : Boolean; Time : Measure);
      function Latest return Row;
      function Late return Count;
      function Heard return Count;
   private
      Present : Row;
      All_Of_Them, Late_Ones : Count := 0;
   end Answers;

   --  Used by the task that asks for news.
   Is_Reported   : Boolean := False;
   Late_Reported : Boolean := False;

   --  The board's time-out for the first character of an answer.
   function Timeout return Time_Span is
     (Integer (Telemetry.Dead_Space_On (Round_Trip)) * Character_Time);

   protected body Answers is

      procedure Add (Is_Late : Boolean; Time : Measure) is
      begin
         All_Of_Them := Incremented (All_Of_Them);
         Late_Ones := (if Is_Late then Incremented (Late_Ones) else Late_Ones);
         if Present.Are_Late /= Is_Late then
            Present := (Are_Late => Is_Late, others => <>);
         end if;
         if Present.Length < Of_A_Kind then
            Present.Length := Present.Length + 1;
            Present.Sum := Present.Sum + Time;
         end if;
      end Add;

      function Latest return Row is (Present);

      function Late return Count is (Late_Ones);

      function Heard return Count is (All_Of_Them);

   end Answers;

   procedure Set_Line (Line : Telemetry.Line_Delay) is
   begin
      Round_Trip := Telemetry.Round_Trip_Of (Line);
   end Set_Line;

   --  A wait is shorter by up to a count of the timer.
   function Longest return Time_Span is
     (Timeout - Character_Time - Answers_In);

   function Is_In_Time (After : Time_Span) return Boolean is
     (After <= Timeout);

   procedure Note_Answer (After : Time_Span) is
      Time : constant Measure := Tenths_Of_Microseconds (After - Answers_In);
   begin
      Times.Add (Time / 10);
      Answers.Add (Is_Late => not Is_In_Time (After), Time => Time);
   end Note_Answer;

   function Measured return Statistics is
      Whole : constant Statistics := Times.Summed_Up;
   begin
      return
        (Number  => Whole.Number,
         Minimum => 10 * Whole.Minimum,
         Median  => 10 * Whole.Median,
         P99     => 10 * Whole.P99,
         Maximum => 10 * Whole.Maximum);
   end Measured;

   function Late return Count is (Answers.Late);

   function Heard return Count is (Answers.Heard);

   function Image (Time : Measure) return String is
     (Thousandths_Image (Number ((Time + 500) / 1_000) * 100));

   --  The --line-delay for that round trip, or that there is none.
   function Advice (Time : Measure) return String;

   function Advice (Time : Measure) return String is

      --  One way, in whole hundredths of a millisecond, rounded up.
      One_Way : constant Number := Number ((Time + 199) / 200) * 10;
   begin
      return
        (if One_Way <= Host.Option_Values.Longest_Line_Delay
         then "give both nodes --line-delay " & Thousandths_Image (One_Way)
         else "no --line-delay ("
              & Host.Option_Values.Line_Delay_Range
              & ") has room for this line");
   end Advice;

   function Next_Message (Now : String) return String is
      Latest : constant Row := Answers.Latest;
   begin
      if Latest.Length < Of_A_Kind then
         return "";
      elsif Latest.Are_Late then
         if Late_Reported then
            return "";
         end if;
         Late_Reported := True;
         return
           "answers come too late at " & Now & " s: round trip "
           & Image (Mean (Latest)) & " ms, the board waits for up to "
           & Image (Tenths_Of_Microseconds (Longest)) & " ms; "
           & Advice (Mean (Latest));
      elsif Late_Reported then
         Late_Reported := False;
         return "answers come in time again at " & Now & " s";
      elsif not Is_Reported and then Heard >= Enough then
         Is_Reported := True;
         return
           "round trip " & Image (Mean (Latest)) & " ms at " & Now
           & " s; the board waits for up to "
           & Image (Tenths_Of_Microseconds (Longest)) & " ms";
      else
         return "";
      end if;
   end Next_Message;

end Partitions.Round_Trips;
