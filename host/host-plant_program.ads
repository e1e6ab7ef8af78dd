--  SPDX-License-Identifier: Apache-2.0

--  Locates and starts the program of the aircraft in JSBSim:
--  sim/jsbsim/plant.py, beside the directory of the running program. Its
--  interpreter is .venv/bin/python there, or the environment variable
--  URV_PYTHON.

with GNAT.OS_Lib; use GNAT.OS_Lib;

package Host.Plant_Program is

   --  Refuses --plant jsbsim with a hint at the remedy: raises Bad_Input.
   procedure Refuse (Why : String) with No_Return;

   --  Refuses the flight with the program's own words: raises Bad_Input.
   procedure Refuse_Flight (Answer : String) with No_Return;

   --  Starts it with its end of a socket pair, which it inherits. Raises
   --  Bad_Input when the interpreter or the script is missing, or cannot run.
   procedure Spawn (Descriptor : Natural; Process : out Process_Id);

end Host.Plant_Program;
