--  SPDX-License-Identifier: Apache-2.0

--  The text that explains a program's options.

with Host.Options; use Host.Options;
with Host.Text_Output;

package Host.Option_Help is

   --  A paragraph for each option: its name and its value's, then what it is
   --  and, in brackets, what is so without it.
   procedure Print (To : in out Text_Output.Writer; Whose : Program)
     with Pre => Text_Output.Is_Open (To);

end Host.Option_Help;
