--  SPDX-License-Identifier: Apache-2.0

--  The keys of the sealed link from their file (SEC-5): a line "key NUMBER
--  DIGITS" for each, two at most, the first to call with; # begins a comment.
--  NUMBER is 0 to 255, DIGITS are 32 hexadecimal digits.
--
--  A file that another user may read is refused. What was read is wiped,
--  complaints repeat nothing of it, and the process leaves no core dump.

with URV.Seal_Blocks; use URV.Seal_Blocks;
with URV.Seals;       use URV.Seals;
with URV.Sessions;    use URV.Sessions;

package Host.Key_Files is

   --  Format 2 needs a key, format 1 has none. Raises Bad_Input.
   procedure Check (Format : Format_Number; Has_Key : Boolean);

   --  Raises Bad_Input.
   function Keys_From (Name : String) return Key_List;

   --  From the operating system's source of random numbers. Raises Bad_Input
   --  if it gives none.
   function Random_Nonce return Nonce;

end Host.Key_Files;
