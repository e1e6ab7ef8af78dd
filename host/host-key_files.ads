--  SPDX-License-Identifier: Apache-2.0

--  The keys of the sealed link from their file (SEC-5): a line "key NUMBER
--  DIGITS" for each, two at most; the first one is used for calling. # begins
--  a comment. NUMBER is 0 to 255, DIGITS are 32 hexadecimal digits.
--
--  A file that another user owns or may read is refused, and so is a pipe or a
--  device, without waiting for it. The text of the file is erased, complaints
--  repeat no part of it, and the process leaves no core dump.

with URV.Seal_Blocks; use URV.Seal_Blocks;
with URV.Handshakes;  use URV.Handshakes;
with URV.Sessions;    use URV.Sessions;

package Host.Key_Files is

   --  Format 2 needs a key, format 1 takes none. Raises Bad_Input.
   procedure Check (Format : Format_Number; Has_Key : Boolean);

   --  Keys on the way from their file to the seal.
   type Key_Ring is limited private;

   --  Raises Bad_Input.
   procedure Load (Ring : in out Key_Ring; Name : String);

   --  Hands over the keys, none if nothing was loaded. The ring no longer
   --  holds them afterwards.
   generic
      with procedure Receive (Keys : Key_List);
   procedure Hand_Over (Ring : in out Key_Ring);

   --  From the operating system's random number source. Raises Bad_Input if it
   --  gives none.
   function Random_Nonce return Nonce;

private

   type Key_Ring is limited record
      Keys : Key_List;
   end record;

end Host.Key_Files;
