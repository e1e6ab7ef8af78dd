--  SPDX-License-Identifier: Apache-2.0

--  The decision of the LAW task (D-70): what it remembers, what the PWM task
--  is given, which surfaces others make up for, and the inputs of a test card
--  (EXT-2, EXT-3, EXT-5, EXT-6, FTI-1, FTI-3, FTI-4, FTI-5, D-86,
--  D-100). The task receives, calls this decision, sends and reports;
--  Theorems.Safety calls the same decision.
--
--  The decision has four parts, each in a package of its own (D-43): a
--  configuration from the ground, the control laws, the test cards, and the
--  monitor of surfaces and engine. Each part changes the memory in place: it
--  is too large for copies on the stack of a bare board.

with URVOS;               use URVOS;
with URV.Allocation;      use URV.Allocation;
with URV.Buffers;         use URV.Buffers;
with URV.Configurations;  use URV.Configurations;
with URV.Engine_Monitor;  use type URV.Engine_Monitor.Monitor;
with URV.Law_Inputs;      use URV.Law_Inputs;
with URV.Law_Units;       use URV.Law_Units;
with URV.Laws;            use URV.Laws;
with URV.Laws.Frames;     use URV.Laws.Frames;
with URV.Link_Loss;       use URV.Link_Loss;
with URV.Sensor_Checks;   use URV.Sensor_Checks;
with URV.Surface_Monitor; use URV.Surface_Monitor;
with URV.Surfaces;        use URV.Surfaces;
with URV.PWM_Transform;
with URV.Test_Inputs;     use URV.Test_Inputs;
with URV.Test_Runs;
use type URV.Test_Runs.Answer;
use type URV.Test_Runs.Card_Deck;
use type URV.Test_Runs.Run;
with URV.Type_Codes;      use URV.Type_Codes;

