--  SPDX-License-Identifier: Apache-2.0

--  The decision of the LAW task (D-70): what it remembers, what the PWM task
--  is given, which surfaces others make up for, and the inputs of a test card
--  (EXT-2, EXT-3, EXT-5, EXT-6, FTI-1, FTI-3, FTI-4, FTI-5, D-86). The task
--  receives, calls this decision, sends and reports; Theorems.Safety calls the
--  same decision.
--
--  The decision has four parts, each in a package of its own (D-43): a
--  configuration from the ground, the control laws, the test cards, and the
--  monitor of surfaces and engine.

with URVOS;               use URVOS;
with URV.Allocation;      use URV.Allocation;
with URV.Buffers;         use URV.Buffers;
with URV.Configurations;  use URV.Configurations;
with URV.Laws;            use URV.Laws;
with URV.Link_Loss;       use URV.Link_Loss;
with URV.Routing;         use URV.Routing;
with URV.Surface_Monitor; use URV.Surface_Monitor;
with URV.Surfaces;        use URV.Surfaces;
with URV.PWM_Transform;
with URV.Test_Inputs;     use URV.Test_Inputs;
with URV.Test_Runs;
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

   --  The laws' part: their memory, the message for the PWM task, and whether
   --  it is sent. By_Law: a law flies. By_Card: a test card adds its inputs,
   --  or has just stopped.
   type Flight is record
      After   : Laws.Memory;
      Message : Uplink_Buffer;
      Is_Sent : Boolean;
      By_Law  : Boolean;
      By_Card : Boolean;
   end record;

   --  The surfaces' part. Reported: the failures that others make up for.
   type Surface_Part is record
      Watched  : Monitor;
      Reported : Health;
   end record;

   --  The whole result of a frame. Added: the test inputs; Has_Ended: a card
   --  ended, or did not start.
   type Decision is record
      Flown     : Flight;
      Set       : Setting;
      Surfaces  : Surface_Part;
      Cards     : Test_Runs.Aboard;
      Added     : Increments;
      Has_Ended : Boolean;
   end record;

   function Kept_After (Result : Decision) return Kept is
     ((Flown   => Result.Flown.After,
       Set     => Result.Set,
       Watched => Result.Surfaces.Watched,
       Cards   => Result.Cards))
   with Global => null;

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

   function Cards_With
     (Before : Kept; Usual : Settings; Got : Inputs) return Test_Runs.Aboard
   is
     (if Has_Card (Got)
      then Test_Runs.After_Block (Got.Block, Before.Cards, Usual.On)
      else Before.Cards)
   with
     Global => null,
     Post   =>
       Test_Runs.Is_Running (Cards_With'Result.Run) =
         Test_Runs.Is_Running (Before.Cards.Run);

   function Card_Answer_Of
     (Before : Kept; Usual : Settings; Got : Inputs) return Test_Runs.Answer
   is
     (if Has_Card (Got)
      then Test_Runs.Answer_To (Got.Block, Before.Cards, Usual.On)
      else Test_Runs.Taken)
   with Global => null;

   --  Control laws

   --  With the laws off, new commands pass unchanged. A law that flies marks
   --  no commands as old, and leaves brake and switches to the pilot. With a
   --  test card all words are those of the last commands that were not marked
   --  as old. No law flies and no card adds before the first commands, nor
   --  after the pilot's disconnect.
   function Is_Flight
     (Item   : Flight;
      Before : Laws.Memory;
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
                Item.Message (Name) = Item.After.Heard (Name))
         else not Is_Old (Item.Message)
           and then
             (for all Name in Command_Item range Brake .. Switch_8 =>
                Item.Message (Name) = Item.After.Heard (Name)))
      and then
        (if On and then not Is_Old (Commands_Of (Got))
         then Item.After.Heard = Commands_Of (Got)
         else Item.After.Heard = Before.Heard)
      and then
        (if Before.Link.State = Waiting
           and then (not On or else Is_Old (Commands_Of (Got)))
         then Item.After.Link.State = Waiting)
      and then
        (if Item.After.Link.State = Waiting
           or else Is_Disconnected (Commands_Of (Got))
         then not Item.By_Law and then not Item.By_Card))
   with Global => null, Ghost;

   function Flown_With
     (Before : Laws.Memory; Used : Settings; Got : Inputs) return Flight
   with
     Global => null,
     Post   =>
       Is_Flight (Flown_With'Result, Before, Used.On, Got)
       and then not Flown_With'Result.By_Card;

   --  Test cards

   --  The facts on which a card depends. The monitor's failures are those of
   --  the last frame.
   function Sight_Of (Flown : Flight; Watched : Monitor; Got : Inputs)
                      return Test_Runs.Situation
   is
     (Heard     => Flown.After.Heard,
      Is_New    => not Is_Old (Commands_Of (Got)),
      Is_Cut    => Flown.After.Link.State = Waiting
        or else Is_Disconnected (Commands_Of (Got)),
      Is_Linked => Flown.After.Link.State = Linked,
      Failed    => Watched.Failed /= None,
      Checks    => Flown.After.Checks)
   with Global => null;

   --  The laws' part with the inputs of a card, before and after the frame.
   function With_Card
     (Flown : Flight; Is_Cut : Boolean; Before, After : Increments)
      return Flight
   is
     (if Is_Cut
        or else (Before = Nothing_Added and then After = Nothing_Added)
      then Flown
      elsif Flown.By_Law then (Flown with delta By_Card => True)
      else
        (Flown with delta
           By_Card => True,
           Message =>
             (Flown.After.Heard with delta Error_Status => No_Error)))
   with Global => null;

   --  Surfaces and engine

   --  The sensors show how surfaces and engine have followed. The monitor then
   --  takes the words that the PWM task makes of the message. Other surfaces
   --  make up for a failed one only while a law flies. With the laws off the
   --  monitor is unchanged. Added: the test inputs.
   function Surfaces_After
     (Before : Monitor;
      On     : Boolean;
      Flown  : Flight;
      Added  : Increments;
      Got    : Inputs) return Surface_Part
   with
     Global => null,
     Post   =>
       (if not On or else not Flown.By_Law
        then Surfaces_After'Result.Reported.Failed = None);

   --  The whole decision

   function Decided
     (Before : Kept; Usual : Settings; Got : Inputs) return Decision
   with
     Global => null,
     Post   =>
       Is_Flight (Decided'Result.Flown, Before.Flown, Usual.On, Got)
       and then Decided'Result.Set = Set_After (Before, Usual, Got)
       and then
         (if not Decided'Result.Flown.By_Law
          then Decided'Result.Surfaces.Reported.Failed = None)

       --  Without a card nothing is added. A card begins only when new
       --  commands have switch 5 on.
       and then
         (if not Decided'Result.Flown.By_Card
          then Decided'Result.Added = Nothing_Added)
       and then
         (if Test_Runs.Is_Running (Decided'Result.Cards.Run)
            and then not Test_Runs.Is_Running (Before.Cards.Run)
          then not Is_Old (Commands_Of (Got))
            and then PWM_Transform.Is_On
              (Decided'Result.Flown.After.Heard (Switch_5)));

end URV.LAW_Steps;
