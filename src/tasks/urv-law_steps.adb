--  SPDX-License-Identifier: Apache-2.0

with URV.Test_Cards; use type URV.Test_Cards.Input_Place;

package body URV.LAW_Steps with SPARK_Mode is

   --  A test card's frame. Its inputs are those of this frame. Is_Moving: the
   --  servos or sticks have inputs, or had them in the last frame. Without a
   --  card the facts on which one depends are not collected.
   procedure Run_Cards
     (Cards     : in out Test_Runs.Aboard;
      Flown     : Laws.Memory;
      Watched   : Monitor;
      Got       : Inputs;
      Is_Moving : out Boolean;
      Has_Ended : out Boolean)
   with
     Global => null,
     Post   =>
       Are_Run (Cards'Old, Cards, Sight_Of (Flown, Watched, Got), Has_Ended)
       and then Are_Conducted
         (Test_Runs.Is_Running (Cards.Run'Old),
          Test_Runs.Is_Running (Cards.Run), Flown, Watched, Got, Has_Ended)
       and then
         (if Is_Moving then not Is_Cut (Flown, Got)
          else Test_Runs.To_Servos (Cards.Run) = Nothing_Added
            and then Test_Runs.To_Sticks (Cards.Run) = No_Sticks);

   procedure Run_One
     (Cards     : in out Test_Runs.Aboard;
      Sight     : Test_Runs.Situation;
      Is_Moving : out Boolean;
      Has_Ended : out Boolean)
   with
     Global => null,
     Post   =>
       Are_Run (Cards'Old, Cards, Sight, Has_Ended)
       and then
         (if Is_Moving then not Sight.Is_Cut
          else Test_Runs.To_Servos (Cards.Run) = Nothing_Added
            and then Test_Runs.To_Sticks (Cards.Run) = No_Sticks);

   procedure Run_One
     (Cards     : in out Test_Runs.Aboard;
      Sight     : Test_Runs.Situation;
      Is_Moving : out Boolean;
      Has_Ended : out Boolean)
   is
      Before : constant Test_Runs.Run := Cards.Run;
   begin
      Cards.Run := Test_Runs.Next (Before, Cards.Deck, Sight);
      Has_Ended := Test_Runs.Has_Ended (Before, Cards.Run, Sight);
      Is_Moving := not Sight.Is_Cut
        and then Cards.Run.Place /= Test_Cards.At_Command
        and then
          (Before.Added /= Nothing_Added
           or else Cards.Run.Added /= Nothing_Added);
   end Run_One;

   procedure Run_Cards
     (Cards     : in out Test_Runs.Aboard;
      Flown     : Laws.Memory;
      Watched   : Monitor;
      Got       : Inputs;
      Is_Moving : out Boolean;
      Has_Ended : out Boolean)
   is
      Is_New : constant Boolean := not Is_Old (Commands_Of (Got));
   begin
      if Test_Runs.Is_Idle (Cards.Run)
        and then not Test_Runs.Is_Started (Cards.Run, Flown.Heard, Is_New)
      then
         if Is_New then
            Cards.Run.Was_On := PWM_Transform.Is_On (Flown.Heard (Switch_5));
         end if;
         Is_Moving := False;
         Has_Ended := False;
      else
         Run_One
           (Cards, Sight_Of (Flown, Watched, Got), Is_Moving, Has_Ended);
      end if;
   end Run_Cards;

   procedure Fly
     (This      : in out Laws.Memory;
      Cards     : in out Test_Runs.Aboard;
      Watched   : Monitor;
      Used      : Settings;
      Got       : Inputs;
      Result    : out Flight;
      Has_Ended : out Boolean)
   is
      Before   : constant Laws.Memory := This with Ghost;
      Commands : constant Uplink_Buffer := Commands_Of (Got);
      Seen     : Observation;
   begin
      if Used.On then
         Observe (This, Commands, Sensors_Of (Got), Used.By, Seen);
         Run_Cards (Cards, This, Watched, Got, Result.By_Card, Has_Ended);
         Result.Sticks := Test_Runs.To_Sticks (Cards.Run);
         Steer
           (This, Commands, Seen, Result.Sticks,
            Test_Runs.To_Commands (Cards.Run), Used.Table);
         pragma Assert
           (Is_Frame (Before, This, Commands, Sensors_Of (Got), Used.By));
         Result.By_Law := not Is_All_Stick (This);
         Result.Message :=
           (if Result.By_Card and then not Result.By_Law
            then With_Sticks (This.Heard, Result.Sticks)
            else Output (This, Commands, Result.Sticks));
         Result.Is_Sent := True;

         --  Its parts, for the proof.
         pragma Assert
           (if not Result.By_Law and then not Result.By_Card
            then Result.Message = Commands);
         pragma Assert
           (if Result.By_Law or else Result.By_Card
            then not Is_Old (Result.Message));
         pragma Assert
           (if Result.By_Card and then not Result.By_Law
            then
              (for all Name in Command_Item =>
                 Result.Message (Name) =
                   Stick_Word
                     (This.Heard (Name), Input_Of (Name, Result.Sticks))));
         pragma Assert
           (if Result.By_Law
            then
              (for all Name in Command_Item range Brake .. Switch_8 =>
                 Result.Message (Name) = This.Heard (Name)));
         pragma Assert
           (if This.Link.State = Waiting
              or else Is_Disconnected (Commands_Of (Got))
            then not Result.By_Law and then not Result.By_Card);
         pragma Assert
           (if not Result.By_Card then Result.Sticks = No_Sticks);
         pragma Assert
           (if not Is_Old (Commands_Of (Got))
            then This.Heard = Commands_Of (Got)
            else This.Heard = Before.Heard);
      else
         Has_Ended := False;
         Result := Without_Laws (Got);
      end if;
   end Fly;

   procedure Watch
     (This     : in out Monitor;
      Checks   : Check_Table;
      Flown    : Flight;
      Added    : Increments;
      Got      : Inputs;
      Reported : out Health)
   is
      Before  : constant Monitor := This with Ghost;
      Sensors : constant Downlink_Buffer := Sensors_Of (Got);
      Seen    : Monitor with Ghost;
   begin
      Surface_Monitor.Advance (This, Sensors);
      Seen := This;
      This.Engine := Engine_After (This, Sensors, Checks);
      Reported := Reported_Health
        ((Failed => This.Failed, Places => This.Places), Flown.By_Law);

      --  The servos' words of this frame.
      if Is_Old (Flown.Message) then
         Note_None_Sent (This);
      else
         Note_Sent (This, Sent_Words (Flown.Message, Reported, Added));
         This.Power := Level_Of (Flown.Message (Throttle));
      end if;
      pragma Assert
        (This.Ranges = Seen.Ranges
         and then This.Doubts = Seen.Doubts
         and then This.Failed = Seen.Failed
         and then This.Places = Seen.Places);
      pragma Assert (Are_Watched (Before, This, Sensors));
   end Watch;

   procedure Decide
     (This   : in out Kept;
      Usual  : Settings;
      Got    : Inputs;
      Result : out Decision)
   is
      Ran : constant Boolean := Test_Runs.Is_Running (This.Cards.Run)
      with Ghost;
   begin
      Result.Reply := Answer_Of (This, Usual, Got);
      Result.Card_Reply := Card_Answer_Of (This, Usual, Got);
      This.Set := Set_After (This, Usual, Got);
      if Has_Card (Got) then
         This.Cards :=
           Test_Runs.After_Block (Got.Block, This.Cards, Usual.On);
      end if;
      pragma Assert (Test_Runs.Is_Running (This.Cards.Run) = Ran);

      Fly
        (This.Flown, This.Cards, This.Watched, In_Force (Usual, This.Set),
         Got, Result.Flown, Result.Has_Ended);
      pragma Assert
        (if Usual.On
         then Are_Conducted
           (Ran, Test_Runs.Is_Running (This.Cards.Run), This.Flown,
            This.Watched, Got, Result.Has_Ended));
      if Usual.On then
         Result.Added := Test_Runs.To_Servos (This.Cards.Run);
         Watch
           (This.Watched, This.Flown.Checks, Result.Flown, Result.Added, Got,
            Result.Reported);
      else
         Result.Added := Nothing_Added;
         Result.Reported := All_Well;
         pragma Assert (Result.Flown = Without_Laws (Got));
         pragma Assert
           (if not Got.Has_Block
            then Result.Reply = Taken
              and then Result.Card_Reply = Test_Runs.Taken
              and then not Result.Has_Ended);
         pragma Assert
           (if not Got.Has_Block then Result = Passed_On (Got));
      end if;
   end Decide;

end URV.LAW_Steps;
