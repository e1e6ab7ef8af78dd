--  SPDX-License-Identifier: Apache-2.0

--  The command line of urv_sim: what was asked for, and the text that
--  explains it. Whatever is wrong with it raises Bad_Input (SIM-1).

with Host.Options;
with Host.Text_Output;

package Sim.Commands is

   type Command is (Help, Items, Numbers, Tables, Version, Fly);

   type Call is record
      Order  : Command := Help;

      --  What help is about: Help for all commands.
      About  : Command := Help;

      Chosen : Host.Options.Choices;
   end record;

   --  What the program was called with.
   function Parsed return Call;

   procedure Print_Usage
     (To    : in out Text_Output.Writer;
      About : Command)
     with Pre => Text_Output.Is_Open (To);

end Sim.Commands;
