--  SPDX-License-Identifier: Apache-2.0

--  A script of words over time: the pilot's sticks or the aircraft's sensors
--  in a flight. The whole CSV file is read and checked before the flight
--  begins.
--
--  The header names the columns, in any order; "time_ms" is required. The word
--  of an absent column is neutral. A row holds from its time until the next
--  row; before the first row all is neutral.

generic
   type Item is (<>);
   type Words is array (Item) of Word;
   Neutral : Words;
   with function Name (Which : Item) return String;

   --  An allowed column that has no effect on the script.
   Column_Without_Effect : String := "";
package Host.Scripts is

   type Script is limited private;

   --  Reads and checks the file; refuses it at its first wrong line.
   procedure Load (Loaded : in out Script; File : String);

   --  True if the file has a column for the item.
   function Is_Given (From : Script; Which : Item) return Boolean;

   --  The end of the last row's first frame, rounded up to whole frames. 0
   --  when nothing was loaded.
   function Length (From : Script) return Microseconds;

   --  When the next row begins to hold, Never after the last.
   function Next_Time (From : Script) return Microseconds with Inline;

   --  Takes the next row.
   procedure Advance (From : in out Script; Row : out Words)
     with Pre => Next_Time (From) /= Never;

private

   type Timed_Words is record
      Time  : Microseconds;
      Value : Words;
   end record;

   --  Rows are kept in a list of blocks, so that a long file is never copied
   --  while it grows.
   Rows_A_Block : constant := 1_024;
   type Row_Index is range 1 .. Rows_A_Block;
   type Row_Array is array (Row_Index) of Timed_Words;

   type Block;
   type Block_Access is access Block;
   type Block is record
      Rows : Row_Array;
      Next : Block_Access;
   end record;

   type Item_Set is array (Item) of Boolean;

   type Script is limited record
      Given : Item_Set := (others => False);

      --  The next row to take and the number of rows left.
      Present : Block_Access;
      Index   : Row_Index         := Row_Index'First;
      Left    : Long_Long_Integer := 0;

      Next : Microseconds := Never;
      Last : Microseconds := 0;
      Any  : Boolean      := False;
   end record;

   function Length (From : Script) return Microseconds is
     (if not From.Any then 0
      else (From.Last / Major_Frame + 1
            + (if From.Last mod Major_Frame = 0 then 0 else 1))
           * Major_Frame);

   function Next_Time (From : Script) return Microseconds is (From.Next);

   function Is_Given (From : Script; Which : Item) return Boolean is
     (From.Given (Which));

end Host.Scripts;
