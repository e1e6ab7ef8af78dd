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
            By_Law | By_Card => False);
      end if;
      After := Laws.Next
        (Before, Commands, Sensors_Of (Got), Used.By, Used.Table);
      return
        (After,
         Output (After, Commands),
         Is_Sent => True,
         By_Law  => not Is_All_Stick (After),
         By_Card => False);
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
      Reported : Health;
      Added    : Increments) return Monitor
   is
     (if Is_Old (Message)
      then With_Engine (With_None_Sent (Watched), Engine, Watched.Power)
      else With_Engine
        (With_Sent
           (Watched,
            Demands_Of (With_Inputs (Servos (Message, Reported), Added))),
         Engine, Level_Of (Message (Throttle))))
   with Global => null;

   function Surfaces_After
     (Before : Monitor;
      On     : Boolean;
      Flown  : Flight;
      Added  : Increments;
      Got    : Inputs) return Surface_Part
   is
      Sensors  : constant Downlink_Buffer := Sensors_Of (Got);
      Watched  : Monitor;
      Reported : Health;
   begin
      if not On then
         return (Before, All_Well);
      end if;
      Watched := Surface_Monitor.Next (Before, Sensors);
      Reported := Reported_Health
        ((Failed => Watched.Failed, Places => Watched.Places), Flown.By_Law);
      return
        (Watched  => With_Message
           (Watched, Engine_After (Before, Sensors, Flown.After.Checks),
            Flown.Message, Reported, Added),
         Reported => Reported);
   end Surfaces_After;

   --  The test cards after a frame, with the part of the contract of their
   --  run that is needed here.
   function Cards_After
     (Before : Test_Runs.Aboard; Sight : Test_Runs.Situation)
      return Test_Runs.Aboard
   with
     Global => null,
     Post   =>
       (if Test_Runs.Is_Running (Cards_After'Result.Run)
          and then not Test_Runs.Is_Running (Before.Run)
        then Sight.Is_New
          and then PWM_Transform.Is_On (Sight.Heard (Switch_5)))
       and then
         (if Sight.Is_Cut then Cards_After'Result.Run.Added = Nothing_Added);

   function Cards_After
     (Before : Test_Runs.Aboard; Sight : Test_Runs.Situation)
      return Test_Runs.Aboard
   is
      Run : constant Test_Runs.Run :=
        Test_Runs.Next (Before.Run, Before.Deck, Sight);
   begin
      return (Deck => Before.Deck, Run => Run);
   end Cards_After;

   function Decided
     (Before : Kept; Usual : Settings; Got : Inputs) return Decision
   is
      Set       : constant Setting := Set_After (Before, Usual, Got);
      By_Laws   : constant Flight :=
        Flown_With (Before.Flown, In_Force (Usual, Set), Got);
      Sight     : constant Test_Runs.Situation :=
        Sight_Of (By_Laws, Before.Watched, Got);
      Cards     : Test_Runs.Aboard := Cards_With (Before, Usual, Got);
      Flown     : Flight := By_Laws;
      Added     : Increments := Nothing_Added;
      Has_Ended : Boolean := False;
   begin
      if Usual.On then
         declare
            Started : constant Boolean :=
              Test_Runs.Is_Running (Cards.Run)
              or else Test_Runs.Is_Started (Cards.Run, Sight);
         begin
            Cards := Cards_After (Cards, Sight);
            Has_Ended := Started and then not Test_Runs.Is_Running (Cards.Run);
         end;
         Added := Cards.Run.Added;
         Flown := With_Card
           (By_Laws, Sight.Is_Cut, Before.Cards.Run.Added, Added);
      end if;
      return
        (Flown     => Flown,
         Set       => Set,
         Surfaces  =>
           Surfaces_After (Before.Watched, Usual.On, Flown, Added, Got),
         Cards     => Cards,
         Added     => Added,
         Has_Ended => Has_Ended);
   end Decided;

end URV.LAW_Steps;
