--  SPDX-License-Identifier: Apache-2.0

--  Numbers in the datagrams of the station: unsigned, the high byte first.

with Interfaces; use Interfaces;

package Partitions.Octets is

   pragma Pure;

   subtype Number is Unsigned_64;

   type Octet_Array is array (Positive range <>) of Unsigned_8;

   --  The number in this many bytes.
   function Value_At
     (Source : Octet_Array; First : Positive; Length : Positive)
      return Number
   with
     Pre => Length <= 8
       and then First in Source'Range
       and then First + Length - 1 in Source'Range;

   --  Puts the number into the given number of bytes after Last. A number that
   --  does not fit becomes the largest that does.
   procedure Append
     (Target : in out Octet_Array;
      Last   : in out Natural;
      Value  : Number;
      Length : Positive)
   with Pre => Length <= 8 and then Last + Length <= Target'Last;

end Partitions.Octets;
