--  SPDX-License-Identifier: Apache-2.0

--  The text that explains a program's options.

with Host.Options; use Host.Options;
with Host.Text_Output;

package Host.Option_Help is

   --  Prints a paragraph for each option: its name and its value's, then its
   --  meaning and, in brackets, its default.
   procedure Print (To : in out Text_Output.Writer; Caller : Program)
     with Pre => Text_Output.Is_Open (To);

end Host.Option_Help;
