--  SPDX-License-Identifier: Apache-2.0

--  The faults of an aircraft's servos in a flight (SIM-5).
--
--  A plant counts its steps, each a tick long, from the first with the servos'
--  commands. A fault acts from its step on. A later fault of the same servo
--  replaces the earlier one.

with Ada.Containers.Vectors;

package Host.Surface_Faults is

   type Fault_Kind is
     (Stuck_Here,    --  stays at its present position
      Stuck_At,      --  runs to a position, as if commanded, and stays
      Floating,      --  its linkage is broken
      Slow);         --  moves at a fraction of its speed

   type Percentage is range 1 .. 99;

   type Step_Number is new Long_Long_Integer range 0 .. 2 ** 62;

   --  Place is for Stuck_At, Speed for Slow.
   type Fault is record
      Servo : Servo_Item;
      Start : Step_Number;
      Kind  : Fault_Kind;
      Place : Converter_Value := Neutral_Value;
      Speed : Percentage      := 1;
   end record;

   package Vectors is new Ada.Containers.Vectors (Positive, Fault);

   --  In the order of their steps.
   subtype List is Vectors.Vector;

   None : constant List := Vectors.Empty_Vector;

end Host.Surface_Faults;
