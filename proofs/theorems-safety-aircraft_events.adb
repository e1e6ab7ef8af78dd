--  SPDX-License-Identifier: Apache-2.0

with Theorems.Safety.Lemmas; use Theorems.Safety.Lemmas;
with Theorems.Type_Codes;
with URV.CORE_Layout;
with URV.CORE_Steps;
with URV.Handshakes;
with URV.MDCIN_Steps;
with URV.PWM_Steps;

package body Theorems.Safety.Aircraft_Events with SPARK_Mode is

   --  CORE and the laws get a message, and MDCIN keeps it.
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

   --  LAW's decision, with the scans of its memory and its output.
   procedure Fly
     (Link       : in out Link_State;
      Heard      : in out Uplink_Buffer;
      Heard_From : in out Scan_Count;
      Commands   : Uplink_Buffer;
      Fresh      : Boolean;
      From       : Scan_Count;
      Scans      : Scan_History;
      Usual      : URV.Laws.Settings;
      Law        : URV.LAW_Steps.Kept;
      Got        : URV.LAW_Steps.Inputs;
      Flown      : out URV.LAW_Steps.Flight;
      Flown_From : out Scan_Count;
      Reported   : out Health;
      Added      : out Increments)
   with
     Global => null,
     Pre    =>
       Is_Of (Commands, Scans, From)
       and then Is_Of (Heard, Scans, Heard_From)
       and then (if Link /= Waiting then Heard_From > 0),
     Post   =>
       Is_Of (Heard, Scans, Heard_From)
       and then (if Link /= Waiting then Heard_From > 0)
       and then Heard_From in Heard_From'Old | From
       and then Flown.Is_Sent = (Usual.On or else Fresh)
       and then
         (if Flown.Is_Sent
          then Is_Flown
            (Flown.Message, Scans, Flown_From, Flown.By_Law, Flown.Sticks))
       and then Flown_From in Heard_From | From
       and then
         (if Fresh
            and then
              (not Usual.On or else URV.Laws.Is_Disconnected (Commands))
          then not Flown.By_Law
            and then not Flown.By_Card
            and then Flown.Message = Commands)
       and then
         (if Is_Old (Commands)
            and then not Flown.By_Law
            and then not Flown.By_Card
          then Is_Old (Flown.Message))
       and then
         (if not Usual.On then not Flown.By_Law and then not Flown.By_Card)
       and then Is_Added (Added, Flown.By_Card)
       and then Is_Added (Flown.Sticks, Flown.By_Card)
       and then
         Is_Reported (Reported, Flown.By_Law)
       and then
         (if not Usual.On
          then Is_Reported (Reported, By_Law => False));

   --  The PWM task's words, with the part of their contract that is needed
   --  here.
   function Words_Of
     (Message : Uplink_Buffer; Reported : Health; Added : Increments)
      return Data_Area
   with
     Global => null,
     Post   =>
       (if Reported.Failed = URV.Surfaces.None
        then Words_Of'Result =
          URV.PWM_Layout.To_Data_Area
            (With_Inputs (Transform (Message), Added)))
       and then Words_Of'Result (URV.PWM_Layout.Channel_Of (Brake)) =
         Transform (Message) (Brake)
       and then Words_Of'Result (URV.PWM_Layout.Channel_Of (Discretes)) =
         Transform (Message) (Discretes);

   procedure Run_TELIN
     (Item  : in out Aircraft_Way;
      Line  : Line_Way;
      Scans : Scan_History;
      Done  : Scan_Count;
      Which : Block_Count)
   is
      Came           : constant Boolean := Which in 1 .. Line.Given;
      Unused_Success : Boolean;
   begin
      if Came then
         Item.Kept := URV.Uplink_Input.Next
           (Item.Kept, URV.Handshakes.Opened,
            Decode (Line.Blocks (Which).Data, URV.Codecs.Uplink.Words));
         Item.Kept_From := Line.Blocks (Which).From;
         Same_Is_Sent
           (Received (Line.Blocks (Which)), Item.Kept.Buffer, Scans,
            Item.Kept_From);
      else
         As_Old_Is_Sent (Item.Kept.Buffer, Scans, Item.Kept_From);
         Item.Kept := URV.Uplink_Input.Next
           (Item.Kept, URV.Handshakes.Nothing_Came, (others => 0));
      end if;
      pragma Assert (Is_Sent (Item.Kept.Buffer, Scans, Item.Kept_From));
      if URV.Uplink_Input.Is_Sent (Item.Kept) then
         Send (Item.TELIN, Item.Kept.Buffer, Unused_Success);
         Item.TELIN_From := Item.Kept_From;
         Same_Is_Sent
           (Item.Kept.Buffer, Contents (Item.TELIN), Scans, Item.TELIN_From);
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
      Item.Given := Message;
      Send (Item.Uplink, Message, Unused_Success);
      Item.Uplink_From := From;
      pragma Assert
        (Is_Of (Contents (Item.Uplink), Scans, Item.Uplink_From));
      pragma Assert (Is_Of (Item.Given, Scans, Item.Uplink_From));
      Send (Item.Commands, Message, Unused_Success);
      Item.Commands_From := From;
      pragma Assert
        (Is_Of (Contents (Item.Commands), Scans, Item.Commands_From));
      pragma Assert (Places_Are_Sound (Item, Scans, Done));
   end Pass_On;

   procedure Run_MDCIN
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   is
      Got     : Uplink_Buffer;
      Message : Uplink_Buffer;
      Fresh   : Boolean;
      From    : Scan_Count;
   begin
      Receive (Item.TELIN, Got, Fresh);
      pragma Assert (Is_Sent (Got, Scans, Item.TELIN_From));
      pragma Assert
        (Is_Sent (Contents (Item.TELIN), Scans, Item.TELIN_From));
      Message := URV.MDCIN_Steps.Passed_On (Got, Fresh, Item.Given);
      if Is_Other_Kind (Got) then
         From := Item.Uplink_From;
         Marked_Is_Of (Item.Given, 0, Scans, From);
      else
         From := Item.TELIN_From;
         Marked_Is_Of (Got, 0, Scans, From);
      end if;
      pragma Assert (Is_Of (Message, Scans, From));
      pragma Assert (Places_Are_Sound (Item, Scans, Done));
      Pass_On (Item, Scans, Done, Message, From);
   end Run_MDCIN;

   procedure Fly
     (Link       : in out Link_State;
      Heard      : in out Uplink_Buffer;
      Heard_From : in out Scan_Count;
      Commands   : Uplink_Buffer;
      Fresh      : Boolean;
      From       : Scan_Count;
      Scans      : Scan_History;
      Usual      : URV.Laws.Settings;
      Law        : URV.LAW_Steps.Kept;
      Got        : URV.LAW_Steps.Inputs;
      Flown      : out URV.LAW_Steps.Flight;
      Flown_From : out Scan_Count;
      Reported   : out Health;
      Added      : out Increments)
   is
      Before : constant URV.LAW_Steps.Kept :=
        (Law with delta
           Flown =>
             (Law.Flown with delta
                Heard => Heard,
                Link  => (Law.Flown.Link with delta State => Link)));
      Inputs : constant URV.LAW_Steps.Inputs :=
        (Got with delta Commands => Commands, Has_Commands => Fresh);
      Memory : URV.LAW_Steps.Kept := Before;
      Result : URV.LAW_Steps.Decision;
   begin
      Marked_Is_Of (Commands, 0, Scans, From);
      if URV.LAW_Steps.Is_Passive (Usual, Inputs) then
         Result := URV.LAW_Steps.Passed_On (Inputs);
      else
         URV.LAW_Steps.Decide (Memory, Usual, Inputs, Result);
      end if;
      Flown := Result.Flown;
      Reported := Result.Reported;
      Added := Result.Added;
      pragma Assert
        (URV.LAW_Steps.Is_Flight
           (Flown, Before.Flown, Memory.Flown, Usual.On, Inputs));
      pragma Assert
        (Is_Of (URV.LAW_Steps.Commands_Of (Inputs), Scans, From));
      Link := Memory.Flown.Link.State;
      Heard := Memory.Flown.Heard;
      if Usual.On
        and then not Is_Old (URV.LAW_Steps.Commands_Of (Inputs))
      then
         Heard_From := From;
      end if;
      pragma Assert (Is_Of (Heard, Scans, Heard_From));
      Flown_From :=
        (if Flown.By_Law or else Flown.By_Card then Heard_From else From);
      pragma Assert
        (if Flown.Is_Sent
         then Is_Flown
           (Flown.Message, Scans, Flown_From, Flown.By_Law, Flown.Sticks));
   end Fly;

   procedure Run_LAW
     (Item  : in out Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count;
      Usual : URV.Laws.Settings;
      Law   : URV.LAW_Steps.Kept;
      Got   : URV.LAW_Steps.Inputs)
   is
      Given          : constant Uplink_Buffer := Contents (Item.Commands);
      Is_Passed_On   : constant Boolean :=
        Is_Fresh (Item.Commands)
        and then
          (not Usual.On or else URV.Laws.Is_Disconnected (Given));
      Commands       : Uplink_Buffer;
      Fresh          : Boolean;
      Flown          : URV.LAW_Steps.Flight;
      Flown_From     : Scan_Count;
      Unused_Success : Boolean;
   begin
      Receive (Item.Commands, Commands, Fresh);
      Same_Disconnect (Commands, Given);
      pragma Assert (if Is_Passed_On then Fresh);
      pragma Assert (Item.Commands_From <= Done);
      pragma Assert (Is_Of (Commands, Scans, Item.Commands_From));
      pragma Assert
        (Is_Of (Contents (Item.Commands), Scans, Item.Commands_From));
      Fly
        (Item.Law_Link, Item.Heard, Item.Heard_From, Commands, Fresh,
         Item.Commands_From, Scans, Usual, Law, Got, Flown, Flown_From,
         Item.Reported, Item.Added);
      if Flown.Is_Sent then
         Send (Item.PWM, Flown.Message, Unused_Success);
         Item.PWM_By_Law := Flown.By_Law;
         Item.PWM_By_Card := Flown.By_Card;
         Item.PWM_Sticks := Flown.Sticks;
         Item.PWM_From := Flown_From;
         pragma Assert
           (Is_Flown
              (Contents (Item.PWM), Scans, Item.PWM_From, Item.PWM_By_Law,
               Item.PWM_Sticks));
         if Is_Passed_On then
            Same_Through (Flown.Message, Commands, Given);
            Same_Through (Contents (Item.PWM), Flown.Message, Given);
         end if;
         pragma Assert (Is_Reported (Item.Reported, Item.PWM_By_Law));
         pragma Assert (Is_Added (Item.Added, Item.PWM_By_Card));
      else
         pragma Assert (not Is_Passed_On);
         pragma Assert (Is_Reported (Item.Reported, By_Law => False));
         pragma Assert (Is_Reported (Item.Reported, Item.PWM_By_Law));
         pragma Assert (Is_Added (Item.Added, By_Card => False));
         pragma Assert (Is_Added (Item.Added, Item.PWM_By_Card));
      end if;
      pragma Assert
        (if Is_Passed_On
         then not Item.PWM_By_Law and then Contents (Item.PWM) = Given);
      pragma Assert (Places_Are_Sound (Item, Scans, Done));
   end Run_LAW;

   function Words_Of
     (Message : Uplink_Buffer; Reported : Health; Added : Increments)
      return Data_Area
   is
   begin
      if Reported.Failed = URV.Surfaces.None then
         Same_With_Inputs
           (Servos (Message, Reported), Transform (Message), Added);
      end if;
      return URV.PWM_Steps.Area_Of (Message, Reported, Added);
   end Words_Of;

   procedure Run_PWM
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   is
      Message : Uplink_Buffer;
      Fresh   : Boolean;
   begin
      Receive (Item.PWM, Message, Fresh);
      pragma Assert (Item.PWM_From <= Done);
      pragma Assert
        (Is_Flown
           (Message, Scans, Item.PWM_From, Item.PWM_By_Law,
            Item.PWM_Sticks));
      if URV.PWM_Steps.Is_Written (Message, Fresh) then
         pragma Assert
           (if Item.Reported.Failed /= URV.Surfaces.None
            then Item.PWM_By_Law);
         Item.Board := Words_Of (Message, Item.Reported, Item.Added);
         Item.Board_Added := Item.Added;
         Item.Board_Made_Up := Item.Reported.Failed /= URV.Surfaces.None;
         Item.Board_Of := Message;
         Item.Board_From := Item.PWM_From;
         Item.Board_By_Law := Item.PWM_By_Law;
         Item.Board_Sticks := Item.PWM_Sticks;
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
      if URV.CORE_Steps.Is_Written (Fresh) then
         Theorems.Type_Codes.Into_CORE_By_Code (Item.CORE, Message);
         Item.CORE := URV.CORE_Steps.Words_After
           ((Codes => URV.CORE_Layout.Uplink_Type_Codes, Words => Item.CORE),
            Message);
         Item.CORE_From := Item.Uplink_From;
         Item.Is_Cleared := False;
         pragma Assert
           (for all Name in Uplink_Item =>
              Item.CORE (Name) = Message (Name));
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
      pragma Assert (Is_Reported (All_Well, By_Law => False));
      if Cold then
         Item.TELIN := Empty_Mailbox;
         Item.TELIN_From := 0;
         Item.Uplink := Empty_Mailbox;
         Item.Uplink_From := 0;
         Item.Given := Neutral_Uplink;
         Item.Commands := Empty_Mailbox;
         Item.Commands_From := 0;
         Item.Law_Link := Waiting;
         Item.Heard := Neutral_Uplink;
         Item.Heard_From := 0;
         Item.PWM := Empty_Mailbox;
         Item.PWM_From := 0;
         Item.PWM_By_Law := False;
         Item.PWM_By_Card := False;
         Item.PWM_Sticks := No_Sticks;
         Item.Reported := All_Well;
         Item.Added := Nothing_Added;
         Item.CORE := (others => 0);
         Item.CORE_From := 0;
         Item.Is_Cleared := True;
         Neutral_Is_Safe (Scans);
         Item.Board := URV.PWM_Layout.Safe_Area;
         Item.Board_Made_Up := False;
         Item.Board_Added := Nothing_Added;
         Item.Board_Of := Neutral_Uplink;
         Item.Board_From := 0;
         Item.Board_By_Law := False;
         Item.Board_Sticks := No_Sticks;
         Of_A_Scan_Is_Flown (Neutral_Uplink, Scans, 0);
         Nothing_Is_Added (Transform (Neutral_Uplink), Nothing_Added);
         pragma Assert
           (Item.Board =
              URV.PWM_Layout.To_Data_Area
                (With_Inputs (Transform (Neutral_Uplink), Nothing_Added)));
      else
         Item.TELIN := Restarted (Item.TELIN);
         Item.Uplink := Restarted (Item.Uplink);
         Item.Commands := Restarted (Item.Commands);
         Item.PWM := Restarted (Item.PWM);
         pragma Assert
           (if not Item.Board_Made_Up
            then Item.Board =
              URV.PWM_Layout.To_Data_Area
                (With_Inputs (Transform (Item.Board_Of), Item.Board_Added)));
      end if;
      pragma Assert
        (if not Item.Board_Made_Up
         then Item.Board =
           URV.PWM_Layout.To_Data_Area
             (With_Inputs (Transform (Item.Board_Of), Item.Board_Added)));

      --  The TELIN task's initialisation.
      Item.Kept := (others => <>);
      Item.Kept_From := 0;
      pragma Assert
        (Is_Sent (Contents (Item.TELIN), Scans, Item.TELIN_From));
      pragma Assert
        (Is_Of (Contents (Item.Uplink), Scans, Item.Uplink_From));
      pragma Assert
        (Is_Of (Contents (Item.Commands), Scans, Item.Commands_From));
      pragma Assert
        (Is_Flown
           (Contents (Item.PWM), Scans, Item.PWM_From, Item.PWM_By_Law,
            Item.PWM_Sticks));
      pragma Assert
        (if not Item.Board_Made_Up
         then Item.Board =
           URV.PWM_Layout.To_Data_Area
             (With_Inputs (Transform (Item.Board_Of), Item.Board_Added)));
      pragma Assert (Places_Are_Sound (Item, Scans, Done));
   end Start_Aircraft;

end Theorems.Safety.Aircraft_Events;
