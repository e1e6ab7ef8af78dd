--  SPDX-License-Identifier: Apache-2.0

--  The text that explains the command line.

private package Sim.Options.Usage is

   procedure Print
     (To    : in out Text_Output.Writer;
      Topic : Help_Topic);

end Sim.Options.Usage;
