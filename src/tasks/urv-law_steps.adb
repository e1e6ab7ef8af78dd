--  SPDX-License-Identifier: Apache-2.0

with URV.Engine_Monitor;
with URV.Law_Units;     use URV.Law_Units;

package body URV.LAW_Steps with SPARK_Mode is

   procedure Fly
     (This   : in out Laws.Memory;
      Used   : Settings;
      Got    : Inputs;
      Result : out Flight)
   is
      Commands : constant Uplink_Buffer := Commands_Of (Got);
   begin
      if Used.On then
         Laws.Advance
           (This, Commands, Sensors_Of (Got), Used.By, Used.Table);
         Result :=
           (Message => Output (This, Commands),
            Is_Sent => True,
            By_Law  => not Is_All_Stick (This),
            By_Card => False);
      else
         Result :=
           (Message => Got.Commands,
            Is_Sent => Got.Has_Commands,
            By_Law  => False,
            By_Card => False);
      end if;
   end Fly;

   procedure Run_Cards
     (Cards     : in out Test_Runs.Aboard;
      Flown     : Laws.Memory;
      Watched   : Monitor;
      Got       : Inputs;
      Result    : in out Flight;
      Has_Ended : out Boolean)
   is
      Sight   : constant Test_Runs.Situation :=
        Sight_Of (Flown, Watched, Got);
      Started : constant Boolean :=
        Test_Runs.Is_Running (Cards.Run)
        or else Test_Runs.Is_Started (Cards.Run, Sight);
      Before  : constant Increments := Cards.Run.Added;
   begin
      Cards.Run := Test_Runs.Next (Cards.Run, Cards.Deck, Sight);
      Has_Ended := Started and then not Test_Runs.Is_Running (Cards.Run);
      if not Sight.Is_Cut
        and then
          (Before /= Nothing_Added or else Cards.Run.Added /= Nothing_Added)
      then
         Result.By_Card := True;
         if not Result.By_Law then
            Result.Message := Flown.Heard;
            Result.Message (Error_Status) := No_Error;
         end if;
      end if;
   end Run_Cards;

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

   procedure Watch
     (This     : in out Monitor;
      Checks   : Check_Table;
      Flown    : Flight;
      Added    : Increments;
      Got      : Inputs;
      Reported : out Health)
   is
      Sensors : constant Downlink_Buffer := Sensors_Of (Got);
   begin
      This.Engine := Engine_After (This, Sensors, Checks);
      Surface_Monitor.Advance (This, Sensors);
      Reported := Reported_Health
        ((Failed => This.Failed, Places => This.Places), Flown.By_Law);

      --  The servos' words of this frame.
      if Is_Old (Flown.Message) then
         Note_None_Sent (This);
      else
         Note_Sent
           (This,
            Demands_Of
              (With_Inputs (Servos (Flown.Message, Reported), Added)));
         This.Power := Level_Of (Flown.Message (Throttle));
      end if;
   end Watch;

   procedure Decide
     (This   : in out Kept;
      Usual  : Settings;
      Got    : Inputs;
      Result : out Decision)
   is
   begin
      Result.Reply := Answer_Of (This, Usual, Got);
      Result.Card_Reply := Card_Answer_Of (This, Usual, Got);
      This.Set := Set_After (This, Usual, Got);
      if Has_Card (Got) then
         This.Cards :=
           Test_Runs.After_Block (Got.Block, This.Cards, Usual.On);
      end if;

      Fly (This.Flown, In_Force (Usual, This.Set), Got, Result.Flown);
      if Usual.On then
         Run_Cards
           (This.Cards, This.Flown, This.Watched, Got, Result.Flown,
            Result.Has_Ended);
         pragma Assert
           (if not Result.Flown.By_Law and then not Result.Flown.By_Card
            then Result.Flown.Message = Commands_Of (Got));
         Result.Added := This.Cards.Run.Added;
         Watch
           (This.Watched, This.Flown.Checks, Result.Flown, Result.Added, Got,
            Result.Reported);
      else
         Result.Has_Ended := False;
         Result.Added := Nothing_Added;
         Result.Reported := All_Well;
      end if;
   end Decide;

end URV.LAW_Steps;
