--  SPDX-License-Identifier: Apache-2.0

--  The errors that the telemetry board counts for the log (EXT-1; report,
--  appendix A).

with Telemetry.Boards; use Telemetry.Boards;
with URVOS;            use URVOS;
with URV.Errors;       use URV.Errors;

package URV.Link_Errors with Pure, SPARK_Mode is

   subtype Link_Error is Error_Kind range Link_Block_Bad .. Link_Reset;

   function Counted (Tally : Statistics; Error : Link_Error) return Count is
     (case Error is
         when Link_Block_Bad       => Tally.Bad,
         when Link_Block_Not_Taken => Tally.Not_Taken,
         when Link_Block_Scrapped  => Tally.Scrapped,
         when Link_Block_Cleared   => Tally.Cleared,
         when Link_Reset           => Tally.Resets)
   with Global => null;

   --  The increase of a count. A lower count has started again from 0: the
   --  board was switched off meanwhile.
   function New_Since (Before, Now : Count) return Count is
     (if Now < Before then Now else Now - Before)
   with Global => null;

end URV.Link_Errors;
