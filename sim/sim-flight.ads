--  SPDX-License-Identifier: Apache-2.0

--  One flight, from its input files to its output files.

with Host.Options; use Host.Options;

package Sim.Flight is

   --  Flies as chosen. All inputs are read and checked before any output file
   --  is opened. Raises Bad_Input. After an interrupt (Sim.Signals) the flight
   --  ends with the frame, and Flown is less than the chosen length.
   procedure Fly (Chosen : Choices; Flown : out Microseconds);

end Sim.Flight;
