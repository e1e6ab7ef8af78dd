--  SPDX-License-Identifier: Apache-2.0

with URV.Engine_Monitor;
with URV.Law_Units;     use URV.Law_Units;
with URV.Sensor_Checks; use URV.Sensor_Checks;

package body URV.LAW_Steps with SPARK_Mode is

   function Flown_With
     (Before : Laws.Memory; Used : Settings; Got : Inputs) return Flight
   is
      Commands : constant Uplink_Buffer := Commands_Of (Got);
      After    : Laws.Memory;
   begin
      if not Used.On then
         return
           (Before, Got.Commands, Is_Sent => Got.Has_Commands,
            By_Law => False);
      end if;
      After := Laws.Next
        (Before, Commands, Sensors_Of (Got), Used.By, Used.Table);
      return
        (After,
         Output (After, Commands),
         Is_Sent => True,
         By_Law  => not Is_All_Stick (After));
   end Flown_With;

   function Engine_After
     (Before  : Monitor;
      Sensors : Downlink_Buffer;
      Checks  : Check_Table) return Engine_Monitor.Monitor
   is
     (Engine_Monitor.Next
        (Before.Engine, Before.Power,
         Speed    => Level_Of (Word_Of (Checks, RPM)),
         Airspeed => Level_Of (Word_Of (Checks, Airspeed)),
         Is_Known => not Is_Old (Sensors)
           and then Checks (RPM).Is_Valid
           and then Checks (Airspeed).Is_Valid))
   with Global => null;

   --  The monitor after the servos' words of this frame.
   function With_Message
     (Watched  : Monitor;
      Engine   : Engine_Monitor.Monitor;
      Message  : Uplink_Buffer;
      Reported : Health) return Monitor
   is
     (if Is_Old (Message)
      then With_Engine (With_None_Sent (Watched), Engine, Watched.Power)
      else With_Engine
        (With_Sent (Watched, Demands_Of (Servos (Message, Reported))),
         Engine, Level_Of (Message (Throttle))))
   with Global => null;

   function Surfaces_After
     (Before : Monitor; On : Boolean; Flown : Flight; Got : Inputs)
      return Surface_Part
   is
      Sensors  : constant Downlink_Buffer := Sensors_Of (Got);
      Watched  : Monitor;
      Reported : Health;
   begin
      if not On then
         return (Before, All_Well);
      end if;
      Watched := Surface_Monitor.Next (Before, Sensors);
      Reported := Told_Of
        ((Failed => Watched.Failed, Places => Watched.Places), Flown.By_Law);
      return
        (Watched  => With_Message
           (Watched, Engine_After (Before, Sensors, Flown.After.Checks),
            Flown.Message, Reported),
         Reported => Reported);
   end Surfaces_After;

   function Decided
     (Before : Kept; Usual : Settings; Got : Inputs) return Decision
   is
      Set   : constant Setting := Set_After (Before, Usual, Got);
      Flown : constant Flight :=
        Flown_With (Before.Flown, In_Force (Usual, Set), Got);
   begin
      return
        (Flown    => Flown,
         Set      => Set,
         Surfaces => Surfaces_After (Before.Watched, Usual.On, Flown, Got));
   end Decided;

end URV.LAW_Steps;
