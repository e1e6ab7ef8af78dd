--  SPDX-License-Identifier: Apache-2.0

--  Decodes a serial device's reports of characters with a wrong parity bit or
--  frame (RTP-1, LNK-1).
--
--  The operating system puts FF 00 before such a character, and doubles an FF
--  that was received well.

with URVOS; use URVOS;

package Partitions.Error_Marks is

   type Mark_Reader is limited private;

   --  Takes one more byte of the device. Found: it completes a character,
   --  which is in Data.
   procedure Take
     (Reader       : in out Mark_Reader;
      Data         : Byte;
      Found        : out Boolean;
      Parity_Error : out Boolean);

   --  Discards the bytes so far.
   procedure Forget (Reader : in out Mark_Reader);

private

   type Place is (At_Character, After_Mark, At_Damaged);

   type Mark_Reader is limited record
      Now_At : Place := At_Character;
   end record;

end Partitions.Error_Marks;
