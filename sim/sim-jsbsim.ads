--  SPDX-License-Identifier: Apache-2.0

--  The aircraft, flown by JSBSim in another process in lock-step with the
--  simulation (SIM-3). There is one.
--
--  The other process is Python with sim/jsbsim/plant.py. The interpreter is
--  .venv/bin/python beside the directory of the running program, or the
--  environment variable URV_PYTHON.
--  It ends with the connection, so it never outlives this program. Its results
--  depend only on the servos' words.

with Host.Plant_Messages; use Host.Plant_Messages;
with URV.Buffers;         use URV.Buffers;

package Sim.JSBSim is

   --  The other process has ended, or does not answer.
   Plant_Failure : exception;
   Plant_Silence : exception;

   --  The aircraft, trimmed in level flight at 70 kt, 1000 ft above the field,
   --  heading east, with neutral servos, unless Further lines of the
   --  introduction say otherwise. Raises Bad_Input when the interpreter, the
   --  script or JSBSim is missing.
   procedure Start
     (Shown_After : Step_Count;
      Further     : String;
      Schedule    : Schedule_Name;
      Errors      : Sensor_Values;
      Sensors     : out Sensor_Words;
      Truth       : out Flight_State;
      Shown       : out Shown_State);

   --  Holds the servos' words for a major frame. The other process computes it
   --  while this one continues, if there are processors for both.
   procedure Begin_Step (Servos : PWM_Buffer);

   --  The result of the frame. Sensors are those Ticks_To_Scan after its
   --  beginning, when the aircraft's next scan begins, with their errors;
   --  Truth is at its beginning, Shown after the chosen number of steps.
   procedure End_Step
     (Errors  : Sensor_Values;
      Sensors : out Sensor_Words;
      Truth   : out Flight_State;
      Shown   : out Shown_State);

   --  Ends the other process. Does nothing when there is none.
   procedure Stop;

end Sim.JSBSim;
