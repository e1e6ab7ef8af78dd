--  SPDX-License-Identifier: Apache-2.0

--  The decision of the LAW task (D-70): what it remembers, what the PWM task
--  is given and which surfaces others make up for (EXT-2, EXT-3, EXT-5,
--  EXT-6). The task receives, calls this decision, sends and reports;
--  Theorems.Safety calls the same decision.
--
--  The decision has three parts, each in a package of its own (D-43): a
--  configuration from the ground, the control laws, and the monitor of
--  surfaces and engine.

with URVOS;               use URVOS;
with URV.Allocation;      use URV.Allocation;
with URV.Buffers;         use URV.Buffers;
with URV.Configurations;  use URV.Configurations;
with URV.Laws;            use URV.Laws;
with URV.Link_Loss;       use URV.Link_Loss;
with URV.Routing;         use URV.Routing;
with URV.Surface_Monitor; use URV.Surface_Monitor;
with URV.Surfaces;        use URV.Surfaces;

package URV.LAW_Steps with Pure, SPARK_Mode is

   --  The task's memory from frame to frame: the laws' memory, the ground's
   --  settings, and the surfaces' monitor.
   type Kept is record
      Flown   : Laws.Memory;
      Set     : Setting;
      Watched : Monitor;
   end record;

   --  The memory at a cold start, and at a warm start, which keeps settings
   --  and failures.

   function At_Start return Kept is
     ((Flown   => Laws.At_Start,
       Set     => Nothing_Set,
       Watched => (others => <>)))
   with Global => null;

   function Restarted (Before : Kept) return Kept is
     ((Before with delta
         Watched => Surface_Monitor.Restarted (Before.Watched)))
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
   --  it is sent. By_Law: a law flies.
   type Flight is record
      After   : Laws.Memory;
      Message : Uplink_Buffer;
      Is_Sent : Boolean;
      By_Law  : Boolean;
   end record;

   --  The surfaces' part. Reported: the failures that others make up for.
   type Surface_Part is record
      Watched  : Monitor;
      Reported : Health;
   end record;

   --  The whole result of a frame.
   type Decision is record
      Flown    : Flight;
      Set      : Setting;
      Surfaces : Surface_Part;
   end record;

   function Kept_After (Result : Decision) return Kept is
     ((Flown   => Result.Flown.After,
       Set     => Result.Set,
       Watched => Result.Surfaces.Watched))
   with Global => null;

   --  A message that has not come in this frame is old.

   function Commands_Of (Got : Inputs) return Uplink_Buffer is
     (if Got.Has_Commands then Got.Commands else As_Old (Got.Commands))
   with Global => null;

   function Sensors_Of (Got : Inputs) return Downlink_Buffer is
     (if Got.Has_Sensors then Got.Sensors else As_Old (Got.Sensors))
   with Global => null;

   --  Configuration

   --  Usual are the node's own settings.
   function Set_After
     (Before : Kept; Usual : Settings; Got : Inputs) return Setting
   is
     (if Got.Has_Block
      then Configurations.After (Before.Set, Got.Block, Usual, Before.Flown)
      else Before.Set)
   with Global => null;

   --  The answer to a configuration; Taken if none has come.
   function Answer_Of
     (Before : Kept; Usual : Settings; Got : Inputs) return Answer
   is
     (if Got.Has_Block then Answer_To (Got.Block, Usual, Before.Flown)
      else Taken)
   with Global => null;

   --  Control laws

   --  With the laws off, new commands pass unchanged. A law that flies marks
   --  no commands as old, and leaves brake and switches to the pilot. No law
   --  flies before the first commands, nor after the pilot's disconnect.
   function Is_Flight
     (Item   : Flight;
      Before : Laws.Memory;
      On     : Boolean;
      Got    : Inputs) return Boolean
   is
     (Item.Is_Sent = (On or else Got.Has_Commands)
      and then
        (if not On
         then not Item.By_Law and then Item.Message = Got.Commands
         elsif not Item.By_Law
         then Item.Message = Commands_Of (Got)
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
         then not Item.By_Law))
   with Global => null, Ghost;

   function Flown_With
     (Before : Laws.Memory; Used : Settings; Got : Inputs) return Flight
   with
     Global => null,
     Post   => Is_Flight (Flown_With'Result, Before, Used.On, Got);

   --  Surfaces and engine

   --  The sensors show how surfaces and engine have followed. The monitor then
   --  takes the words that the PWM task makes of the message. Other surfaces
   --  make up for a failed one only while a law flies. With the laws off the
   --  monitor is unchanged.
   function Surfaces_After
     (Before : Monitor; On : Boolean; Flown : Flight; Got : Inputs)
      return Surface_Part
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
          then Decided'Result.Surfaces.Reported.Failed = None);

end URV.LAW_Steps;
