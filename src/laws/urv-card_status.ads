--  SPDX-License-Identifier: Apache-2.0

--  The test cards' report to the ground (FTI-2): a row of the aircraft's log
--  that belongs to no error, sent in turn with the laws' row once a card has
--  been taken. Part after part, it repeats all cards word for word.
--
--  word 1  the chosen slot, the running one, the last one, and the place of
--          its state in URV.Test_Runs.Verdict, each in four bits from the
--          lowest
--  word 2  the frame of the running card, from 0
--  word 3  slot * 16 + part of the following words, part 0 to 2
--  word 4  words 4 * part + 1 to 4 * part + 4 of that card, 0 after its last
--  to 7    one

with URVOS;           use URVOS;
with URV.CORE_Memory; use URV.CORE_Memory;
with URV.Test_Cards;  use URV.Test_Cards;
with URV.Test_Runs;   use URV.Test_Runs;

package URV.Card_Status with Pure, SPARK_Mode is

   Row_Number : constant Log_Row_Number := Log_Row_Number'Last - 1;

   Words_A_Part : constant := 4;

   --  The parts of all slots.
   type Part_Number is range 0 .. 23;

   function Slot_Of (Part : Part_Number) return Slot is
     (Slot (Part / 3 + 1))
   with Global => null;

   --  There is something to report.
   function Has_Cards (This : Aboard) return Boolean is
     (This.Run.Chosen > 0 or else This.Run.Last_Run > 0)
   with Global => null;

   function State_Word (This : Run) return Word is
     (Word (This.Chosen) + 16 * Word (This.Running)
      + 256 * Word (This.Last_Run) + 4_096 * Verdict'Pos (This.Reason))
   with Global => null;

   --  A word of a card by its place, from 0; 0 beyond the last one.
   function Word_At (Source : Card; Place : Natural) return Word is
     (if Place > Card_Item'Pos (Card_Item'Last) then 0
      else Source (Card_Item'Val (Place)))
   with Global => null;

   function Word_Of
     (This : Aboard; Part : Part_Number; Place : Natural) return Word
   is
     (Word_At
        (This.Deck (Slot_Of (Part)),
         Words_A_Part * Integer (Part mod 3) + Place))
   with
     Global => null,
     Pre    => Place < Words_A_Part;

   function To_Row (This : Aboard; Part : Part_Number) return Log_Row is
     (Occurrences_High => State_Word (This.Run),
      Occurrences_Low  => Word (This.Run.Frame),
      First_Frame_High =>
        16 * Word (Slot_Of (Part)) + Word (Part mod 3),
      First_Frame_Low  => Word_Of (This, Part, 0),
      Last_Frame_High  => Word_Of (This, Part, 1),
      Last_Frame_Low   => Word_Of (This, Part, 2),
      Last_Detail      => Word_Of (This, Part, 3))
   with Global => null;

end URV.Card_Status;