package URV.LAW_Steps with Pure, SPARK_Mode is

   --  The task's memory from frame to frame: the laws' memory, the ground's
   --  settings, the surfaces' monitor, and the test cards.
   type Kept is record
      Flown   : Laws.Memory;
      Set     : Setting;
      Watched : Monitor;
      Cards   : Test_Runs.Aboard;
   end record;

   --  The memory at a cold start, and at a warm start, which keeps settings
   --  and failures.

   function At_Start return Kept is
     ((Flown   => Laws.At_Start,
       Set     => Nothing_Set,
       Watched => (others => <>),
       Cards   => Test_Runs.Nothing_Aboard))
   with Global => null;

   function Restarted (Before : Kept) return Kept is
     ((Before with delta
         Watched => Surface_Monitor.Restarted (Before.Watched),
         Cards   => Test_Runs.After_Restart (Before.Cards)))
   with Global => null;

   --  The messages that the task received in a frame, and whether each is
   --  new.
   type Inputs is record
      Block        : Uplink_Buffer;
      Has_Block    : Boolean;
      Sensors      : Downlink_Buffer;
      Has_Sensors  : Boolean;
      Commands     : Uplink_Buffer;
      Has_Commands : Boolean;
   end record;

   --  The laws' part: the message for the PWM task, and whether it is sent.
   --  By_Law: a law flies. By_Card: a test card adds its inputs to servos or
   --  sticks, or has just stopped. Sticks: its inputs to the sticks.
   type Flight is record
      Message : Uplink_Buffer;
      Is_Sent : Boolean;
      By_Law  : Boolean;
      By_Card : Boolean;
      Sticks  : Stick_Inputs;
   end record;

   --  The results of a frame besides the memory. Reported: the failures that
   --  other surfaces make up for. Added: the test inputs to the servos. Reply,
   --  Card_Reply: the answers to a configuration and to a card; Taken if none
   --  has come. Has_Ended: a card ended, or did not start.
   type Decision is record
      Flown      : Flight;
      Reported   : Health;
      Added      : Increments;
      Reply      : Answer;
      Card_Reply : Test_Runs.Answer;
      Has_Ended  : Boolean;
   end record;

   --  A message that has not come in this frame is old.

   function Commands_Of (Got : Inputs) return Uplink_Buffer is
     (if Got.Has_Commands then Got.Commands else As_Old (Got.Commands))
   with Global => null;

   function Sensors_Of (Got : Inputs) return Downlink_Buffer is
     (if Got.Has_Sensors then Got.Sensors else As_Old (Got.Sensors))
   with Global => null;

   --  Configuration

   function Has_Card (Got : Inputs) return Boolean is
     (Got.Has_Block and then Kind_Of (Got.Block) = Test_Card_Kind)
   with Global => null;

   function Has_Configuration (Got : Inputs) return Boolean is
     (Got.Has_Block and then not Has_Card (Got))
   with Global => null;

   --  Usual are the node's own settings.
   function Set_After
     (Before : Kept; Usual : Settings; Got : Inputs) return Setting
   is
     (if Has_Configuration (Got)
      then Configurations.After (Before.Set, Got.Block, Usual, Before.Flown)
      else Before.Set)
   with Global => null;

   --  The answer to a configuration; Taken if none has come.
   function Answer_Of
     (Before : Kept; Usual : Settings; Got : Inputs) return Answer
   is
     (if Has_Configuration (Got)
      then Answer_To (Got.Block, Usual, Before.Flown)
      else Taken)
   with Global => null;

   --  The same for a test card.
   function Card_Answer_Of
     (Before : Kept; Usual : Settings; Got : Inputs) return Test_Runs.Answer
   is
     (if Has_Card (Got)
      then Test_Runs.Answer_To (Got.Block, Before.Cards, Usual.On)
      else Test_Runs.Taken)
   with Global => null;

   --  Only a card's block changes the cards.
   function Deck_After
     (Before : Kept; Usual : Settings; Got : Inputs)
      return Test_Runs.Card_Deck
   is
     (if Has_Card (Got)
      then Test_Runs.After_Block (Got.Block, Before.Cards, Usual.On).Deck
      else Before.Cards.Deck)
   with Global => null, Ghost;

   --  Control laws

   --  With the laws off the commands pass on.
   function Without_Laws (Got : Inputs) return Flight is
     ((Message => Got.Commands,
       Is_Sent => Got.Has_Commands,
       By_Law  => False,
       By_Card => False,
       Sticks  => No_Sticks))
   with Global => null;

   --  With the laws off, new commands pass unchanged. A law that flies marks
   --  no commands as old, and leaves brake and switches to the pilot. With a
   --  test card all words are those of the last commands that were not marked
   --  as old, the sticks with its inputs. No law flies and no card adds before
   --  the first commands, nor after the pilot's disconnect.
   function Is_Flight
     (Item   : Flight;
      Before : Laws.Memory;
      After  : Laws.Memory;
      On     : Boolean;
      Got    : Inputs) return Boolean
   is
     (Item.Is_Sent = (On or else Got.Has_Commands)
      and then
        (if not On
         then not Item.By_Law
           and then not Item.By_Card
           and then Item.Message = Got.Commands
         elsif not Item.By_Law and then not Item.By_Card
         then Item.Message = Commands_Of (Got)
         elsif not Item.By_Law
         then not Is_Old (Item.Message)
           and then
             (for all Name in Command_Item =>
                Item.Message (Name) =
                  Stick_Word
                    (After.Heard (Name), Input_Of (Name, Item.Sticks)))
         else not Is_Old (Item.Message)
           and then
             (for all Name in Command_Item range Brake .. Switch_8 =>
                Item.Message (Name) = After.Heard (Name)))
      and then (if not Item.By_Card then Item.Sticks = No_Sticks)
      and then
        (if On and then not Is_Old (Commands_Of (Got))
         then After.Heard = Commands_Of (Got)
         else After.Heard = Before.Heard)
      and then
        (if Before.Link.State = Waiting
           and then (not On or else Is_Old (Commands_Of (Got)))
         then After.Link.State = Waiting)
      and then
        (if After.Link.State = Waiting
           or else Is_Disconnected (Commands_Of (Got))
         then not Item.By_Law and then not Item.By_Card))
   with Global => null, Ghost;

   --  Test cards

   --  The pilot's disconnect, or no commands yet.
   function Is_Cut (Flown : Laws.Memory; Got : Inputs) return Boolean is
     (Flown.Link.State = Waiting or else Is_Disconnected (Commands_Of (Got)))
   with Global => null;

   --  The facts on which a card depends. The monitor's failures are those of
   --  the last frame.
   function Sight_Of (Flown : Laws.Memory; Watched : Monitor; Got : Inputs)
                      return Test_Runs.Situation
   is
     (Heard     => Flown.Heard,
      Is_New    => not Is_Old (Commands_Of (Got)),
      Is_Cut    => Is_Cut (Flown, Got),
      Is_Linked => Flown.Link.State = Linked,
      Failed    => Watched.Failed /= None,
      Flown     => Flown.Flown,
      Checks    => Flown.Checks)
   with Global => null;

   --  The cards after a frame. An end is reported.
   function Are_Run
     (Before, After : Test_Runs.Aboard;
      Sight         : Test_Runs.Situation;
      Has_Ended     : Boolean) return Boolean
   is
     (After.Deck = Before.Deck
      and then After.Run = Test_Runs.Next (Before.Run, Before.Deck, Sight)
      and then Has_Ended =
        Test_Runs.Has_Ended (Before.Run, After.Run, Sight))
   with Global => null, Ghost;

   --  The facts of a frame's cards that the laws' work does not change. A card
   --  begins only when new commands have switch 5 on. It runs only with this
   --  switch, while the link is there, and while no surface has failed. Its
   --  end is reported. Ran, Runs: a card runs before the frame, and after it.
   function Are_Conducted
     (Ran, Runs : Boolean;
      Flown     : Laws.Memory;
      Watched   : Monitor;
      Got       : Inputs;
      Has_Ended : Boolean) return Boolean
   is
     (if Runs
      then not Is_Cut (Flown, Got)
        and then Flown.Link.State = Linked
        and then PWM_Transform.Is_On (Flown.Heard (Switch_5))
        and then Watched.Failed = None
        and then not Has_Ended
        and then (if not Ran then not Is_Old (Commands_Of (Got)))
      elsif Ran then Has_Ended)
   with Global => null, Ghost;

   --  The laws' frame with its test card. The card sees what the laws have
   --  observed in this frame, and its inputs change their work in it.
   --  With the laws off, cards are unchanged.
   procedure Fly
     (This      : in out Laws.Memory;
      Cards     : in out Test_Runs.Aboard;
      Watched   : Monitor;
      Used      : Settings;
      Got       : Inputs;
      Result    : out Flight;
      Has_Ended : out Boolean)
   with
     Global => null,
     Post   =>
       Is_Flight (Result, This'Old, This, Used.On, Got)
       and then
         (if not Used.On
          then This = This'Old
            and then Result = Without_Laws (Got)
            and then not Has_Ended)
       and then Cards.Deck = Cards'Old.Deck
       and then (if not Used.On then Cards.Run = Cards'Old.Run)
       and then
         (if Used.On
          then Is_Frame
              (This'Old, This, Commands_Of (Got), Sensors_Of (Got), Used.By)
            and then Are_Conducted
              (Test_Runs.Is_Running (Cards.Run'Old),
               Test_Runs.Is_Running (Cards.Run), This, Watched, Got,
               Has_Ended)
            and then Result.Sticks = Test_Runs.To_Sticks (Cards.Run))
       and then
         (if Used.On and then not Result.By_Card
          then Test_Runs.To_Servos (Cards.Run) = Nothing_Added);

   --  Surfaces and engine

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

   --  The surfaces' words that the PWM task makes of a message.
   function Sent_Words
     (Message : Uplink_Buffer; Reported : Health; Added : Increments)
      return Surface_Demands
   is
     (Demands_Of (With_Inputs (Servos (Message, Reported), Added)))
   with Global => null;

   --  The sensors show how surfaces and engine have followed. The monitor then
   --  takes the words that the PWM task makes of the message. Other surfaces
   --  make up for a failed one only while a law flies. Checks: the sensors'
   --  validity in this frame. Added: the test inputs to the servos. Reported:
   --  the failures that others make up for.
   procedure Watch
     (This     : in out Monitor;
      Checks   : Check_Table;
      Flown    : Flight;
      Added    : Increments;
      Got      : Inputs;
      Reported : out Health)
   with
     Global => null,
     Post   =>
       Are_Watched (This'Old, This, Sensors_Of (Got))
       and then This.Engine =
         Engine_After (This'Old, Sensors_Of (Got), Checks)
       and then Reported =
         Reported_Health
           ((Failed => This.Failed, Places => This.Places), Flown.By_Law)
       and then (if not Flown.By_Law then Reported.Failed = None)

       --  The words of the last three frames, and the throttle's.
       and then This.Sent_First = This.Sent_Before'Old
       and then This.Sent_Before = This.Sent'Old
       and then
         (if Is_Old (Flown.Message)
          then This.Sent = This.Sent'Old
            and then This.Unknown = This.Unknown'Old
            and then This.Power = This.Power'Old
          else This.Sent = Sent_Words (Flown.Message, Reported, Added)
            and then This.Unknown = Integer'Max (This.Unknown'Old - 1, 0)
            and then This.Power = Level_Of (Flown.Message (Throttle)));

   --  With the laws off and no block for them, the commands pass on, and the
   --  memory is not used.

   function Is_Passive (Usual : Settings; Got : Inputs) return Boolean is
     (not Usual.On and then not Got.Has_Block)
   with Global => null;

   function Passed_On (Got : Inputs) return Decision is
     ((Flown      => Without_Laws (Got),
       Reported   => All_Well,
       Added      => Nothing_Added,
       Reply      => Taken,
       Card_Reply => Test_Runs.Taken,
       Has_Ended  => False))
   with Global => null;

   --  The whole decision. With the laws off, cards and monitor are unchanged.
   procedure Decide
     (This   : in out Kept;
      Usual  : Settings;
      Got    : Inputs;
      Result : out Decision)
   with
     Global => null,
     Post   =>
       Is_Flight (Result.Flown, This.Flown'Old, This.Flown, Usual.On, Got)
       and then This.Set = Set_After (This'Old, Usual, Got)
       and then Result.Reply = Answer_Of (This'Old, Usual, Got)
       and then Result.Card_Reply = Card_Answer_Of (This'Old, Usual, Got)
       and then
         (if not Result.Flown.By_Law then Result.Reported.Failed = None)
       and then
         (if not Usual.On then This.Watched = This.Watched'Old)
       and then This.Cards.Deck = Deck_After (This'Old, Usual, Got)

       --  The laws' frame, with the settings of this frame, and the monitor's.
       and then
         (if Usual.On
          then Is_Frame
              (This.Flown'Old, This.Flown, Commands_Of (Got),
               Sensors_Of (Got), In_Force (Usual, This.Set).By)
            and then Are_Watched
              (This.Watched'Old, This.Watched, Sensors_Of (Got))
            and then Result.Reported =
              Reported_Health
                ((Failed => This.Watched.Failed,
                  Places => This.Watched.Places), Result.Flown.By_Law)
            and then Result.Added = Test_Runs.To_Servos (This.Cards.Run)
            and then Result.Flown.Sticks =
                       Test_Runs.To_Sticks (This.Cards.Run))

       and then
         (if Is_Passive (Usual, Got)
          then Result = Passed_On (Got) and then This = This'Old)

       --  Without a card nothing is added. A card begins only when new
       --  commands have switch 5 on. It runs only with this switch, while the
       --  link is there, and while no surface has failed. Its end is reported.
       and then
         (if not Result.Flown.By_Card then Result.Added = Nothing_Added)
       and then
         (if not Usual.On
          then This.Cards.Run = This.Cards.Run'Old
          elsif Test_Runs.Is_Running (This.Cards.Run)
          then not Is_Cut (This.Flown, Got)
            and then This.Flown.Link.State = Linked
            and then PWM_Transform.Is_On (This.Flown.Heard (Switch_5))
            and then This.Watched.Failed'Old = None
            and then
              (if not Test_Runs.Is_Running (This.Cards.Run'Old)
               then not Is_Old (Commands_Of (Got)))
          elsif Test_Runs.Is_Running (This.Cards.Run'Old)
          then Result.Has_Ended);

end URV.LAW_Steps;
