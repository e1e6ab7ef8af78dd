--  SPDX-License-Identifier: Apache-2.0

--  Lines of text for a machine's console.

with Interfaces; use Interfaces;
with Targets;

package Machine_Texts is

   procedure Put (Text : String) renames Targets.Put;

   procedure Put_Line (Text : String := "");

   --  A space, the name, a space and the value, decimal.
   procedure Put_Labelled (Name : String; Value : Unsigned_32);

   --  A space and four hexadecimal digits.
   procedure Put_Word (Value : Unsigned_16);

end Machine_Texts;
