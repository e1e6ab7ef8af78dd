--  SPDX-License-Identifier: Apache-2.0

--  The inputs of a test card to the sticks and to the laws' commands (FTI-3,
--  FTI-6, D-100). URV.Test_Runs makes them, URV.Laws uses them.

with URVOS;         use URVOS;
with URV.Buffers;   use URV.Buffers;
with URV.Law_Units; use URV.Law_Units;

package URV.Law_Inputs with Pure, SPARK_Mode is

   --  The largest input, in words.
   Most_Input : constant := 800;

   subtype Increment is Number range -Most_Input .. Most_Input;

   --  Words of the sticks.
   type Stick_Inputs is record
      Roll, Pitch, Yaw : Increment := 0;
   end record;

   --  Bank and pitch in words of 0.02 degrees. Altitude and airspeed in their
   --  own words: half a foot, and a 32nd of a knot.
   type Command_Inputs is record
      Bank, Pitch, Altitude, Airspeed : Increment := 0;
   end record;

   --  Thousandths of a degree for a word.
   Angle_For_Word : constant := 20;

   function No_Sticks return Stick_Inputs is ((others => 0))
   with Global => null;

   function No_Commands return Command_Inputs is ((others => 0))
   with Global => null;

   --  A stick with its input, within the stick's range.
   function Stick_With (Stick : Demand; Added : Increment) return Demand is
     (Within (Stick + Added, Demand'First, Demand'Last))
   with
     Global => null,
     Post   =>
       abs (Stick_With'Result - Stick) <= abs Added
       and then (if Added = 0 then Stick_With'Result = Stick);

   --  The same for the stick's word. Without an input it is the same word,
   --  also beyond the converter's range.
   function Stick_Word (Value : Word; Added : Increment) return Word is
     (if Added = 0 then Value
      else Word_Of (Stick_With (Demand_Of (Value), Added)))
   with
     Global => null,
     Post   =>
       Demand_Of (Stick_Word'Result) = Stick_With (Demand_Of (Value), Added)
       and then (if Added = 0 then Stick_Word'Result = Value);

   --  The input of a command's word. Only the three sticks of the surfaces
   --  have one.
   function Input_Of (Name : Command_Item; Added : Stick_Inputs)
                      return Increment
   is
     (case Name is
         when Roll   => Added.Roll,
         when Pitch  => Added.Pitch,
         when Yaw    => Added.Yaw,
         when others => 0)
   with Global => null;

   --  Commands with the inputs of the sticks. They are not marked as old.
   function With_Sticks (Commands : Uplink_Buffer; Added : Stick_Inputs)
                         return Uplink_Buffer
   is
     ((Commands with delta
         Roll         => Stick_Word (Commands (Roll), Added.Roll),
         Pitch        => Stick_Word (Commands (Pitch), Added.Pitch),
         Yaw          => Stick_Word (Commands (Yaw), Added.Yaw),
         Error_Status => No_Error))
   with
     Global => null,
     Post   =>
       With_Sticks'Result (Error_Status) = No_Error
       and then
         (for all Name in Command_Item =>
            With_Sticks'Result (Name) =
              Stick_Word (Commands (Name), Input_Of (Name, Added)));

end URV.Law_Inputs;
