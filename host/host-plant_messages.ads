--  SPDX-License-Identifier: Apache-2.0

--  What is said between a program here and sim/jsbsim/plant.py, the aircraft
--  in JSBSim: an introduction, then for each major frame the servos' commands
--  one way and the aircraft's state the other (SIM-3).
--
--  The other process sees and gives engineering units; the words are
--  converted here. How the bytes are carried is the programs' own affair.

with Ada.Streams; use Ada.Streams;

with Host.Surface_Faults;

package Host.Plant_Messages is

   --  What the aircraft really does.
   type Flight_State is record
      Altitude : Long_Float := 0.0;      --  ft above the field
      Airspeed : Long_Float := 0.0;      --  kt, calibrated
      Bank     : Long_Float := 0.0;      --  deg, right wing down positive
      Pitch    : Long_Float := 0.0;      --  deg, nose up positive
      Heading  : Long_Float := 0.0;      --  deg, 0 up to 360, true
      Climb    : Long_Float := 0.0;      --  ft/s

      --  From where the flight begins, and the wheels on the ground.
      North    : Long_Float := 0.0;      --  ft
      East     : Long_Float := 0.0;      --  ft
      Wheels   : Long_Float := 0.0;

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

   --  What is wrong with what the sensors measure, in their scales' units.
   type Sensor_Values is array (Sensor_Item) of Long_Float;

   Exact : constant Sensor_Values := (others => 0.0);

   --  The names and units of all numbers to be sent and received, and the
   --  times. What is shown is taken after so many steps. Further lines say
   --  what else the plant has to know.
   function Introduction
     (Shown_After : Step_Count;
      Further     : String := "";
      Schedule    : Schedule_Name := URVOS.Task_Trees.Report)
      return Stream_Element_Array;

   --  Further lines: what befalls the servos (SIM-5).
   function Fault_Lines (Faults : Surface_Faults.List) return String;

   --  The line that answers an introduction, if nothing is wrong.
   Ready : constant String := "ready";

   --  A number is a big-endian IEEE double.
   Bytes_Per_Number : constant := 8;

   subtype Command_Message is
     Stream_Element_Array
       (1 .. (Servo_Item'Pos (Servo_Item'Last) + 1) * Bytes_Per_Number);

   Truth_Count : constant := 10;

   subtype State_Message is
     Stream_Element_Array
       (1 .. (Sensor_Item'Pos (Sensor_Item'Last) + 1 + Truth_Count
              + Shown_Item'Pos (Shown_Item'Last) + 1) * Bytes_Per_Number);

   --  What the servos are to hold for a major frame.
   function To_Message (Servos : PWM_Buffer) return Command_Message;

   --  The plant has sent a number that is infinite or none. The message names
   --  it.
   Not_Finite : exception;

   --  Sensors are those Ticks_To_Scan after the frame's beginning, when the
   --  aircraft's next scan begins, with their errors; Truth is at the
   --  frame's beginning. Raises Not_Finite.
   procedure Read
     (Message : State_Message;
      Sensors : out Sensor_Words;
      Truth   : out Flight_State;
      Shown   : out Shown_State;
      Errors  : Sensor_Values := Exact);

end Host.Plant_Messages;
