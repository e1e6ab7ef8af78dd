--  SPDX-License-Identifier: Apache-2.0

--  The conditions of a flight (--conditions): where it begins, wind,
--  turbulence, ballast, what the servos are like, and what is wrong with the
--  sensors (SIM-4). The bench has servos, all others need JSBSim.
--
--  The plant's process is told of all but the sensors. The errors
--  of sensors are added here, before what they measure becomes words.

with Ada.Strings.Unbounded;

with Host.Bench;
with Host.Plant_Messages; use Host.Plant_Messages;
with Sim.Noise;

package Sim.Conditions is

   type Start_Place is (In_The_Air, On_The_Runway);

   type Condition_Kind is
     (Start, Wind, Turbulence, Ballast, Servos, Bias, Noisiness);

   --  How such a condition is written: "wind FROM_DEG KT".
   function Form_Of (Kind : Condition_Kind) return String;

   type Script is limited private;

   --  Reads the file. Raises Bad_Input, also for a condition that needs an
   --  aircraft when there is none.
   procedure Load
     (Loaded : in out Script; File : String; Has_Aircraft : Boolean);

   --  Where the file says that the flight begins; else as Otherwise says.
   function Place
     (Given : Script; Otherwise : Start_Place) return Start_Place;

   --  What the plant is told: lines for its introduction. Without a file
   --  and with a start in the air there is none.
   function Introduction
     (Given : Script;
      Seed  : Seed_Number;
      From  : Start_Place) return String;

   --  The same of the servos for the bench.
   function Bench_Servos (Given : Script) return Host.Bench.Servo_Traits;

   --  The errors of the sensors' next measurement.
   procedure Draw_Errors
     (Given  : Script;
      From   : in out Noise.Source;
      Errors : out Sensor_Values);

private

   package Texts renames Ada.Strings.Unbounded;

   type Script is limited record
      Is_Given  : Boolean := False;
      Has_Start : Boolean := False;
      Begins    : Start_Place := In_The_Air;
      Lines     : Texts.Unbounded_String;
      Servos    : Host.Bench.Servo_Traits;
      Biases    : Sensor_Values := Exact;
      Spreads   : Sensor_Values := Exact;
   end record;

end Sim.Conditions;
