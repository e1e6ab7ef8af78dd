--  SPDX-License-Identifier: Apache-2.0

with Theorems.Type_Codes;

package body Theorems.Safety with SPARK_Mode is

   --  What is of a scan has the outputs of the scan.
   procedure Same_Outputs
     (Item : Uplink_Buffer; Scans : Scan_History; Scan : Scan_Count)
   with
     Global => null,
     Pre    => Is_Of (Item, Scans, Scan),
     Post   =>
       URV.PWM_Layout.To_Data_Area (Transform (Item)) =
         URV.PWM_Layout.To_Data_Area (Outputs_Of (Scans, Scan));

   --  So have the brake, the flaps and the discretes where a law flies.
   procedure Same_Switches
     (Item : Uplink_Buffer; Scans : Scan_History; Scan : Scan_Count)
   with
     Global => null,
     Pre    => Is_Flown (Item, Scans, Scan, By_Law => True)
       or else Is_Flown (Item, Scans, Scan, By_Law => False),
     Post   =>
       (for all Name in PWM_Item range Brake .. Discretes =>
          Transform (Item) (Name) = Outputs_Of (Scans, Scan) (Name));

   --  The same outputs are the same data area.
   procedure Same_Area (One, Other : PWM_Buffer)
   with
     Global => null,
     Pre    => (for all Name in PWM_Item => One (Name) = Other (Name)),
     Post   =>
       URV.PWM_Layout.To_Data_Area (One) =
         URV.PWM_Layout.To_Data_Area (Other);

   --  Marking commands does not change them.
   procedure Marked_Is_Of
     (Item  : Uplink_Buffer;
      Bits  : Word;
      Scans : Scan_History;
      Scan  : Scan_Count)
   with
     Global => null,
     Pre    => Is_Of (Item, Scans, Scan),
     Post   =>
       Is_Of (Marked (Item, Bits), Scans, Scan)
       and then Is_Of (As_Old (Item), Scans, Scan)
       and then Is_Old (As_Old (Item))
       and then Is_Of (As_Old (Marked (Item, Bits)), Scans, Scan)
       and then Is_Old (As_Old (Marked (Item, Bits)));

   procedure As_Old_Is_Sent
     (Item : Uplink_Buffer; Scans : Scan_History; Scan : Scan_Count)
   with
     Global => null,
     Pre    => Is_Sent (Item, Scans, Scan),
     Post   =>
       Is_Sent (As_Old (Item), Scans, Scan) and then Is_Old (As_Old (Item));

   procedure Same_Is_Sent
     (One, Other : Uplink_Buffer; Scans : Scan_History; Scan : Scan_Count)
   with
     Global => null,
     Pre    => Is_Sent (One, Scans, Scan) and then One = Other,
     Post   => Is_Sent (Other, Scans, Scan);

   procedure Same_Is_Sent
     (One, Other : Uplink_Buffer; Scans : Scan_History; Scan : Scan_Count)
   is null;

   procedure Same_Area (One, Other : PWM_Buffer) is
      One_Area   : constant Data_Area := URV.PWM_Layout.To_Data_Area (One);
      Other_Area : constant Data_Area := URV.PWM_Layout.To_Data_Area (Other);
   begin
      for Name in PWM_Item loop
         pragma Assert
           (One_Area (URV.PWM_Layout.Channel_Of (Name)) =
              Other_Area (URV.PWM_Layout.Channel_Of (Name)));
         pragma Loop_Invariant
           (for all Number in 1 .. URV.PWM_Layout.Channel_Of (Name) =>
              One_Area (Number) = Other_Area (Number));
      end loop;
   end Same_Area;

   --  What is packed of a switch that is off.
   procedure Bit_Is_Off
     (Discretes : Word; Commands : Uplink_Buffer; Switch : Switch_Item)
   with
     Global => null,
     Pre    =>
       Discretes = Packed_Switches (Commands)
       and then not Is_On (Commands (Switch)),
     Post   => (Discretes and Switch_Bit (Switch)) = 0;

   procedure Bit_Is_Off
     (Discretes : Word; Commands : Uplink_Buffer; Switch : Switch_Item)
   is null;

   procedure Same_Outputs
     (Item : Uplink_Buffer; Scans : Scan_History; Scan : Scan_Count)
   is
      Other : constant Uplink_Buffer :=
        To_Uplink (Stamped (Held (Scans, Scan), Fresh => True));
   begin
      pragma Assert
        (for all Name in Command_Item => Item (Name) = Other (Name));
      pragma Assert (Packed_Switches (Item) = Packed_Switches (Other));
      pragma Assert (Flap_Command (Item) = Flap_Command (Other));
      Same_Area (Transform (Item), Outputs_Of (Scans, Scan));
   end Same_Outputs;

   procedure Same_Switches
     (Item : Uplink_Buffer; Scans : Scan_History; Scan : Scan_Count)
   is
      Other : constant Uplink_Buffer :=
        To_Uplink (Stamped (Held (Scans, Scan), Fresh => True));
   begin
      pragma Assert
        (for all Name in Switch_Item => Item (Name) = Other (Name));
      pragma Assert (Item (Brake) = Other (Brake));
      pragma Assert (Packed_Switches (Item) = Packed_Switches (Other));
      pragma Assert (Flap_Command (Item) = Flap_Command (Other));
      pragma Assert (Outputs_Of (Scans, Scan) = Transform (Other));
      pragma Assert (Transform (Item) (Brake) = Transform (Other) (Brake));
      pragma Assert
        (for all Name in PWM_Item range Left_Flap_1 .. Right_Flap_2 =>
           Transform (Item) (Name) = Transform (Other) (Name));
      pragma Assert
        (Transform (Item) (Discretes) = Transform (Other) (Discretes));
   end Same_Switches;

   procedure Marked_Is_Of
     (Item  : Uplink_Buffer;
      Bits  : Word;
      Scans : Scan_History;
      Scan  : Scan_Count)
   is null;

   procedure As_Old_Is_Sent
     (Item : Uplink_Buffer; Scans : Scan_History; Scan : Scan_Count)
   is
   begin
      if not Is_Other_Kind (Item) then
         Marked_Is_Of (Item, 0, Scans, Scan);
      end if;
   end As_Old_Is_Sent;

   --  What was true with fewer scans is true with more.
   procedure More_Scans
     (Line     : Line_Way;
      Aircraft : Aircraft_Way;
      Scans    : Scan_History;
      Done     : Scan_Count;
      More     : Scan_Count)
   with
     Global => null,
     Pre    =>
       Is_Sound (Line, Scans, Done)
       and then Is_Sound (Aircraft, Scans, Done)
       and then Done <= More,
     Post   =>
       Is_Sound (Line, Scans, More)
       and then Is_Sound (Aircraft, Scans, More);

   procedure More_Scans
     (Line     : Line_Way;
      Aircraft : Aircraft_Way;
      Scans    : Scan_History;
      Done     : Scan_Count;
      More     : Scan_Count)
   is
      pragma Unreferenced (Done);
   begin
      pragma Assert (Blocks_Are_Sound (Line, Scans, More));
      pragma Assert (Places_Are_Sound (Aircraft, Scans, More));
   end More_Scans;

   --  The events. Each has the text of a task's body.

   procedure End_Scan (Item : in out Ground_Way; Scans : Scan_History)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans),
     Post   => Is_Sound (Item, Scans) and then Item.Done >= Item'Old.Done;

   procedure Discard_Scan (Item : in out Ground_Way; Scans : Scan_History)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans),
     Post   => Is_Sound (Item, Scans) and then Item.Done = Item'Old.Done;

   procedure Run_AD (Item : in out Ground_Way; Scans : Scan_History)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans),
     Post   =>
       Is_Sound (Item, Scans)
       and then Item.Done = Item'Old.Done
       and then
         (if not Is_Fresh (Item'Old.ADINT)
          then Contents (Item.AD).Error_Status = Stale_Data);

   procedure Run_GDCOUT
     (Item  : in out Ground_Way;
      Scans : Scan_History;
      Bits  : Word;
      Order : Uplink_Buffer)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans),
     Post   =>
       Is_Sound (Item, Scans)
       and then Item.Done = Item'Old.Done
       and then
         (if not Is_Fresh (Item'Old.AD)
            or else Contents (Item'Old.AD).Error_Status = Stale_Data
          then Is_Old (Contents (Item.TELOUT))
            or else Is_Other_Kind (Contents (Item.TELOUT)));

   procedure Run_TELOUT
     (Item  : in out Ground_Way;
      Line  : in out Line_Way;
      Scans : Scan_History)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans) and then Is_Sound (Line, Scans, Item.Done),
     Post   =>
       Is_Sound (Item, Scans)
       and then Item.Done = Item'Old.Done
       and then Is_Sound (Line, Scans, Item.Done);

   procedure Start_Ground
     (Item : in out Ground_Way; Scans : Scan_History; Cold : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans),
     Post   => Is_Sound (Item, Scans) and then Item.Done = Item'Old.Done;

   procedure Run_TELIN
     (Item  : in out Aircraft_Way;
      Line  : Line_Way;
      Scans : Scan_History;
      Done  : Scan_Count;
      Which : Block_Count)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans, Done) and then Is_Sound (Line, Scans, Done),
     Post   =>
       Is_Sound (Item, Scans, Done)
       and then Item.Board = Item'Old.Board
       and then
         (if Which = 0 and then Item'Old.Has_Message
          then Is_Old (Contents (Item.TELIN)));

   procedure Run_MDCIN
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       Is_Sound (Item, Scans, Done)
       and then Item.Board = Item'Old.Board
       and then
         (if not Is_Fresh (Item'Old.TELIN)
            or else Is_Other_Kind (Contents (Item'Old.TELIN))
          then Is_Old (Contents (Item.Uplink))
            and then Is_Old (Contents (Item.Commands)))
       and then
         (if Is_Other_Kind (Contents (Item'Old.TELIN))
          then Item.Uplink_From = Item'Old.Uplink_From)
       and then Is_Fresh (Item.Commands);

   --  CORE and the laws get a message.
   procedure Pass_On
     (Item    : in out Aircraft_Way;
      Scans   : Scan_History;
      Done    : Scan_Count;
      Message : Uplink_Buffer;
      From    : Scan_Count)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans, Done)
       and then Comes_From (Message, Scans, From, Done),
     Post   =>
       Is_Sound (Item, Scans, Done)
       and then Item.Board = Item'Old.Board
       and then Contents (Item.Uplink) = Message
       and then Contents (Item.Commands) = Message
       and then Item.Uplink_From = From
       and then Is_Fresh (Item.Commands);

   --  What MDCIN passes on of a message from TELIN_variable, and its scan.
   procedure Choose
     (Item    : Aircraft_Way;
      Scans   : Scan_History;
      Done    : Scan_Count;
      Message : in out Uplink_Buffer;
      Fresh   : Boolean;
      From    : out Scan_Count)
   with
     Global => null,
     Pre    =>
       Comes_From (Contents (Item.Uplink), Scans, Item.Uplink_From, Done)
       and then Was_Sent_From (Message, Scans, Item.TELIN_From, Done),
     Post   =>
       Comes_From (Message, Scans, From, Done)
       and then
         (if not Fresh or else Is_Other_Kind (Message'Old)
          then Is_Old (Message))
       and then
         (if Is_Other_Kind (Message'Old) then From = Item.Uplink_From);

   --  A frame of the laws, of which nothing else counts here.
   procedure Ask_Laws
     (Kept    : in out URV.Laws.Memory;
      Message : Uplink_Buffer;
      Set     : URV.Laws.Settings;
      Sensors : Downlink_Buffer)
   with
     Global => null,
     Post   =>
       (if Is_Old (Message)
        then Kept.Heard = Kept'Old.Heard
        else Kept.Heard = Message)
       and then
         (if Kept'Old.Link.State = Waiting and then Is_Old (Message)
          then Kept.Link.State = Waiting)
       and then (if Kept.Link.State = Waiting
                 then URV.Laws.Is_All_Stick (Kept))
       and then (if URV.Laws.Is_Disconnected (Message)
                 then URV.Laws.Is_All_Stick (Kept));

   --  What the laws make of a message: what they remember of the commands,
   --  and what goes to the PWM task, each with its scan.
   procedure Fly
     (Link       : in out Link_State;
      Heard      : in out Uplink_Buffer;
      Heard_From : in out Scan_Count;
      Message    : Uplink_Buffer;
      From       : Scan_Count;
      Scans      : Scan_History;
      Set        : URV.Laws.Settings;
      Sensors    : Downlink_Buffer;
      Law        : URV.Laws.Memory;
      Flown      : out Uplink_Buffer;
      Flown_From : out Scan_Count;
      By_Law     : out Boolean)
   with
     Global => null,
     Pre    =>
       Is_Of (Message, Scans, From)
       and then Is_Of (Heard, Scans, Heard_From)
       and then (if Link /= Waiting then Heard_From > 0),
     Post   =>
       Is_Of (Heard, Scans, Heard_From)
       and then (if Link /= Waiting then Heard_From > 0)
       and then Heard_From in Heard_From'Old | From
       and then Is_Flown (Flown, Scans, Flown_From, By_Law)
       and then Flown_From in Heard_From | From
       and then
         (if URV.Laws.Is_Disconnected (Message)
          then not By_Law and then Flown = Message)
       and then
         (if Is_Old (Message) and then not By_Law then Is_Old (Flown));

   procedure Run_LAW
     (Item    : in out Aircraft_Way;
      Scans   : Scan_History;
      Done    : Scan_Count;
      Set     : URV.Laws.Settings;
      Sensors : Downlink_Buffer;
      Law     : URV.Laws.Memory)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       Is_Sound (Item, Scans, Done)
       and then Item.Board = Item'Old.Board
       and then
         (if Is_Fresh (Item'Old.Commands)
            and then
              (not Set.On
               or else URV.Laws.Is_Disconnected
                 (Contents (Item'Old.Commands)))
          then not Item.PWM_By_Law
            and then Contents (Item.PWM) = Contents (Item'Old.Commands))
       and then
         (if Is_Fresh (Item'Old.Commands)
            and then Is_Old (Contents (Item'Old.Commands))
            and then not Item.PWM_By_Law
          then Is_Old (Contents (Item.PWM)));

   --  What the PWM task writes; and of its contract what is needed here.
   function Words_Of (Message : Uplink_Buffer; Told : Health) return Data_Area
   with
     Global => null,
     Post   =>
       (if Told.Failed = URV.Surfaces.None
        then Words_Of'Result =
          URV.PWM_Layout.To_Data_Area (Transform (Message)))
       and then Words_Of'Result (URV.PWM_Layout.Channel_Of (Brake)) =
         Transform (Message) (Brake)
       and then Words_Of'Result (URV.PWM_Layout.Channel_Of (Discretes)) =
         Transform (Message) (Discretes);

   --  What has failed reaches the PWM task as the LAW task says it.
   procedure Run_PWM
     (Item    : in out Aircraft_Way;
      Scans   : Scan_History;
      Done    : Scan_Count;
      Watched : Health)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       Is_Sound (Item, Scans, Done)
       and then
         (if not Is_Fresh (Item'Old.PWM)
            or else Is_Old (Contents (Item'Old.PWM))
          then Item.Board = Item'Old.Board);

   procedure Run_CORE
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       Is_Sound (Item, Scans, Done) and then Item.Board = Item'Old.Board;

   procedure Start_Aircraft
     (Item  : in out Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count;
      Cold  : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       Is_Sound (Item, Scans, Done)
       and then
         (if Cold
          then Item.Board = URV.PWM_Layout.Safe_Area
          else Item.Board = Item'Old.Board);

   procedure End_Scan (Item : in out Ground_Way; Scans : Scan_History) is
      Unused_Success : Boolean;
   begin
      if Item.Done < Scan_Count'Last then
         Item.Done := Item.Done + 1;
         Send (Item.ADINT, Scans (Item.Done), Unused_Success);
         Item.ADINT_From := Item.Done;
         pragma Assert
           (Contents (Item.ADINT) = Held (Scans, Item.ADINT_From));
      end if;
      pragma Assert (Places_Are_Sound (Item, Scans));
   end End_Scan;

   procedure Discard_Scan (Item : in out Ground_Way; Scans : Scan_History) is
      Unused_Words : Channel_Words;
      Unused_Fresh : Boolean;
   begin
      Look (Item.ADINT, Unused_Words, Unused_Fresh);
      pragma Assert (Contents (Item.ADINT) = Held (Scans, Item.ADINT_From));
      pragma Assert (Places_Are_Sound (Item, Scans));
   end Discard_Scan;

   procedure Run_AD (Item : in out Ground_Way; Scans : Scan_History) is
      Words          : Channel_Words;
      Fresh          : Boolean;
      Unused_Success : Boolean;
   begin
      Receive (Item.ADINT, Words, Fresh);
      pragma Assert (Words = Held (Scans, Item.ADINT_From));
      Send (Item.AD, Stamped (Words, Fresh), Unused_Success);
      Item.AD_From := Item.ADINT_From;
      pragma Assert (Places_Are_Sound (Item, Scans));
   end Run_AD;

   procedure Run_GDCOUT
     (Item  : in out Ground_Way;
      Scans : Scan_History;
      Bits  : Word;
      Order : Uplink_Buffer)
   is
      Image          : AD_Image;
      Fresh          : Boolean;
      Unused_Success : Boolean;
      Message        : Uplink_Buffer;
   begin
      Receive (Item.AD, Image, Fresh);
      pragma Assert (Is_Of (To_Uplink (Image), Scans, Item.AD_From));
      Marked_Is_Of (To_Uplink (Image), Bits, Scans, Item.AD_From);
      Message := Marked (To_Uplink (Image), Bits);
      if not Fresh then
         Message := As_Old (Message);
      end if;
      if Is_Other_Kind (Order) then
         Message := Order;
      end if;
      Send (Item.TELOUT, Message, Unused_Success);
      Item.TELOUT_From := Item.AD_From;
      pragma Assert (Places_Are_Sound (Item, Scans));
   end Run_GDCOUT;

   procedure Run_TELOUT
     (Item  : in out Ground_Way;
      Line  : in out Line_Way;
      Scans : Scan_History)
   is
      Message        : Uplink_Buffer;
      Fresh          : Boolean;
   begin
      Receive (Item.TELOUT, Message, Fresh);
      pragma Assert (Is_Sent (Message, Scans, Item.TELOUT_From));
      if Fresh and then Line.Given < Block_Count'Last then
         URV.Codecs.Uplink.Round_Trip (Message);
         Line.Given := Line.Given + 1;
         Line.Blocks (Line.Given) :=
           (Data => URV.Codecs.Uplink.Encode (Message),
            From => Item.TELOUT_From);
      end if;
      pragma Assert (Places_Are_Sound (Item, Scans));
      pragma Assert (Blocks_Are_Sound (Line, Scans, Item.Done));
   end Run_TELOUT;

   procedure Start_Ground
     (Item : in out Ground_Way; Scans : Scan_History; Cold : Boolean)
   is
   begin
      if Cold then
         Item.ADINT := Empty_Mailbox;
         Item.ADINT_From := 0;
         Item.AD := Empty_Mailbox;
         Item.AD_From := 0;
         Item.TELOUT := Empty_Mailbox;
         Item.TELOUT_From := 0;
         pragma Assert (Is_Of (Neutral_Uplink, Scans, 0));
      else
         Item.ADINT := Restarted (Item.ADINT);
         Item.AD := Restarted (Item.AD);
         Item.TELOUT := Restarted (Item.TELOUT);
      end if;
      pragma Assert (Places_Are_Sound (Item, Scans));
   end Start_Ground;

   procedure Run_TELIN
     (Item  : in out Aircraft_Way;
      Line  : Line_Way;
      Scans : Scan_History;
      Done  : Scan_Count;
      Which : Block_Count)
   is
      Unused_Success : Boolean;
   begin
      pragma Assert
        (Is_Sent (Contents (Item.TELIN), Scans, Item.TELIN_From));
      if Which in 1 .. Line.Given then
         pragma Assert
           (Is_Sent
              (URV.Codecs.Uplink.Decode (Line.Blocks (Which).Data), Scans,
               Line.Blocks (Which).From));
         Item.Kept := URV.Codecs.Uplink.Decode (Line.Blocks (Which).Data);
         Item.Kept_From := Line.Blocks (Which).From;
         pragma Assert (Item.Kept_From <= Done);
         Item.Has_Message := True;
      else
         As_Old_Is_Sent (Item.Kept, Scans, Item.Kept_From);
         Item.Kept := As_Old (Item.Kept);
      end if;
      pragma Assert (Is_Sent (Item.Kept, Scans, Item.Kept_From));
      pragma Assert
        (Is_Sent (Contents (Item.TELIN), Scans, Item.TELIN_From));

      if Item.Has_Message then
         Send (Item.TELIN, Item.Kept, Unused_Success);
         Item.TELIN_From := Item.Kept_From;
         Same_Is_Sent
           (Item.Kept, Contents (Item.TELIN), Scans, Item.TELIN_From);
      end if;
      pragma Assert (Places_Are_Sound (Item, Scans, Done));
   end Run_TELIN;

   procedure Pass_On
     (Item    : in out Aircraft_Way;
      Scans   : Scan_History;
      Done    : Scan_Count;
      Message : Uplink_Buffer;
      From    : Scan_Count)
   is
      Unused_Success : Boolean;
   begin
      Send (Item.Uplink, Message, Unused_Success);
      Item.Uplink_From := From;
      pragma Assert
        (Is_Of (Contents (Item.Uplink), Scans, Item.Uplink_From));
      Send (Item.Commands, Message, Unused_Success);
      Item.Commands_From := From;
      pragma Assert
        (Is_Of (Contents (Item.Commands), Scans, Item.Commands_From));
      pragma Assert (Places_Are_Sound (Item, Scans, Done));
   end Pass_On;

   procedure Choose
     (Item    : Aircraft_Way;
      Scans   : Scan_History;
      Done    : Scan_Count;
      Message : in out Uplink_Buffer;
      Fresh   : Boolean;
      From    : out Scan_Count)
   is
      pragma Unreferenced (Done);
   begin
      if Is_Other_Kind (Message) then
         From := Item.Uplink_From;
         Message := Contents (Item.Uplink);
         Marked_Is_Of (Message, 0, Scans, From);
         Message := As_Old (Message);
      else
         From := Item.TELIN_From;
         if not Fresh then
            Marked_Is_Of (Message, 0, Scans, From);
            Message := As_Old (Message);
         end if;
      end if;
   end Choose;

   procedure Run_MDCIN
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   is
      Message : Uplink_Buffer;
      Fresh   : Boolean;
      From    : Scan_Count;
   begin
      Receive (Item.TELIN, Message, Fresh);
      pragma Assert (Is_Sent (Message, Scans, Item.TELIN_From));
      pragma Assert
        (Is_Sent (Contents (Item.TELIN), Scans, Item.TELIN_From));
      Choose (Item, Scans, Done, Message, Fresh, From);
      pragma Assert (Places_Are_Sound (Item, Scans, Done));
      Pass_On (Item, Scans, Done, Message, From);
   end Run_MDCIN;

   procedure Ask_Laws
     (Kept    : in out URV.Laws.Memory;
      Message : Uplink_Buffer;
      Set     : URV.Laws.Settings;
      Sensors : Downlink_Buffer)
   is
   begin
      Kept := URV.Laws.Next (Kept, Message, Sensors, Set.By, Set.Table);
   end Ask_Laws;

   procedure Fly
     (Link       : in out Link_State;
      Heard      : in out Uplink_Buffer;
      Heard_From : in out Scan_Count;
      Message    : Uplink_Buffer;
      From       : Scan_Count;
      Scans      : Scan_History;
      Set        : URV.Laws.Settings;
      Sensors    : Downlink_Buffer;
      Law        : URV.Laws.Memory;
      Flown      : out Uplink_Buffer;
      Flown_From : out Scan_Count;
      By_Law     : out Boolean)
   is
      Kept : URV.Laws.Memory :=
        (Law with delta
           Heard => Heard,
           Link  => (Law.Link with delta State => Link));
   begin
      Ask_Laws (Kept, Message, Set, Sensors);
      pragma Assert (if not Is_Old (Message) then From > 0);
      Link := Kept.Link.State;
      Heard := Kept.Heard;
      if not Is_Old (Message) then
         Heard_From := From;
      end if;
      pragma Assert (Is_Of (Heard, Scans, Heard_From));
      Flown := URV.Laws.Output (Kept, Message);
      By_Law := not URV.Laws.Is_All_Stick (Kept);
      Flown_From := (if By_Law then Heard_From else From);
      pragma Assert (Is_Flown (Flown, Scans, Flown_From, By_Law));
   end Fly;

   procedure Run_LAW
     (Item    : in out Aircraft_Way;
      Scans   : Scan_History;
      Done    : Scan_Count;
      Set     : URV.Laws.Settings;
      Sensors : Downlink_Buffer;
      Law     : URV.Laws.Memory)
   is
      Message        : Uplink_Buffer;
      Flown          : Uplink_Buffer;
      Fresh          : Boolean;
      Unused_Success : Boolean;
   begin
      Receive (Item.Commands, Message, Fresh);
      pragma Assert (Item.Commands_From <= Done);
      pragma Assert (Is_Of (Message, Scans, Item.Commands_From));
      pragma Assert
        (Is_Of (Contents (Item.Commands), Scans, Item.Commands_From));
      if Set.On then
         if not Fresh then
            Marked_Is_Of (Message, 0, Scans, Item.Commands_From);
            Message := As_Old (Message);
         end if;
         Fly
           (Item.Law_Link, Item.Heard, Item.Heard_From, Message,
            Item.Commands_From, Scans, Set, Sensors, Law, Flown,
            Item.PWM_From, Item.PWM_By_Law);
         Send (Item.PWM, Flown, Unused_Success);
      elsif Fresh then
         Item.PWM_By_Law := False;
         Item.PWM_From := Item.Commands_From;
         Send (Item.PWM, Message, Unused_Success);
         pragma Assert
           (Is_Flown (Contents (Item.PWM), Scans, Item.PWM_From, False));
      end if;
      pragma Assert (Places_Are_Sound (Item, Scans, Done));
   end Run_LAW;

   function Words_Of (Message : Uplink_Buffer; Told : Health) return Data_Area
   is
      Words : constant PWM_Buffer := Servos (Message, Told);
   begin
      if Told.Failed = URV.Surfaces.None then
         Same_Area (Words, Transform (Message));
      end if;
      return URV.PWM_Layout.To_Data_Area (Words);
   end Words_Of;

   procedure Run_PWM
     (Item    : in out Aircraft_Way;
      Scans   : Scan_History;
      Done    : Scan_Count;
      Watched : Health)
   is
      Told    : constant Health := Told_Of (Watched, Item.PWM_By_Law);
      Message : Uplink_Buffer;
      Fresh   : Boolean;
   begin
      Receive (Item.PWM, Message, Fresh);
      pragma Assert (Item.PWM_From <= Done);
      pragma Assert
        (Is_Flown (Message, Scans, Item.PWM_From, Item.PWM_By_Law));
      if Fresh and then not Is_Old (Message) then
         Item.Board := Words_Of (Message, Told);
         Item.Board_Made_Up := Told.Failed /= URV.Surfaces.None;
         Item.Board_Of := Message;
         Item.Board_From := Item.PWM_From;
         Item.Board_By_Law := Item.PWM_By_Law;
      end if;
      pragma Assert (Places_Are_Sound (Item, Scans, Done));
   end Run_PWM;

   procedure Run_CORE
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   is
      Message        : Uplink_Buffer;
      Fresh          : Boolean;
   begin
      Receive (Item.Uplink, Message, Fresh);
      pragma Assert (Item.Uplink_From <= Done);
      pragma Assert (Is_Of (Message, Scans, Item.Uplink_From));
      if Fresh then
         Theorems.Type_Codes.Into_CORE_By_Code (Item.CORE, Message);
         Item.CORE := URV.CORE_Layout.Stored
           (URV.CORE_Layout.Uplink_Type_Codes, Item.CORE, Message);
         Item.CORE_From := Item.Uplink_From;
         Item.Is_Cleared := False;
         pragma Assert
           (for all Name in Uplink_Item =>
              URV.CORE_Layout.To_Buffer (Item.CORE) (Name) = Message (Name));
      end if;
      pragma Assert (Places_Are_Sound (Item, Scans, Done));
   end Run_CORE;

   procedure Start_Aircraft
     (Item  : in out Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count;
      Cold  : Boolean)
   is
   begin
      pragma Assert (Is_Of (Neutral_Uplink, Scans, 0));
      pragma Assert (Item.Board_From <= Done);
      if Cold then
         Item.TELIN := Empty_Mailbox;
         Item.TELIN_From := 0;
         Item.Uplink := Empty_Mailbox;
         Item.Uplink_From := 0;
         Item.Commands := Empty_Mailbox;
         Item.Commands_From := 0;
         Item.Law_Link := Waiting;
         Item.Heard := Neutral_Uplink;
         Item.Heard_From := 0;
         Item.PWM := Empty_Mailbox;
         Item.PWM_From := 0;
         Item.PWM_By_Law := False;
         Item.CORE := (others => 0);
         Item.CORE_From := 0;
         Item.Is_Cleared := True;
         Neutral_Is_Safe (Scans);
         Item.Board := URV.PWM_Layout.Safe_Area;
         Item.Board_Made_Up := False;
         Item.Board_Of := Neutral_Uplink;
         Item.Board_From := 0;
         Item.Board_By_Law := False;
      else
         Item.TELIN := Restarted (Item.TELIN);
         Item.Uplink := Restarted (Item.Uplink);
         Item.Commands := Restarted (Item.Commands);
         Item.PWM := Restarted (Item.PWM);
      end if;

      --  The TELIN task's initialisation.
      Item.Kept := Neutral_Uplink;
      Item.Kept_From := 0;
      Item.Has_Message := False;
      pragma Assert
        (Is_Sent (Contents (Item.TELIN), Scans, Item.TELIN_From));
      pragma Assert
        (Is_Of (Contents (Item.Uplink), Scans, Item.Uplink_From));
      pragma Assert
        (Is_Of (Contents (Item.Commands), Scans, Item.Commands_From));
      pragma Assert
        (Is_Flown
           (Contents (Item.PWM), Scans, Item.PWM_From, Item.PWM_By_Law));
      pragma Assert
        (if not Item.Board_Made_Up
         then Item.Board =
           URV.PWM_Layout.To_Data_Area (Transform (Item.Board_Of)));
      pragma Assert (Places_Are_Sound (Item, Scans, Done));
   end Start_Aircraft;

   procedure Happen
     (Ground   : in out Ground_Way;
      Line     : in out Line_Way;
      Aircraft : in out Aircraft_Way;
      Scans    : Scan_History;
      Now      : Event)
   is
      Before : constant Scan_Count := Ground.Done;
   begin
      case Now.Kind is
         when Scan_Ends =>
            End_Scan (Ground, Scans);
            More_Scans (Line, Aircraft, Scans, Before, Ground.Done);
         when AD_Discards =>
            Discard_Scan (Ground, Scans);
         when AD_Runs =>
            Run_AD (Ground, Scans);
         when GDCOUT_Runs =>
            Run_GDCOUT (Ground, Scans, Now.Bits, Now.Order);
         when TELOUT_Runs =>
            Run_TELOUT (Ground, Line, Scans);
         when Ground_Cold_Start =>
            Start_Ground (Ground, Scans, Cold => True);
         when Ground_Warm_Start =>
            Start_Ground (Ground, Scans, Cold => False);
         when TELIN_Runs =>
            Run_TELIN (Aircraft, Line, Scans, Before, Now.Which);
         when MDCIN_Runs =>
            Run_MDCIN (Aircraft, Scans, Before);
         when LAW_Runs =>
            Run_LAW (Aircraft, Scans, Before, Now.Set, Now.Sensors, Now.Law);
         when PWM_Runs =>
            Run_PWM (Aircraft, Scans, Before, Now.Watched);
         when CORE_Runs =>
            Run_CORE (Aircraft, Scans, Before);
         when Aircraft_Cold_Start =>
            Start_Aircraft (Aircraft, Scans, Before, Cold => True);
         when Aircraft_Warm_Start =>
            Start_Aircraft (Aircraft, Scans, Before, Cold => False);
      end case;
   end Happen;

   procedure Any_History
     (Scans    : Scan_History;
      Events   : Event_History;
      Upto     : Event_Number;
      Ground   : out Ground_Way;
      Line     : out Line_Way;
      Aircraft : out Aircraft_Way)
   is
   begin
      --  Power up of both nodes.
      Neutral_Is_Safe (Scans);
      Ground :=
        (Done        => 0,
         ADINT       => Empty_Mailbox,
         ADINT_From  => 0,
         AD          => Empty_Mailbox,
         AD_From     => 0,
         TELOUT      => Empty_Mailbox,
         TELOUT_From => 0);
      Line :=
        (Given  => 0,
         Blocks => (others => (Data => (others => 0), From => 0)));
      Aircraft :=
        (Kept        => Neutral_Uplink,
         Kept_From   => 0,
         Has_Message => False,
         TELIN       => Empty_Mailbox,
         TELIN_From  => 0,
         Uplink      => Empty_Mailbox,
         Uplink_From => 0,
         Commands      => Empty_Mailbox,
         Commands_From => 0,
         Law_Link    => Waiting,
         Heard       => Neutral_Uplink,
         Heard_From  => 0,
         PWM         => Empty_Mailbox,
         PWM_From    => 0,
         PWM_By_Law  => False,
         CORE        => (others => 0),
         CORE_From   => 0,
         Is_Cleared  => True,
         Board        => URV.PWM_Layout.Safe_Area,
         Board_Made_Up => False,
         Board_Of     => Neutral_Uplink,
         Board_From   => 0,
         Board_By_Law => False);
      pragma Assert (Is_Of (Neutral_Uplink, Scans, 0));
      pragma Assert (Places_Are_Sound (Ground, Scans));
      pragma Assert (Places_Are_Sound (Aircraft, Scans, Ground.Done));

      for Step in Event_Number range 1 .. Upto loop
         pragma Loop_Invariant (Is_Sound (Ground, Scans));
         pragma Loop_Invariant (Is_Sound (Line, Scans, Ground.Done));
         pragma Loop_Invariant (Is_Sound (Aircraft, Scans, Ground.Done));
         Happen (Ground, Line, Aircraft, Scans, Events (Step));
         pragma Assert (Is_Sound (Line, Scans, Ground.Done));
      end loop;
   end Any_History;

   procedure Neutral_Is_Safe (Scans : Scan_History) is
      Commands : constant Uplink_Buffer :=
        To_Uplink (Stamped (Held (Scans, 0), Fresh => True));
      Safe     : constant PWM_Buffer := Transform (Neutral_Uplink);
   begin
      pragma Assert
        (for all Name in Command_Item =>
           Commands (Name) = Neutral_Uplink (Name));
      pragma Assert (Packed_Switches (Commands) = 0);
      pragma Assert (Packed_Switches (Neutral_Uplink) = 0);
      for Name in PWM_Item loop
         pragma Assert (Safe (Name) = Safe_Outputs (Name));
         pragma Loop_Invariant
           (for all Earlier in PWM_Item'First .. Name =>
              Safe (Earlier) = Safe_Outputs (Earlier));
      end loop;
      pragma Assert
        (for all Name in PWM_Item =>
           Outputs_Of (Scans, 0) (Name) = Safe (Name));
      Same_Area (Outputs_Of (Scans, 0), Safe_Outputs);
      Same_Area (Safe, Safe_Outputs);
   end Neutral_Is_Safe;

   procedure Servos_Were_Asked_For
     (Item : Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   is
   begin
      Neutral_Is_Safe (Scans);
      pragma Assert (Item.Board_From <= Done);
      if not Item.Board_By_Law then
         Same_Outputs (Item.Board_Of, Scans, Item.Board_From);
      else
         Same_Switches (Item.Board_Of, Scans, Item.Board_From);
         if Item.Board_Made_Up then
            pragma Assert
              (Item.Board (URV.PWM_Layout.Channel_Of (Brake)) =
                 Outputs_Of (Scans, Item.Board_From) (Brake));
            pragma Assert
              (Item.Board (URV.PWM_Layout.Channel_Of (Discretes)) =
                 Outputs_Of (Scans, Item.Board_From) (Discretes));
         else
            for Name in PWM_Item range Brake .. Discretes loop
               pragma Assert
                 (Item.Board (URV.PWM_Layout.Channel_Of (Name)) =
                    Transform (Item.Board_Of) (Name));
               pragma Loop_Invariant
                 (for all Earlier in Brake .. Name =>
                    Item.Board (URV.PWM_Layout.Channel_Of (Earlier)) =
                      Outputs_Of (Scans, Item.Board_From) (Earlier));
            end loop;
         end if;
      end if;
   end Servos_Were_Asked_For;

   procedure Switches_Are_Off_Until_A_Scan_Says_On
     (Item   : Aircraft_Way;
      Scans  : Scan_History;
      Done   : Scan_Count;
      Switch : Switch_Item)
   is
      Commands : constant Uplink_Buffer :=
        To_Uplink
          (Stamped (Held (Scans, Item.Board_From), Fresh => True));
   begin
      pragma Assert (Item.Board_From <= Done);
      Same_Switches (Item.Board_Of, Scans, Item.Board_From);
      pragma Assert (not Is_On (Commands (Switch)));
      Bit_Is_Off
        (Item.Board (URV.PWM_Layout.Channel_Of (Discretes)), Commands,
         Switch);
      if Switch = Switch_8 and then not Item.Board_Made_Up then
         pragma Assert (Flap_Command (Commands) = Flaps_Up);
         for Flap in PWM_Item range Left_Flap_1 .. Right_Flap_2 loop
            pragma Assert (Transform (Commands) (Flap) = Flaps_Up);
            pragma Assert
              (Item.Board (URV.PWM_Layout.Channel_Of (Flap)) =
                 Transform (Item.Board_Of) (Flap));
            pragma Loop_Invariant
              (for all Earlier in Left_Flap_1 .. Flap =>
                 Item.Board (URV.PWM_Layout.Channel_Of (Earlier)) =
                   Flaps_Up);
         end loop;
      end if;
   end Switches_Are_Off_Until_A_Scan_Says_On;

   procedure No_Law_Flies_Unless_Asked
     (Item    : in out Aircraft_Way;
      Scans   : Scan_History;
      Done    : Scan_Count;
      Set     : URV.Laws.Settings;
      Sensors : Downlink_Buffer;
      Law     : URV.Laws.Memory)
   is
   begin
      Run_LAW (Item, Scans, Done, Set, Sensors, Law);
   end No_Law_Flies_Unless_Asked;

   procedure Old_Commands_Move_Nothing
     (Item    : in out Aircraft_Way;
      Scans   : Scan_History;
      Done    : Scan_Count;
      Watched : Health)
   is
   begin
      Run_PWM (Item, Scans, Done, Watched);
   end Old_Commands_Move_Nothing;

   procedure A_Warm_Start_Moves_Nothing
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   is
   begin
      Start_Aircraft (Item, Scans, Done, Cold => False);
   end A_Warm_Start_Moves_Nothing;

   procedure A_Repeated_Scan_Is_Marked
     (Item : in out Ground_Way; Scans : Scan_History)
   is
   begin
      Run_AD (Item, Scans);
   end A_Repeated_Scan_Is_Marked;

   procedure A_Marked_Image_Is_Sent_As_Old
     (Item  : in out Ground_Way;
      Scans : Scan_History;
      Bits  : Word;
      Order : Uplink_Buffer)
   is
   begin
      Run_GDCOUT (Item, Scans, Bits, Order);
   end A_Marked_Image_Is_Sent_As_Old;

   procedure A_Repeated_Image_Is_Marked
     (Item  : in out Ground_Way;
      Scans : Scan_History;
      Bits  : Word;
      Order : Uplink_Buffer)
   is
   begin
      Run_GDCOUT (Item, Scans, Bits, Order);
   end A_Repeated_Image_Is_Marked;

   procedure A_Repeated_Block_Is_Marked
     (Item  : in out Aircraft_Way;
      Line  : Line_Way;
      Scans : Scan_History;
      Done  : Scan_Count)
   is
   begin
      Run_TELIN (Item, Line, Scans, Done, Which => 0);
   end A_Repeated_Block_Is_Marked;

   procedure A_Repeated_Message_Is_Marked
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   is
   begin
      Run_MDCIN (Item, Scans, Done);
   end A_Repeated_Message_Is_Marked;

   procedure Another_Kind_Is_No_Commands
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   is
   begin
      Run_MDCIN (Item, Scans, Done);
   end Another_Kind_Is_No_Commands;

   procedure Another_Kind_Moves_Nothing
     (Item    : in out Aircraft_Way;
      Scans   : Scan_History;
      Done    : Scan_Count;
      Set     : URV.Laws.Settings;
      Sensors : Downlink_Buffer;
      Law     : URV.Laws.Memory;
      Watched : Health;
      By_Law  : out Boolean)
   is
   begin
      Run_MDCIN (Item, Scans, Done);
      Run_LAW (Item, Scans, Done, Set, Sensors, Law);
      By_Law := Item.PWM_By_Law;
      Run_PWM (Item, Scans, Done, Watched);
   end Another_Kind_Moves_Nothing;

   procedure A_Scan_Is_What_Was_Converted
     (Before : Scan; Values : Channel_Words)
   is
      Item : Scan := Restarted (Before);
      Next : Next_Step;
   begin
      for Place in Channel loop
         pragma Loop_Invariant
           (Item.Current = Channel_Count (Place)
            and then
              (for all Earlier in Channel =>
                 (if Earlier < Place
                  then Item.Words (Earlier) = Values (Earlier))));
         Store (Item, Values (Place), Next);
         pragma Assert
           (Next = (if Place = Channel'Last then Send_Words
                    else Start_Channel));
      end loop;
      pragma Assert (Item.Words = Values);
   end A_Scan_Is_What_Was_Converted;

end Theorems.Safety;
