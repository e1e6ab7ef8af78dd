--  SPDX-License-Identifier: Apache-2.0

--  The conditions of a flight (--conditions): start, airframe, wind,
--  turbulence, ballast, traits of the servos, and errors of the sensors
--  (SIM-4). The bench has servos only; all others need JSBSim.
--
--  The plant's process receives all but the sensors' errors. They are added
--  here, before the measurements become words.

with Ada.Strings.Unbounded;

with Host.Bench;
with Host.Plant_Messages; use Host.Plant_Messages;
with Sim.Noise;

package Sim.Conditions is

   type Start_Place is (In_The_Air, On_The_Runway);

   type Condition_Kind is
     (Start, Airframe, Wind, Turbulence, Ballast, Servos, Bias, Noisiness);

   --  The form of such a condition: "wind FROM_DEG KT".
   function Form_Of (Kind : Condition_Kind) return String;

   type Script is limited private;

   --  Reads the file. Raises Bad_Input, also for a condition that needs an
   --  aircraft when there is none.
   procedure Load
     (Loaded : in out Script; File : String; Has_Aircraft : Boolean);

   --  The place where the flight begins, from the file, or Otherwise.
   function Place
     (Given : Script; Otherwise : Start_Place) return Start_Place;

   --  Whether an aircraft of JSBSim's flies in place of URV's own (SIM-10).
   function Has_Other_Airframe (Given : Script) return Boolean;

   --  The lines for the plant's introduction; none without a file and with a
   --  start in the air.
   function Introduction
     (Given : Script;
      Seed  : Seed_Number;
      From  : Start_Place) return String;

   --  The traits of the servos for the bench.
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
      Is_Other  : Boolean := False;
      Lines     : Texts.Unbounded_String;
      Servos    : Host.Bench.Servo_Traits;
      Biases    : Sensor_Values := Exact;
      Spreads   : Sensor_Values := Exact;
   end record;

end Sim.Conditions;
