--  SPDX-License-Identifier: Apache-2.0

--  The test cards' report to the ground (FTI-2): a row of the aircraft's log,
--  sent in turn with the laws' report once a card has been taken. Part after
--  part, it repeats all cards word for word.

with URVOS;           use URVOS;
with URV.CORE_Memory; use URV.CORE_Memory;
with URV.Test_Cards;  use URV.Test_Cards;
with URV.Test_Runs;   use URV.Test_Runs;

package URV.Card_Status with Pure, SPARK_Mode is

   --  The words of the report.
   --
   --  State: the chosen slot, the running one, the last one, and the place of
   --  its state in URV.Test_Runs.Verdict, each in four bits from the lowest.
   --  Frame: the frame of the running card, from 0.
   --  Part: slot * 16 + part of the following words, part 0 to 2.
   --  Word_1 to Word_4: words 4 * part + 1 to 4 * part + 4 of that card, 0
   --  after its last one.
   type Report_Item is (State, Frame, Part, Word_1, Word_2, Word_3, Word_4);
   type Report is array (Report_Item) of Word;

   --  Its row in the log, and the report in that row.

   Row_Number : constant Log_Row_Number := Log_Row_Number'Last - 1;

   function To_Row (Item : Report) return Log_Row is
     (Occurrences_High => Item (State),
      Occurrences_Low  => Item (Frame),
      First_Frame_High => Item (Part),
      First_Frame_Low  => Item (Word_1),
      Last_Frame_High  => Item (Word_2),
      Last_Frame_Low   => Item (Word_3),
      Last_Detail      => Item (Word_4))
   with Global => null;

   function From_Row (Row : Log_Row) return Report is
     (State  => Row (Occurrences_High),
      Frame  => Row (Occurrences_Low),
      Part   => Row (First_Frame_High),
      Word_1 => Row (First_Frame_Low),
      Word_2 => Row (Last_Frame_High),
      Word_3 => Row (Last_Frame_Low),
      Word_4 => Row (Last_Detail))
   with
     Global => null,
     Post   => To_Row (From_Row'Result) = Row;

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

   --  The running card in each downlink (FTI-12): its slot above four bits
   --  with its phase, the frame modulo 16. Without a running card the slot is
   --  0 and the four bits are the reason of the last end.
   function Card_Word (This : Run) return Word is
     (if This.Running > 0
      then 16 * Word (This.Running) + (Word (This.Frame) and 15)
      else Verdict'Pos (This.Reason))
   with
     Global => null,
     Post   => Card_Word'Result <= 143;

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

   function Report_Of (This : Aboard; Number : Part_Number) return Report is
     (State  => State_Word (This.Run),
      Frame  => Word (This.Run.Frame),
      Part   => 16 * Word (Slot_Of (Number)) + Word (Number mod 3),
      Word_1 => Word_Of (This, Number, 0),
      Word_2 => Word_Of (This, Number, 1),
      Word_3 => Word_Of (This, Number, 2),
      Word_4 => Word_Of (This, Number, 3))
   with Global => null;

end URV.Card_Status;
