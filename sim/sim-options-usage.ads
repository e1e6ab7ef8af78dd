--  The text that explains the command line.

private package Sim.Options.Usage is

   --  Prints it on standard output.
   procedure Print;

end Sim.Options.Usage;
