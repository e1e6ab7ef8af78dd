--  SPDX-License-Identifier: Apache-2.0

--  The command line of urv_sim: the user's choices, and the help text. Any
--  error in it raises Bad_Input (SIM-1).

with Host.Options;
with Host.Text_Output;

package Sim.Commands is

   type Command is (Help, Items, Numbers, Tables, Version, Fly);

   type Call is record
      Order  : Command := Help;

      --  The subject of help: Help for all commands.
      About  : Command := Help;

      Chosen : Host.Options.Choices;
   end record;

   --  The parsed command line.
   function Parsed return Call;

   procedure Print_Usage
     (To    : in out Text_Output.Writer;
      About : Command)
     with Pre => Text_Output.Is_Open (To);

end Sim.Commands;
