--  SPDX-License-Identifier: Apache-2.0

--  An error log: the kinds of errors that occurred, their times and counts, in
--  memory of constant size (report, 3.5, and the sections "Error handling" of
--  4 and 5, which leave the recording to a later version; EXT-1, SEM-2).
--
--     Add (Log, Kind => No_Input, Now => 120, Detail => 0);
--
--  The log keeps one history for each kind of error: the count, the first and
--  the last time, and a word of detail of the last time. A flood of one kind
--  therefore never hides another, and no kind is ever displaced.
--
--  A count stops at its last value, which means "at least this number".

with URVOS.Frames; use URVOS.Frames;
with URVOS.Starts; use URVOS.Starts;

generic
   type Error_Kind is (<>);
package URVOS.Error_Logs with Pure, SPARK_Mode is

   --  A count of at least one.
   subtype Positive_Count is Count range 1 .. Count'Last;

   --  The history of one kind of error. The other components have a meaning
   --  only if Occurrences is not 0.
   type History is record
      Occurrences : Count      := 0;
      First       : Clock_Tick := 0;
      Last        : Clock_Tick := 0;
      Last_Detail : Word       := 0;
   end record;

   Never : constant History := (others => <>);

   type Error_Log is private;

   function History_Of (Log : Error_Log; Kind : Error_Kind) return History
   with Global => null;

   --  The number of errors of all kinds.
   function Total (Log : Error_Log) return Count
   with Global => null;

   --  The kind that was added last, or the first kind if none was.
   function Latest (Log : Error_Log) return Error_Kind
   with Global => null;

   --  The errors of all kinds: their number, the kind that was added last, and
   --  its last time.
   type Summary is record
      Total  : Count;
      Latest : Error_Kind;
      Last   : Clock_Tick;
   end record;

   function Summary_Of (Log : Error_Log) return Summary is
     ((Total  => Total (Log),
       Latest => Latest (Log),
       Last   => History_Of (Log, Latest (Log)).Last))
   with Global => null;

   --  The kinds follow each other in a circle.
   function Following (Kind : Error_Kind) return Error_Kind is
     (if Kind = Error_Kind'Last then Error_Kind'First
      else Error_Kind'Succ (Kind))
   with Global => null;

   function Has_Occurred (Log : Error_Log; Kind : Error_Kind) return Boolean
   is (History_Of (Log, Kind).Occurrences > 0)
   with Global => null;

   --  The next kind in the circle that has occurred. If only Kind or none has,
   --  it is Kind.
   function Next_Occurred (Log : Error_Log; Kind : Error_Kind)
                           return Error_Kind
   with
     Global => null,
     Post   =>
       (Next_Occurred'Result = Kind
        or else Has_Occurred (Log, Next_Occurred'Result))
       and then
         (if Has_Occurred (Log, Following (Kind))
          then Next_Occurred'Result = Following (Kind));

   --  A log without errors.
   function Empty_Log return Error_Log
   with
     Global => null,
     Post   =>
       (for all Kind in Error_Kind =>
          History_Of (Empty_Log'Result, Kind) = Never)
       and then Total (Empty_Log'Result) = 0
       and then Latest (Empty_Log'Result) = Error_Kind'First;

   --  The sum of two counts, limited to the last value.
   function Sum (Left, Right : Count) return Count is
     (if Left > Count'Last - Right then Count'Last else Left + Right)
   with Global => null;

   --  The history after one more entry.
   function Extended
     (Before    : History;
      Now       : Clock_Tick;
      Detail    : Word;
      How_Often : Positive_Count) return History
   is
     ((Occurrences => Sum (Before.Occurrences, How_Often),
       First       => (if Before.Occurrences = 0 then Now else Before.First),
       Last        => Now,
       Last_Detail => Detail))
   with Global => null;

   --  Adds one error of a kind, or several at once.
   procedure Add
     (Log       : in out Error_Log;
      Kind      : Error_Kind;
      Now       : Clock_Tick;
      Detail    : Word;
      How_Often : Positive_Count := 1)
   with
     Global => null,
     Post   =>
       --  The kind's own history grows; all others are unchanged.
       (for all Other in Error_Kind =>
          History_Of (Log, Other) =
            (if Other = Kind
             then Extended
                    (History_Of (Log'Old, Kind), Now, Detail, How_Often)
             else History_Of (Log'Old, Other)))
       and then Total (Log) = Sum (Total (Log'Old), How_Often)
       and then Latest (Log) = Kind;

   --  The log after a start: a cold start that has passed its self-test clears
   --  it; any other start keeps it.
   function After_Start
     (Log       : Error_Log;
      Condition : Start_Condition;
      Passed    : Boolean) return Error_Log
   is
     (if Condition = Cold_Start and then Passed then Empty_Log else Log)
   with
     Global => null,
     Post   =>
       (if Condition /= Cold_Start or else not Passed
        then After_Start'Result = Log
        else Total (After_Start'Result) = 0
          and then
            (for all Kind in Error_Kind =>
               History_Of (After_Start'Result, Kind) = Never));

private

   type History_Table is array (Error_Kind) of History;

   type Error_Log is record
      Histories  : History_Table := (others => Never);
      Sum_Of_All : Count         := 0;
      Last_Kind  : Error_Kind    := Error_Kind'First;
   end record;

   function History_Of (Log : Error_Log; Kind : Error_Kind) return History is
     (Log.Histories (Kind));

   function Total (Log : Error_Log) return Count is (Log.Sum_Of_All);

   function Latest (Log : Error_Log) return Error_Kind is (Log.Last_Kind);

   function Empty_Log return Error_Log is
     ((Histories  => (others => Never),
       Sum_Of_All => 0,
       Last_Kind  => Error_Kind'First));

end URVOS.Error_Logs;
