--  SPDX-License-Identifier: Apache-2.0

with System.Storage_Elements; use System.Storage_Elements;

package body Memory_Operations is

   pragma Suppress (All_Checks);

   type Bytes is array (Unsigned_32) of Unsigned_8;

   function Copy (To, From : Address; Length : Unsigned_32) return Address
   with Import, Convention => C, External_Name => "memcpy";

   function Move (To, From : Address; Length : Unsigned_32) return Address is
      Target : Bytes with Import, Address => To;
      Source : Bytes with Import, Address => From;
      Place  : Unsigned_32 := Length;
   begin
      if To <= From or else To - From >= Storage_Offset (Length) then
         return Copy (To, From, Length);
      end if;
      while Place /= 0 loop
         Place := Place - 1;
         Target (Place) := Source (Place);
      end loop;
      return To;
   end Move;

   function Set
     (To : Address; Value : Integer; Length : Unsigned_32) return Address
   is
      Target : Bytes with Import, Address => To;
      Place  : Unsigned_32 := 0;
   begin
      while Place /= Length loop
         Target (Place) := Unsigned_8'Mod (Value);
         Place := Place + 1;
      end loop;
      return To;
   end Set;

   function Compare
     (Left, Right : Address; Length : Unsigned_32) return Integer
   is
      One   : Bytes with Import, Address => Left;
      Other : Bytes with Import, Address => Right;
      Place : Unsigned_32 := 0;
   begin
      while Place /= Length loop
         if One (Place) /= Other (Place) then
            return (if One (Place) < Other (Place) then -1 else 1);
         end if;
         Place := Place + 1;
      end loop;
      return 0;
   end Compare;

end Memory_Operations;
