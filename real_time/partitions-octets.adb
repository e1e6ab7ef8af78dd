--  SPDX-License-Identifier: Apache-2.0

package body Partitions.Octets is

   function Value_At
     (Source : Octet_Array; First : Positive; Length : Positive)
      return Number
   is
      Value : Number := 0;
   begin
      for Each of Source (First .. First + Length - 1) loop
         Value := Shift_Left (Value, 8) or Number (Each);
      end loop;
      return Value;
   end Value_At;

   procedure Append
     (Target : in out Octet_Array;
      Last   : in out Natural;
      Value  : Number;
      Length : Positive)
   is
      Largest : constant Number :=
        Shift_Right (Number'Last, 64 - 8 * Length);
      Rest    : Number := Number'Min (Value, Largest);
   begin
      for Place in reverse Last + 1 .. Last + Length loop
         Target (Place) := Unsigned_8 (Rest and 16#FF#);
         Rest := Shift_Right (Rest, 8);
      end loop;
      Last := Last + Length;
   end Append;

end Partitions.Octets;
