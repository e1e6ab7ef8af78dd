--  SPDX-License-Identifier: Apache-2.0

--  Nothing moves that the pilot did not command (SAF-1 to SAF-3, SAF-5, SAF-6,
--  SAF-10, D-13, D-14, FTI-3, FTI-5). Every servo word is that of one real
--  scan of the ground's converter, with a test card's input to its stick or to
--  the servo, a control law's word while one flies, or the safe word. Old
--  commands and warm starts move nothing. This holds over any sequence of
--  scans, task runs, starts, and lost, late, repeated or reordered blocks, up
--  to the limit Longest. A block altered without a wrong checksum is excluded
--  (D-7), as are faults of the hardware.
--
--  The model follows the commands from the ground's converter to the servos
--  and the aircraft's CORE memory. It consists of the code's own mailboxes,
--  decisions, routing, codec, transform and layouts. Beside each place it
--  records the scan of its words, 0 for the neutral words. The theorems show
--  that this record is always true.

with Devices.PWM_Board; use Devices.PWM_Board;
with Telemetry;         use Telemetry;
with URVOS;             use URVOS;
with URVOS.Frames;      use URVOS.Frames;
with URVOS.Task_Trees;  use URVOS.Task_Trees;
with URVOS.Waits;       use URVOS.Waits;
with URV.AD_Scans;      use URV.AD_Scans;
with URV.AD_Steps;      use type URV.AD_Steps.Activity;
with URV.Allocation;    use URV.Allocation;
with URV.Buffers;       use URV.Buffers;
with URV.Codecs;
with URV.Law_Inputs;    use URV.Law_Inputs;
with URV.LAW_Steps;
with URV.Laws;
with URV.Link_Loss;     use URV.Link_Loss;
with URV.Mailboxes;     use URV.Mailboxes;
with URV.PWM_Layout;
with URV.Plain_Blocks;  use URV.Plain_Blocks;
with URV.PWM_Transform; use URV.PWM_Transform;
with URV.Routing;       use URV.Routing;
with URV.Surfaces;      use type URV.Surfaces.Surface_Flags;
with URV.Test_Inputs;   use URV.Test_Inputs;
with URV.Type_Codes;    use URV.Type_Codes;
with URV.Uplink_Input;

