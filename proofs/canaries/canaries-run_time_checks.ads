--  SPDX-License-Identifier: Apache-2.0

--  Expressions that can raise an exception.

with URVOS; use URVOS;

package Canaries.Run_Time_Checks with Pure, SPARK_Mode is

   subtype Percent is Word range 0 .. 100;

   --  101 times 50, divided by 50.
   function Share (Part, Whole : Word) return Percent is
     (Percent (Part / (Whole / 50 + 1)))  --  VC_RANGE_CHECK
   with Pre => Whole >= 1 and then Part <= 102 * (Whole / 50) and then
               Whole <= 30_000;

   --  The last count has no successor.
   function Next_Of (Value : Count) return Integer is
     (Integer (Value) + 1);  --  VC_OVERFLOW_CHECK

   --  The divisor is zero if the words differ by one.
   function Ratio (Left, Right : Word) return Word is
     (Left / (Left - Right - 1))  --  VC_DIVISION_CHECK
   with Pre => Left > Right;

   type Row is array (Byte range <>) of Word;

   subtype Short_Row is Row (1 .. 8);

   --  One place beyond the last.
   function Neighbour_Of (Source : Short_Row; I : Byte) return Word is
     (Source (I + 1))  --  VC_INDEX_CHECK
   with Pre => I in Source'Range;

   --  Nine words for eight places.
   procedure Take (Source : Row; Target : out Short_Row)
   with
     Global => null,
     Pre    => Source'Length in 8 .. 9 and then Source'Last < 255;

   type Shape (Round : Boolean := True) is record
      case Round is
         when True  => Radius : Byte;
         when False => Side   : Byte;
      end case;
   end record;

   function Size (Item : Shape; Wanted : Boolean) return Byte is
     (if Wanted then Item.Radius  --  VC_DISCRIMINANT_CHECK
      else 0)
   with Pre => Item.Round or else not Wanted or else Item.Side = 0;

end Canaries.Run_Time_Checks;
