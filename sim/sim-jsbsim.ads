--  SPDX-License-Identifier: Apache-2.0

--  The aircraft, flown by JSBSim in another process in lock-step with the
--  simulation (SIM-3). There is one.
--
--  The other process is Python with sim/jsbsim/plant.py. It sees and gives
--  engineering units; the words are converted here. It ends with the
--  connection, so it never outlives this program. What it computes depends
--  on the servos' words alone.
--
--  The interpreter is .venv/bin/python beside the directory of the running
--  program, or what the environment variable URV_PYTHON names.

with URV.Buffers;  use URV.Buffers;
with URVOS.Frames; use URVOS.Frames;

package Sim.JSBSim is

   --  What the aircraft really does.
   type Flight_State is record
      Altitude : Long_Float := 0.0;      --  ft above the field
      Airspeed : Long_Float := 0.0;      --  kt, calibrated
      Bank     : Long_Float := 0.0;      --  deg, right wing down positive
      Pitch    : Long_Float := 0.0;      --  deg, nose up positive
      Heading  : Long_Float := 0.0;      --  deg, 0 up to 360, true
      Climb    : Long_Float := 0.0;      --  ft/s

      --  It has touched the ground with something other than its wheels.
      --  From then on neither state nor sensors change.
      Crashed  : Boolean := False;
   end record;

   --  What the flight record shows of it, in the units that its names end
   --  with. North and east are counted from where the flight begins.
   type Shown_Item is
     (Altitude_Ft, Airspeed_Kt, Bank_Deg, Pitch_Deg, Heading_Deg,
      Alpha_Deg, Beta_Deg, North_Ft, East_Ft);
   type Shown_State is array (Shown_Item) of Long_Float;

   --  A step is a tick long.
   subtype Step_Count is Positive range 1 .. Ticks_Per_Major_Frame;

   --  The other process ended or does not answer.
   Plant_Failure : exception;

   --  The aircraft, trimmed in level flight at 70 kt, 1000 ft above the
   --  field, heading east, with neutral servos. Raises Bad_Input when the
   --  interpreter, the script or JSBSim is missing.
   procedure Start
     (Shown_After : Step_Count;
      Sensors     : out Sensor_Words;
      Truth       : out Flight_State;
      Shown       : out Shown_State);

   --  The servos' words are held for a major frame. Sensors are those
   --  Ticks_To_Scan after its beginning, when the aircraft's next scan
   --  begins; Truth is at its end, Shown after the steps that were chosen.
   procedure Step
     (Servos  : PWM_Buffer;
      Sensors : out Sensor_Words;
      Truth   : out Flight_State;
      Shown   : out Shown_State);

   --  Ends the other process. Does nothing when there is none.
   procedure Stop;

end Sim.JSBSim;
