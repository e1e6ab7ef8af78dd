--  SPDX-License-Identifier: Apache-2.0

package body Host.Bench is

   use Surface_Faults;

   subtype Surface is Sensor_Item range Right_Flap_1 .. Left_Rudder;

   --  The servo that moves a surface.
   Servo_Of : constant array (Surface) of Servo_Item :=
     (Right_Flap_1   => Right_Flap_1,
      Left_Flap_1    => Left_Flap_1,
      Right_Flap_2   => Right_Flap_2,
      Left_Flap_2    => Left_Flap_2,
      Right_Aileron  => Right_Aileron,
      Left_Aileron   => Left_Aileron,
      Right_Elevator => Right_Elevator,
      Left_Elevator  => Left_Elevator,
      Right_Rudder   => Right_Rudder,
      Left_Rudder    => Left_Rudder);

   --  Positions are in fractions of a converter word. In each tick a surface
   --  covers the share of the remaining travel that gives a lag of 64 ms.
   type Position is range 0 .. 4_095 * 2 ** 20;
   Parts : constant := 2 ** 10;
   Lag   : constant := 64_000 / Microseconds_Per_Tick;

   type Place_Table is array (Surface) of Position;

   Rest   : constant Position := Position (Neutral_Value) * Parts;
   Places : Place_Table       := (others => Rest);

   --  A failed servo moves to its Place instead of the commanded position, or
   --  moves at a reduced speed, in per cent.
   Whole : constant := 100;
   type Health is record
      Obeys : Boolean  := True;
      Place : Position := Rest;
      Speed : Position := Whole;
   end record;

   --  The traits of this flight's servos.
   Traits : Servo_Traits;

   --  In words, from stop to stop.
   function Travel (Item : Surface) return Position is
     (if Item in Right_Flap_1 .. Left_Flap_2 then 2_047 else 4_000);

   function Dead_Band (Item : Surface) return Position is
     (Travel (Item) * Parts * Position (Traits.Dead_Band)
      / (100 * Position (One_Per_Cent)));

   Servos_Health : array (Servo_Item) of Health;

   Script : List;
   Next   : Positive    := 1;
   Now    : Step_Number := 0;

   --  The step at which a frame's scan begins.
   Scan_After : Step_Number :=
     Step_Number (Ticks_To_Scan (URVOS.Task_Trees.Report));

   --  The movement in one tick: at least one part, so that it arrives.
   function Part_Of (Distance, Speed : Position) return Position is
     (Position'Max
        (1,
         Distance * Speed * Position (One_Per_Cent)
         / (Lag * Position (Traits.Lag))));

   function Moved (From, To, Speed : Position) return Position is
     (if From < To then From + Part_Of (To - From, Speed)
      elsif From > To then From - Part_Of (From - To, Speed)
      else From);

   --  Applies the faults that begin now.
   procedure Begin_Faults;

   --  The next step at which a fault begins.
   function Next_Start return Step_Number is
     (if Next <= Script.Last_Index then Script (Next).Start
      else Step_Number'Last);

   --  Moves the surfaces for that number of steps.
   procedure Move (Servos : PWM_Buffer; Steps : Step_Number);

   procedure Move_Surface
     (Item : Surface; Servos : PWM_Buffer; Steps : Step_Number);

   procedure Start
     (Faults   : Surface_Faults.List := Surface_Faults.None;
      Schedule : Schedule_Name := URVOS.Task_Trees.Report;
      Servos   : Servo_Traits  := Usual_Servos) is
   begin
      Traits := Servos;
      Scan_After := Step_Number (Ticks_To_Scan (Schedule));
      Places := (others => Rest);
      Servos_Health := (others => <>);
      Script := Faults;
      Next := 1;
      Now := 0;
   end Start;

   procedure Begin_Faults is
   begin
      while Next_Start <= Now loop
         declare
            Fault : constant Surface_Faults.Fault := Script (Next);
            Place : Position := Rest;
         begin
            for Item in Surface loop
               if Servo_Of (Item) = Fault.Servo then
                  Place := Places (Item);
               end if;
            end loop;
            Servos_Health (Fault.Servo) :=
              (case Fault.Kind is
                  when Stuck_Here => (False, Place, Whole),
                  when Stuck_At   =>
                    (False, Position (Fault.Place) * Parts, Whole),
                  when Floating   => (False, Rest, Whole),
                  when Slow       => (True, Rest, Position (Fault.Speed)));
         end;
         Next := Next + 1;
      end loop;
   end Begin_Faults;

   procedure Move_Surface
     (Item : Surface; Servos : PWM_Buffer; Steps : Step_Number)
   is
      Servo : constant Servo_Item := Servo_Of (Item);
      State : Health renames Servos_Health (Servo);
      Goal  : constant Position :=
        (if State.Obeys then Position (Servos (Servo)) * Parts
         else State.Place);
      Rests_Within : constant Position :=
        (if State.Obeys then Dead_Band (Item) else 0);
   begin
      for I in 1 .. Steps loop
         exit when abs (Places (Item) - Goal) <= Rests_Within;
         Places (Item) := Moved (Places (Item), Goal, State.Speed);
      end loop;
   end Move_Surface;

   procedure Move (Servos : PWM_Buffer; Steps : Step_Number) is
      Stop : constant Step_Number := Now + Steps;
      Last : Step_Number;
   begin
      while Now < Stop loop
         Begin_Faults;
         Last := Step_Number'Min (Stop, Next_Start);
         for Item in Surface loop
            Move_Surface (Item, Servos, Last - Now);
         end loop;
         Now := Last;
      end loop;
   end Move;

   procedure Step (Servos : PWM_Buffer; Sensors : in out Sensor_Words) is
   begin
      Move (Servos, Scan_After);
      for Item in Surface loop
         Sensors (Item) := Word (Places (Item) / Parts);
      end loop;
      Move (Servos, Ticks_Per_Major_Frame - Scan_After);
   end Step;

end Host.Bench;
