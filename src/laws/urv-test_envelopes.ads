--  SPDX-License-Identifier: Apache-2.0

--  The conditions of a test card besides the pilot's: its sensors, its
--  envelope, and the laws that follow its inputs (FTI-5, D-100).

with URVOS;             use URVOS;
with URV.Buffers;       use URV.Buffers;
with URV.Law_Units;     use URV.Law_Units;
with URV.Laws;          use URV.Laws;
with URV.Sensor_Checks; use URV.Sensor_Checks;
with URV.Test_Cards;    use URV.Test_Cards;

package URV.Test_Envelopes with Pure, SPARK_Mode is

   --  A limit's sensor is valid, or the card has no such limit.

   function Has_Sensors (Source : Card; Checks : Check_Table) return Boolean
   is
     ((Bank_Limit (Source) = No_Limit
       or else Checks (Roll_Attitude).Is_Valid)
      and then
        (Pitch_Limit (Source) = No_Limit
         or else Checks (Pitch_Attitude).Is_Valid)
      and then
        (Alpha_Limit (Source) = No_Limit or else Checks (Alpha).Is_Valid)
      and then
        (Load_Limit (Source) = No_Limit
         or else Checks (Vertical_Acceleration).Is_Valid)
      and then
        ((Source (Slowest) = 0 and then Source (Fastest) = Field'Last)
         or else Checks (Airspeed).Is_Valid)
      and then
        (Source (Lowest) = 0 or else Checks (Altitude).Is_Valid))
   with Global => null;

   --  Words of alpha for a degree, of the load factor for a tenth of g, and
   --  for 1 g.
   Alpha_Words : constant := 80;
   Load_Words  : constant := 25;
   One_G       : constant := 250;

   function Is_Inside (Source : Card; Checks : Check_Table) return Boolean is
     ((Bank_Limit (Source) = No_Limit
       or else abs Roll_Angle_Of (Word_Of (Checks, Roll_Attitude)) <=
                 Bank_Limit (Source) * 1_000)
      and then
        (Pitch_Limit (Source) = No_Limit
         or else abs Pitch_Angle_Of (Word_Of (Checks, Pitch_Attitude)) <=
                   Pitch_Limit (Source) * 1_000)
      and then
        (Alpha_Limit (Source) = No_Limit
         or else abs Demand_Of (Word_Of (Checks, Alpha)) <=
                   Alpha_Limit (Source) * Alpha_Words)
      and then
        (Load_Limit (Source) = No_Limit
         or else
           abs (Demand_Of (Word_Of (Checks, Vertical_Acceleration)) - One_G)
             <= Load_Limit (Source) * Load_Words)
      and then Word_Of (Checks, Airspeed) >= Source (Slowest)
      and then
        (Source (Fastest) = Field'Last
         or else Word_Of (Checks, Airspeed) <= Source (Fastest))
      and then Word_Of (Checks, Altitude) >= Source (Lowest))
   with Global => null;

   --  Each input reaches the aircraft. A stick moves a surface, or demands
   --  bank or pitch; a command is that of a law that flies. An input to a
   --  servo always does.
   function Is_Followed (Source : Card; Flown : Modes) return Boolean is
     (case Place_Of (Source) is
         when At_Servo   => True,
         when At_Stick   =>
           (not Moves (Source, Left_Aileron)
            or else Flown.Lateral in Direct .. Bank_By_Stick)
           and then
             (not Moves (Source, Left_Elevator)
              or else Flown.Vertical in Direct .. Pitch_By_Stick),
         when At_Command =>
           (not Moves (Source, Left_Aileron)
            or else Flown.Lateral in Banked)
           and then
             (not Moves (Source, Left_Elevator)
              or else Flown.Vertical in Pitched)
           and then
             (not Moves (Source, Left_Rudder)
              or else Flown.Vertical = Hold_Altitude)
           and then
             (not Moves (Source, Right_Rudder)
              or else Flown.Power = Hold_Airspeed))
   with Global => null;

end URV.Test_Envelopes;
