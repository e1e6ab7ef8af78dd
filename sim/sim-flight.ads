--  SPDX-License-Identifier: Apache-2.0

--  One flight, from the files it reads to the files it leaves.

with Host.Options; use Host.Options;

package Sim.Flight is

   --  Flies as chosen. Everything that is read is read and checked before
   --  any output file is opened. Raises Bad_Input. When the user wants no
   --  more (Sim.Signals) the flight ends with the frame, and Flown is less
   --  than was chosen.
   procedure Fly (Chosen : Choices; Flown : out Microseconds);

end Sim.Flight;
