--  SPDX-License-Identifier: Apache-2.0

--  The decision of the LOG task, and of MDCOUT's fragment of the error log
--  (D-70; EXT-1, SAF-7, FTI-2). The task and URV.Log_Senders receive, call
--  these functions, send and report.

with Telemetry;       use Telemetry;
with URVOS;           use URVOS;
with URV.Card_Status; use URV.Card_Status;
with URV.CORE_Layout; use URV.CORE_Layout;
with URV.CORE_Memory; use URV.CORE_Memory;
with URV.Errors;      use URV.Errors;
with URV.Law_Status;
with URV.Link_Errors; use URV.Link_Errors;
with URV.Log_Pieces;  use URV.Log_Pieces;

package URV.LOG_Steps with Pure, SPARK_Mode is

   --  The LOG task keeps the telemetry board's counts that it has logged, and
   --  the kind whose row it writes next.
   type Progress is record
      Seen_Tally   : Statistics := (others => 0);
      Kind_In_Turn : Error_Kind := Error_Kind'First;
   end record;

   --  After a cold start, which leaves no restart in the log, the board's
   --  counts up to now are not new errors. Any other start keeps the counts
   --  seen before.
   function At_Start
     (Before : Progress; Log : Error_Log; Tally : Statistics) return Progress
   is
     ((Seen_Tally   =>
         (if Logs.History_Of (Log, Warm_Reset).Occurrences = 0
            and then Logs.History_Of (Log, Processor_Restart).Occurrences = 0
          then Tally else Before.Seen_Tally),
       Kind_In_Turn => Error_Kind'First))
   with Global => null;

   --  The new errors of the link.
   function New_Errors
     (Before : Progress; Tally : Statistics; Error : Link_Error) return Count
   is
     (New_Since (Counted (Before.Seen_Tally, Error), Counted (Tally, Error)))
   with Global => null;

   function After (Before : Progress; Tally : Statistics) return Progress is
     ((Seen_Tally   => Tally,
       Kind_In_Turn => Logs.Following (Before.Kind_In_Turn)))
   with Global => null;

   --  The row that is being sent to the ground, and the number of its
   --  fragments already sent. Is_Cards: the laws' last row was that of the
   --  test cards. Part: the part of the cards for their next row.
   type Outgoing is record
      Kind     : Error_Kind  := Error_Kind'Last;
      Is_Laws  : Boolean     := False;
      Is_Cards : Boolean     := False;
      Part     : Part_Number := 0;
      Row      : Log_Row     := No_Errors;
      Sent     : Place_Count := Place'Last;
   end record;

   --  The laws' row follows each row, and is sent when the log is empty.
   function Laws_Are_Next
     (Line : Outgoing; Is_Empty : Boolean; Laws_On : Boolean) return Boolean
   is
     (Laws_On
      and then not Line.Is_Laws
      and then (Is_Empty or else Line.Sent = Place'Last))
   with Global => null;

   --  With test cards, their row takes turns with that of the laws (FTI-2).
   function Cards_Are_Next (Line : Outgoing; Has_Cards : Boolean)
                            return Boolean
   is
     (Has_Cards and then not Line.Is_Cards)
   with Global => null;

   --  The row of the laws or, if Cards_Are_Next, of the test cards.
   function With_Laws
     (Line : Outgoing; Has_Cards : Boolean; Row : Log_Row) return Outgoing
   is
     ((Kind     => Line.Kind,
       Is_Laws  => True,
       Is_Cards => Cards_Are_Next (Line, Has_Cards),
       Part     =>
         (if not Cards_Are_Next (Line, Has_Cards) then Line.Part
          elsif Line.Part = Part_Number'Last then 0
          else Line.Part + 1),
       Row      => Row,
       Sent     => 0))
   with Global => null;

   --  A row is over when all its fragments are sent, or the log was cleared.
   --  History: that of the row's kind.
   function Is_Over (Line : Outgoing; History : Logs.History) return Boolean
   is
     (Line.Sent = Place'Last
      or else (not Line.Is_Laws and then History.Occurrences = 0))
   with Global => null;

   --  The row of a kind of error.
   function With_Kind
     (Line : Outgoing; Kind : Error_Kind; History : Logs.History)
      return Outgoing
   is
     ((Kind     => Kind,
       Is_Laws  => False,
       Is_Cards => Line.Is_Cards,
       Part     => Line.Part,
       Row      => To_Row (History),
       Sent     => 0))
   with Global => null;

   function Has_Piece (Line : Outgoing; Is_Empty : Boolean) return Boolean is
     (Line.Sent < Place'Last and then (Line.Is_Laws or else not Is_Empty))
   with Global => null;

   function Next_Piece (Line : Outgoing; Is_Empty : Boolean) return Piece is
     (if Has_Piece (Line, Is_Empty)
      then Piece_At
        ((if Line.Is_Laws and then Line.Is_Cards then Card_Status.Row_Number
          elsif Line.Is_Laws then Law_Status.Row_Number
          else Row_Of (Line.Kind)),
         Line.Row, Line.Sent + 1)
      else No_Piece)
   with Global => null;

   function After (Line : Outgoing; Is_Empty : Boolean) return Outgoing is
     (if Has_Piece (Line, Is_Empty)
      then (Line with delta Sent => Line.Sent + 1)
      else Line)
   with Global => null;

end URV.LOG_Steps;
