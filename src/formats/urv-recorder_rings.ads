--  SPDX-License-Identifier: Apache-2.0

--  The ring of the flight recorder's newest rows (FTI-9): the place of each
--  row. Theorems.Recorder shows that the rows come back in order and as they
--  were written. The memory of the rows is in URV.Shared_Recorders.

with URV.Recorder_Rows;  use URV.Recorder_Rows;
with URV.Recorder_Sizes; use URV.Recorder_Sizes;

package URV.Recorder_Rings with Pure, SPARK_Mode is

   type Row_Count is range 0 .. Most_Rows;

   subtype Row_Place is Row_Count range 1 .. Most_Rows;

   subtype Ring_Length is Row_Place;

   --  Length: the places in use. Next: the number of the next row, and Place
   --  where it goes. Held: the newest rows that are kept.
   type Ring is record
      Length : Ring_Length := Most_Rows;
      Next   : Row_Number  := 0;
      Place  : Row_Place   := 1;
      Held   : Row_Count   := 0;
   end record
   with Predicate =>
     Ring.Place <= Ring.Length
     and then Ring.Held <= Ring.Length
     and then Row_Number (Ring.Held) <= Ring.Next;

   function Cleared (This : Ring) return Ring is
     ((Length => This.Length, others => <>))
   with Global => null;

   --  The numbers are used up.
   function Is_Over (This : Ring) return Boolean is
     (This.Next = Row_Number'Last)
   with Global => null;

   --  The ring after one more row, which is at This.Place.
   function After (This : Ring) return Ring is
     ((Length => This.Length,
       Next   => This.Next + 1,
       Place  => (if This.Place = This.Length then 1 else This.Place + 1),
       Held   =>
         (if This.Held = This.Length then This.Held else This.Held + 1)))
   with
     Global => null,
     Pre    => not Is_Over (This);

   --  The number of the oldest row, if there is any.
   function First (This : Ring) return Row_Number is
     (This.Next - Row_Number (This.Held))
   with Global => null;

   function Is_Held (This : Ring; Number : Row_Number) return Boolean is
     (Number >= First (This) and then Number < This.Next)
   with Global => null;

   --  The place of a row.
   function Place_Of (This : Ring; Number : Row_Number) return Row_Place is
     (if Row_Number (This.Place) > This.Next - Number
      then This.Place - Row_Count (This.Next - Number)
      else This.Place + (This.Length - Row_Count (This.Next - Number)))
   with
     Global => null,
     Pre    => Is_Held (This, Number);

end URV.Recorder_Rings;