package Theorems.Safety with SPARK_Mode, Ghost is

   use For_Stick_Images.Boxes;
   use For_Stick_Words.Boxes;
   use For_Uplink.Boxes;

   Longest : constant := 1_000_000;

   --  All scans of the ground's converter, with any words, in range or not.
   type Scan_Count is range 0 .. Longest;
   subtype Scan_Number is Scan_Count range 1 .. Longest;
   type Scan_History is array (Scan_Number) of Channel_Words;

   --  The words of a scan; the neutral ones before the first scan.
   function Held (Scans : Scan_History; Scan : Scan_Count)
                  return Channel_Words
   is (if Scan = 0 then Neutral_Stick_Words else Scans (Scan))
   with Global => null;

   --  The commands are those of the scan. Without a scan they are marked as
   --  old.
   function Is_Of
     (Item  : Uplink_Buffer;
      Scans : Scan_History;
      Scan  : Scan_Count) return Boolean
   is
     ((for all Name in Command_Item =>
         Item (Name) = Held (Scans, Scan) (Channel_Of (Name)))
      and then (if Scan = 0 then Is_Old (Item)))
   with Global => null;

   --  The same for an uplink: a block of another kind belongs to no scan
   --  (EXT-2).
   function Is_Sent
     (Item  : Uplink_Buffer;
      Scans : Scan_History;
      Scan  : Scan_Count) return Boolean
   is (Is_Other_Kind (Item) or else Is_Of (Item, Scans, Scan))
   with Global => null;

   --  The servo words for a scan (figure 13), with the inputs of a test card
   --  to its sticks.

   function Outputs_Of
     (Scans : Scan_History; Scan : Scan_Count) return PWM_Buffer
   is (Transform (To_Uplink (Stamped (Held (Scans, Scan), Fresh => True))))
   with Global => null;

   function Outputs_Of
     (Scans : Scan_History; Scan : Scan_Count; Sticks : Stick_Inputs)
      return PWM_Buffer
   is
     (Transform
        (With_Sticks
           (To_Uplink (Stamped (Held (Scans, Scan), Fresh => True)), Sticks)))
   with Global => null;

   --  The commands of a scan, with a test card's inputs to its sticks, or with
   --  a law's words in place of the four that it flies. Without a scan no law
   --  flies, and no input is added

   subtype Flown_Item is Command_Item range Roll .. Throttle;

   function Is_Flown
     (Item   : Uplink_Buffer;
      Scans  : Scan_History;
      Scan   : Scan_Count;
      By_Law : Boolean;
      Sticks : Stick_Inputs) return Boolean
   is
     ((for all Name in Command_Item =>
         (if not By_Law or else Name not in Flown_Item
          then Item (Name) =
            Stick_Word
              (Held (Scans, Scan) (Channel_Of (Name)),
               Input_Of (Name, Sticks))))
      and then
        (if Scan = 0
         then Is_Old (Item) and then not By_Law and then Sticks = No_Sticks))
   with Global => null;

   --  The same for a place on the path: its scan is one of the Done scans made

   function Comes_From
     (Item  : Uplink_Buffer;
      Scans : Scan_History;
      Scan  : Scan_Count;
      Done  : Scan_Count) return Boolean
   is (Scan <= Done and then Is_Of (Item, Scans, Scan))
   with Global => null;

   function Was_Sent_From
     (Item  : Uplink_Buffer;
      Scans : Scan_History;
      Scan  : Scan_Count;
      Done  : Scan_Count) return Boolean
   is (Scan <= Done and then Is_Sent (Item, Scans, Scan))
   with Global => null;

   function Was_Flown_From
     (Item   : Uplink_Buffer;
      Scans  : Scan_History;
      Scan   : Scan_Count;
      Done   : Scan_Count;
      By_Law : Boolean;
      Sticks : Stick_Inputs) return Boolean
   is (Scan <= Done and then Is_Flown (Item, Scans, Scan, By_Law, Sticks))
   with Global => null;

   --  The blocks given to the ground's telemetry board.
   type Block_Count is range 0 .. Longest;
   subtype Block_Number is Block_Count range 1 .. Longest;

   type Block is record
      Data : Block_Data;
      From : Scan_Count;
   end record;

   type Block_History is array (Block_Number) of Block;

   --  The ground's part: how many scans were completed, what AD keeps, the
   --  variables, and the scan that each is of.
   type Ground_Way is record
      Done        : Scan_Count;
      Scanning    : URV.AD_Steps.Progress;
      ADINT       : For_Stick_Words.Boxes.Mailbox;
      ADINT_From  : Scan_Count;
      AD          : For_Stick_Images.Boxes.Mailbox;
      AD_From     : Scan_Count;
      TELOUT      : For_Uplink.Boxes.Mailbox;
      TELOUT_From : Scan_Count;
   end record;

   function Places_Are_Sound (Item : Ground_Way; Scans : Scan_History)
                              return Boolean
   is
     (Item.ADINT_From <= Item.Done
      and then Item.AD_From <= Item.Done
      and then Item.TELOUT_From <= Item.Done
      and then Contents (Item.ADINT) = Held (Scans, Item.ADINT_From)
      and then (if Item.ADINT_From = 0
                then not Is_Fresh (Item.ADINT)
                  and then Item.Scanning.Received = 0)
      and then Contents (Item.AD).Words = Held (Scans, Item.AD_From)
      and then (if Item.AD_From = 0
                then Contents (Item.AD).Error_Status = Stale_Data)
      and then Is_Sent (Contents (Item.TELOUT), Scans, Item.TELOUT_From))
   with Global => null;

   --  The same as a single claim, so that a proof need not repeat each place.
   function Is_Sound (Item : Ground_Way; Scans : Scan_History)
                      return Boolean
   is (Places_Are_Sound (Item, Scans))
   with Global => null;

   --  The message of a block in format 1. Theorems.Sealed_Commands has the
   --  seal and format 2.
   function Received (Item : Block) return Uplink_Buffer is
     (URV.Codecs.Uplink.Buffer_Of
        (Decode (Item.Data, URV.Codecs.Uplink.Words)))
   with Global => null;

   --  The line: all blocks ever given to it.
   type Line_Way is record
      Given  : Block_Count;
      Blocks : Block_History;
   end record;

   --  Done is the number of scans made.
   function Blocks_Are_Sound
     (Item  : Line_Way;
      Scans : Scan_History;
      Done  : Scan_Count) return Boolean
   is
     ((for all Which in Block_Number =>
         (if Which <= Item.Given then Item.Blocks (Which).From <= Done))
      and then
        (for all Which in Block_Number =>
           (if Which <= Item.Given
            then Is_Sent
              (Received (Item.Blocks (Which)), Scans,
               Item.Blocks (Which).From))))
   with Global => null;

   function Is_Sound
     (Item  : Line_Way;
      Scans : Scan_History;
      Done  : Scan_Count) return Boolean
   is (Blocks_Are_Sound (Item, Scans, Done))
   with Global => null;

   --  The aircraft's part: TELIN's kept message, the variables, and the ends
   --  of the path, which are the servos and CORE memory unless that is still
   --  cleared.
   type Aircraft_Way is record
      Kept        : URV.Uplink_Input.Kept_Message;
      Kept_From   : Scan_Count;
      TELIN       : For_Uplink.Boxes.Mailbox;
      TELIN_From  : Scan_Count;
      Uplink      : For_Uplink.Boxes.Mailbox;
      Uplink_From : Scan_Count;

      --  MDCIN's kept message: the last one sent, of the same scan as
      --  uplink_variable.
      Given         : Uplink_Buffer;
      Commands      : For_Uplink.Boxes.Mailbox;
      Commands_From : Scan_Count;

      --  The laws' memory as far as needed: the link's state, the last
      --  commands that they used, and their scan.
      Law_Link    : Link_State;
      Heard       : Uplink_Buffer;
      Heard_From  : Scan_Count;

      --  By_Law: a law may have set its own words. By_Card: a test card may
      --  add its inputs. Sticks: its inputs to the sticks, in these words.
      PWM         : For_Uplink.Boxes.Mailbox;
      PWM_From    : Scan_Count;
      PWM_By_Law  : Boolean;
      PWM_By_Card : Boolean;
      PWM_Sticks  : Stick_Inputs;

      --  The failed surfaces that others make up for, as reported by LAW, and
      --  the test inputs to the servos.
      Reported    : Health;
      Added       : Increments;
      CORE        : Uplink_Buffer;
      CORE_From   : Scan_Count;
      Is_Cleared  : Boolean;

      --  The servos' words and their commands. Made_Up: other surfaces make up
      --  for a failed one. Added: the test inputs in them. Sticks: those in
      --  the commands.
      Board         : Data_Area;
      Board_Made_Up : Boolean;
      Board_Added   : Increments;
      Board_Of     : Uplink_Buffer;
      Board_From   : Scan_Count;
      Board_By_Law : Boolean;
      Board_Sticks : Stick_Inputs;
   end record;

   --  The servos' words are figure 13's of the commands, with the inputs of a
   --  test card. If surfaces make up for a failed one, this holds for the
   --  brake and the discretes, and a law flies.
   function Board_Is_Sound
     (Board    : Data_Area;
      Commands : Uplink_Buffer;
      Made_Up  : Boolean;
      Added    : Increments;
      By_Law   : Boolean) return Boolean
   is
     ((if Made_Up then By_Law
       else Board =
         URV.PWM_Layout.To_Data_Area
           (With_Inputs (Transform (Commands), Added)))
      and then Board (URV.PWM_Layout.Channel_Of (Brake)) =
        Transform (Commands) (Brake)
      and then Board (URV.PWM_Layout.Channel_Of (Discretes)) =
        Transform (Commands) (Discretes))
   with Global => null;

   --  Other surfaces make up for a failed one only if a law may fly.
   function Is_Reported (Reported : Health; By_Law : Boolean) return Boolean
   is (if Reported.Failed /= URV.Surfaces.None then By_Law)
   with Global => null;

   --  Nothing is added without a card.

   function Is_Added (Added : Increments; By_Card : Boolean) return Boolean
   is (if not By_Card then Added = Nothing_Added)
   with Global => null;

   function Is_Added (Sticks : Stick_Inputs; By_Card : Boolean) return Boolean
   is (if not By_Card then Sticks = No_Sticks)
   with Global => null;

   function Places_Are_Sound
     (Item  : Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count) return Boolean
   is
     (Was_Sent_From (Item.Kept.Buffer, Scans, Item.Kept_From, Done)
      and then Was_Sent_From
        (Contents (Item.TELIN), Scans, Item.TELIN_From, Done)
      and then Comes_From
        (Contents (Item.Uplink), Scans, Item.Uplink_From, Done)
      and then Comes_From (Item.Given, Scans, Item.Uplink_From, Done)
      and then Comes_From
        (Contents (Item.Commands), Scans, Item.Commands_From, Done)
      and then Comes_From (Item.Heard, Scans, Item.Heard_From, Done)
      and then (if Item.Law_Link /= Waiting then Item.Heard_From > 0)
      and then Was_Flown_From
        (Contents (Item.PWM), Scans, Item.PWM_From, Done, Item.PWM_By_Law,
         Item.PWM_Sticks)
      and then Is_Reported (Item.Reported, Item.PWM_By_Law)
      and then Is_Added (Item.Added, Item.PWM_By_Card)
      and then Is_Added (Item.PWM_Sticks, Item.PWM_By_Card)
      and then Item.CORE_From <= Done
      and then
        (if not Item.Is_Cleared
         then Is_Of
           (Item.CORE, Scans, Item.CORE_From))
      and then Was_Flown_From
        (Item.Board_Of, Scans, Item.Board_From, Done, Item.Board_By_Law,
         Item.Board_Sticks)
      and then Board_Is_Sound
        (Item.Board, Item.Board_Of, Item.Board_Made_Up, Item.Board_Added,
         Item.Board_By_Law)
      and then
        (if Item.Board_From = 0 then Item.Board_Added = Nothing_Added))
   with Global => null;

   function Is_Sound
     (Item  : Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count) return Boolean
   is (Places_Are_Sound (Item, Scans, Done))
   with Global => null;

   --  The events, which come in any order: a scan is complete, a task has
   --  its transaction, a node starts, or stays silent.
   type Event_Kind is
     (Scan_Ends,
      AD_Runs, GDCOUT_Runs, TELOUT_Runs,
      Ground_Cold_Start, Ground_Warm_Start,
      TELIN_Runs, MDCIN_Runs, LAW_Runs, PWM_Runs, CORE_Runs,
      Aircraft_Cold_Start, Aircraft_Warm_Start);

   --  The inputs of AD: its schedule, the time, how long it still waits for
   --  a scan, and the scans of a frame. They have any values.
   type AD_Inputs is record
      Schedule : Schedule_Name;
      Time     : Clock_Tick;
      Timeout  : Wait;
      Most     : URV.AD_Scans.Scan_Count;
   end record;

   --  The inputs of an event have any values. The link's state and the
   --  commands are not among them: they are the aircraft's.
   --  Which: the block that TELIN finds, 0 for none. Bits: the node's own
   --  bits of the error/status word. Order: the block that the console has
   --  ordered besides the sticks, if Is_Ordered. Usual: the laws' settings.
   --  Law: LAW's memory. Got: LAW's received messages.
   type Event is record
      Kind       : Event_Kind;
      AD         : AD_Inputs;
      Which      : Block_Count;
      Bits       : Word;
      Order      : Uplink_Buffer;
      Is_Ordered : Boolean;
      Usual      : URV.Laws.Settings;
      Law        : URV.LAW_Steps.Kept;
      Got        : URV.LAW_Steps.Inputs;
   end record;

   type Event_Number is range 1 .. Longest;
   type Event_History is array (Event_Number) of Event;

   --  An event, as the tasks' bodies and the starts perform it. All commands
   --  remain those of their recorded scan.
   procedure Happen
     (Ground   : in out Ground_Way;
      Line     : in out Line_Way;
      Aircraft : in out Aircraft_Way;
      Scans    : Scan_History;
      Now      : Event)
   with
     Global => null,
     Pre    =>
       Is_Sound (Ground, Scans)
       and then Is_Sound (Line, Scans, Ground.Done)
       and then Is_Sound (Aircraft, Scans, Ground.Done),
     Post   =>
       Is_Sound (Ground, Scans)
       and then Is_Sound (Line, Scans, Ground.Done)
       and then Is_Sound (Aircraft, Scans, Ground.Done)

       --  The servos move only when the PWM task runs with commands that are
       --  not marked as old, or to the safe words at power up.
       and then
         (if Now.Kind = Aircraft_Cold_Start
          then Aircraft.Board = URV.PWM_Layout.Safe_Area
          elsif Now.Kind /= PWM_Runs
            or else not Is_Fresh (Aircraft'Old.PWM)
            or else Is_Old (Contents (Aircraft'Old.PWM))
          then Aircraft.Board = Aircraft'Old.Board);

   --  From power up the record is true, over any sequence of events.
   procedure Any_History
     (Scans    : Scan_History;
      Events   : Event_History;
      Upto     : Event_Number;
      Ground   : out Ground_Way;
      Line     : out Line_Way;
      Aircraft : out Aircraft_Way)
   with
     Global => null,
     Post   =>
       Is_Sound (Ground, Scans)
       and then Is_Sound (Line, Scans, Ground.Done)
       and then Is_Sound (Aircraft, Scans, Ground.Done);

   --  The neutral words are the safe outputs (SAF-1).
   procedure Neutral_Is_Safe (Scans : Scan_History)
   with
     Global => null,
     Post   =>
       Outputs_Of (Scans, 0) = Safe_Outputs
       and then Transform (Neutral_Uplink) = Safe_Outputs
       and then URV.PWM_Layout.Safe_Area =
         URV.PWM_Layout.To_Data_Area (Outputs_Of (Scans, 0))
       and then URV.PWM_Layout.Safe_Area =
         URV.PWM_Layout.To_Data_Area (Transform (Neutral_Uplink));

   --  Each servo word is figure 13's of one scan of the ground's converter,
   --  with the inputs of a test card to its sticks or to the servos (FTI-3),
   --  or the safe word (SAF-2). While
   --  a law flies, this holds for the brake and the discretes, and for the
   --  flaps unless they make up for a failed surface (EXT-6). Without a card
   --  nothing is added; Theorems.Test_Cards shows what a card adds.
   procedure Servos_Were_Asked_For
     (Item : Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       (if Item.Board_From = 0
        then Item.Board = URV.PWM_Layout.Safe_Area
        elsif not Item.Board_By_Law
        then Item.Board_From <= Done
          and then Item.Board =
            URV.PWM_Layout.To_Data_Area
              (With_Inputs
                 (Outputs_Of (Scans, Item.Board_From, Item.Board_Sticks),
                  Item.Board_Added))
        else Item.Board_From <= Done
          and then
            (for all Name in PWM_Item range Brake .. Discretes =>
               (if Name in Brake | Discretes or else not Item.Board_Made_Up
                then Item.Board (URV.PWM_Layout.Channel_Of (Name)) =
                  Outputs_Of (Scans, Item.Board_From) (Name))));

   --  No law flies and no card adds with the laws off, nor with the disconnect
   --  switch on in commands that are not marked as old, whatever the memory
   --  and the sensors. The PWM task then gets MDCIN's message.
   procedure No_Law_Flies_Unless_Asked
     (Item  : in out Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count;
      Usual : URV.Laws.Settings;
      Law   : URV.LAW_Steps.Kept;
      Got   : URV.LAW_Steps.Inputs)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans, Done)
       and then Is_Fresh (Item.Commands)
       and then
         (not Usual.On
          or else URV.Laws.Is_Disconnected (Contents (Item.Commands))),
     Post   =>
       not Item.PWM_By_Law
       and then Item.Added = Nothing_Added
       and then Item.PWM_Sticks = No_Sticks
       and then Contents (Item.PWM) = Contents (Item'Old.Commands);

   --  A switch is off, at its discrete and at the flaps, until a scan turns it
   --  on (SAF-3). Flaps may make up for a failed surface (EXT-6).
   procedure Switches_Are_Off_Until_A_Scan_Says_On
     (Item   : Aircraft_Way;
      Scans  : Scan_History;
      Done   : Scan_Count;
      Switch : Switch_Item)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans, Done)
       and then
         (for all Scan in Scan_Number =>
            (if Scan <= Done
             then not Is_On (Scans (Scan) (Channel_Of (Switch))))),
     Post   =>
       (Item.Board (URV.PWM_Layout.Channel_Of (Discretes))
          and Switch_Bit (Switch)) = 0
       and then
         (if Switch = Switch_8 and then not Item.Board_Made_Up
          then
            (for all Flap in PWM_Item range Left_Flap_1 .. Right_Flap_2 =>
               Item.Board (URV.PWM_Layout.Channel_Of (Flap)) = Flaps_Up));

   --  Commands marked as old move nothing when they reach the PWM task
   --  (SAF-3). A law that flies marks none.
   procedure Old_Commands_Move_Nothing
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans, Done) and then Is_Old (Contents (Item.PWM)),
     Post   => Item.Board = Item'Old.Board;

   --  A warm start moves nothing (SAF-6).
   procedure A_Warm_Start_Moves_Nothing
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   => Item.Board = Item'Old.Board;

   --  A second use of the same data is marked as old (SAF-5): a repeated scan,
   --  image, block, or message in TELIN_variable

   procedure A_Repeated_Scan_Is_Marked
     (Item : in out Ground_Way; Scans : Scan_History)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans) and then not Is_Fresh (Item.ADINT),
     Post   =>
       Is_Sound (Item, Scans)
       and then Contents (Item.AD).Error_Status = Stale_Data;

   --  In the fast schedule: when the wait is over and no scan has come in the
   --  frame.
   procedure A_Frame_Without_A_Scan_Is_Marked
     (Item : in out Ground_Way; Scans : Scan_History; Got : AD_Inputs)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans)
       and then not Is_Fresh (Item.ADINT)
       and then Got.Schedule = Fast
       and then Is_Over (Got.Timeout, Got.Time)
       and then Item.Scanning.Doing = URV.AD_Steps.Scanning
       and then Item.Scanning.Received = 0,
     Post   =>
       Is_Sound (Item, Scans)
       and then Contents (Item.AD).Error_Status = Stale_Data;

   --  It is sent on as old: with the one above, what a frame without a scan
   --  sends up (SAF-10).
   procedure A_Marked_Image_Is_Sent_As_Old
     (Item       : in out Ground_Way;
      Scans      : Scan_History;
      Bits       : Word;
      Order      : Uplink_Buffer;
      Is_Ordered : Boolean)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans)
       and then Contents (Item.AD).Error_Status = Stale_Data,
     Post   =>
       Is_Old (Contents (Item.TELOUT))
       or else Is_Other_Kind (Contents (Item.TELOUT));

   procedure A_Repeated_Image_Is_Marked
     (Item       : in out Ground_Way;
      Scans      : Scan_History;
      Bits       : Word;
      Order      : Uplink_Buffer;
      Is_Ordered : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans) and then not Is_Fresh (Item.AD),
     Post   =>
       Is_Old (Contents (Item.TELOUT))
       or else Is_Other_Kind (Contents (Item.TELOUT));

   procedure A_Repeated_Block_Is_Marked
     (Item  : in out Aircraft_Way;
      Line  : Line_Way;
      Scans : Scan_History;
      Done  : Scan_Count)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans, Done)
       and then Is_Sound (Line, Scans, Done)
       and then Item.Kept.Has_Message,
     Post   => Is_Old (Contents (Item.TELIN));

   procedure A_Repeated_Message_Is_Marked
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans, Done) and then not Is_Fresh (Item.TELIN),
     Post   =>
       Is_Old (Contents (Item.Uplink))
       and then Is_Old (Contents (Item.Commands));

   --  A block of another kind, known or unknown, carries no commands (EXT-2).
   --  CORE and the laws get the last ones, marked as old.
   procedure Another_Kind_Is_No_Commands
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans, Done)
       and then Is_Other_Kind (Contents (Item.TELIN)),
     Post   =>
       Is_Old (Contents (Item.Uplink))
       and then Is_Old (Contents (Item.Commands))
       and then Item.Uplink_From = Item'Old.Uplink_From;

   --  Such a block moves no servo by itself: unless a law flies or a card
   --  runs, the outputs remain.
   procedure Another_Kind_Moves_Nothing
     (Item   : in out Aircraft_Way;
      Scans  : Scan_History;
      Done   : Scan_Count;
      Usual  : URV.Laws.Settings;
      Law    : URV.LAW_Steps.Kept;
      Got    : URV.LAW_Steps.Inputs;
      By_Law : out Boolean)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans, Done)
       and then Is_Other_Kind (Contents (Item.TELIN)),
     Post   => (if not By_Law then Item.Board = Item'Old.Board);

   --  A scan is complete: its words are those converted since it began, one
   --  for each channel. The last conversion sends them.
   procedure A_Scan_Is_What_Was_Converted
     (Item : in out Scan; Values : Channel_Words; Next : out Next_Step)
   with
     Global => null,
     Post   =>
       Item.Words = Values
       and then Is_Complete (Item)
       and then Next = Send_Words;

end Theorems.Safety;
