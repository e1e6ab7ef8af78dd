--  One flight, from the files it reads to the files it leaves.

with Sim.Options;

package Sim.Flight is

   --  Flies as chosen. Everything that is read is read and checked before
   --  any output file is opened. Raises Bad_Input.
   procedure Fly (Chosen : Options.Choices);

end Sim.Flight;
