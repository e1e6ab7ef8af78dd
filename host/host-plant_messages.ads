--  SPDX-License-Identifier: Apache-2.0

--  The messages between a program here and sim/jsbsim/plant.py, the aircraft
--  in JSBSim: an introduction, then for each major frame the servos' commands
--  in one direction and the aircraft's state in the other (SIM-3).
--
--  The other process uses engineering units; the words are converted here.
--  Each program chooses how to carry the bytes.

with Ada.Streams; use Ada.Streams;

with Host.Surface_Faults;

package Host.Plant_Messages is

   --  The true state of the aircraft.
   type Flight_State is record
      Altitude : Long_Float := 0.0;      --  ft above the field
      Airspeed : Long_Float := 0.0;      --  kt, calibrated
      Bank     : Long_Float := 0.0;      --  deg, right wing down positive
      Pitch    : Long_Float := 0.0;      --  deg, nose up positive
      Heading  : Long_Float := 0.0;      --  deg, 0 up to 360, true
      Climb    : Long_Float := 0.0;      --  ft/s

      --  From the beginning of the flight, and the wheels on the ground.
      North    : Long_Float := 0.0;      --  ft
      East     : Long_Float := 0.0;      --  ft
      Wheels   : Long_Float := 0.0;

      --  Other parts than the wheels have touched the ground. From then on
      --  neither state nor sensors change.
      Crashed  : Boolean := False;
   end record;

   --  The values in the flight record, in the units that end their names.
   --  North and east are counted from the flight's beginning.
   type Shown_Item is
     (Altitude_Ft, Airspeed_Kt, Bank_Deg, Pitch_Deg, Heading_Deg,
      Alpha_Deg, Beta_Deg, North_Ft, East_Ft);
   type Shown_State is array (Shown_Item) of Long_Float;

   --  A step is a tick long.
   subtype Step_Count is Positive range 1 .. Ticks_Per_Major_Frame;

   --  Errors of the sensors' measurements, in their scales' units.
   type Sensor_Values is array (Sensor_Item) of Long_Float;

   Exact : constant Sensor_Values := (others => 0.0);

   --  The names and units of all numbers to be sent and received, and the
   --  times. The record's values are taken after that number of steps. Further
   --  lines hold other settings of the plant.
   function Introduction
     (Shown_After : Step_Count;
      Further     : String := "";
      Schedule    : Schedule_Name := URVOS.Task_Trees.Report)
      return Stream_Element_Array;

   --  Further lines: the servos' faults (SIM-5).
   function Fault_Lines (Faults : Surface_Faults.List) return String;

   --  The answer to an introduction without errors.
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

   --  The servos' commands for a major frame.
   function To_Message (Servos : PWM_Buffer) return Command_Message;

   --  The plant has sent an infinite or undefined number. The message names
   --  it.
   Not_Finite : exception;

   --  Sensors are those Ticks_To_Scan after the frame's beginning, when the
   --  aircraft's next scan begins, with their errors; Truth is at the frame's
   --  beginning. Raises Not_Finite.
   procedure Read
     (Message : State_Message;
      Sensors : out Sensor_Words;
      Truth   : out Flight_State;
      Shown   : out Shown_State;
      Errors  : Sensor_Values := Exact);

end Host.Plant_Messages;
