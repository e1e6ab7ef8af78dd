--  SPDX-License-Identifier: Apache-2.0

--  The functions of C's library that the compiler calls, except memcpy, which
--  is in start.s.

with Interfaces; use Interfaces;
with System;     use System;

package Memory_Operations is

   function Move (To, From : Address; Length : Unsigned_32) return Address
   with Export, Convention => C, External_Name => "memmove";

   function Set
     (To : Address; Value : Integer; Length : Unsigned_32) return Address
   with Export, Convention => C, External_Name => "memset";

   function Compare
     (Left, Right : Address; Length : Unsigned_32) return Integer
   with Export, Convention => C, External_Name => "memcmp";

end Memory_Operations;
