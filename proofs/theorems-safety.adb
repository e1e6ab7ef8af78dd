--  SPDX-License-Identifier: Apache-2.0

with Theorems.Safety.Aircraft_Events; use Theorems.Safety.Aircraft_Events;
with Theorems.Safety.Ground_Events;   use Theorems.Safety.Ground_Events;
with Theorems.Safety.Lemmas;          use Theorems.Safety.Lemmas;

package body Theorems.Safety with SPARK_Mode is

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
         when AD_Runs =>
            Run_AD (Ground, Scans, Now.AD);
         when GDCOUT_Runs =>
            Run_GDCOUT
              (Ground, Scans, Now.Bits, Now.Order, Now.Is_Ordered);
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
            Run_LAW (Aircraft, Scans, Before, Now.Usual, Now.Law, Now.Got);
         when PWM_Runs =>
            Run_PWM (Aircraft, Scans, Before);
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
         Scanning    => (others => <>),
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
        (Kept        => (others => <>),
         Kept_From   => 0,
         TELIN       => Empty_Mailbox,
         TELIN_From  => 0,
         Uplink      => Empty_Mailbox,
         Uplink_From => 0,
         Given         => Neutral_Uplink,
         Commands      => Empty_Mailbox,
         Commands_From => 0,
         Law_Link    => Waiting,
         Heard       => Neutral_Uplink,
         Heard_From  => 0,
         PWM         => Empty_Mailbox,
         PWM_From    => 0,
         PWM_By_Law  => False,
         PWM_By_Card => False,
         PWM_Sticks  => No_Sticks,
         Reported    => All_Well,
         Added       => Nothing_Added,
         CORE        => (others => 0),
         CORE_From   => 0,
         Is_Cleared  => True,
         Board        => URV.PWM_Layout.Safe_Area,
         Board_Made_Up => False,
         Board_Added   => Nothing_Added,
         Board_Of     => Neutral_Uplink,
         Board_From   => 0,
         Board_By_Law => False,
         Board_Sticks => No_Sticks);
      pragma Assert (Is_Of (Neutral_Uplink, Scans, 0));
      pragma Assert (Is_Reported (All_Well, By_Law => False));
      pragma Assert (Places_Are_Sound (Ground, Scans));
      Nothing_Is_Added (Transform (Neutral_Uplink), Nothing_Added);
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
         case Name is
            when Throttle  =>
               pragma Assert (Safe_Outputs (Name) = Converter_Value'First);
            when Brake     =>
               pragma Assert (Safe_Outputs (Name) = Converter_Value'Last);
            when Discretes =>
               pragma Assert (Safe_Outputs (Name) = 0);
            when others    =>
               pragma Assert (Safe_Outputs (Name) = Neutral_Value);
         end case;
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
         Same_Outputs
           (Item.Board_Of, Scans, Item.Board_From, Item.Board_Sticks);
         Same_With_Inputs
           (Transform (Item.Board_Of),
            Outputs_Of (Scans, Item.Board_From, Item.Board_Sticks),
            Item.Board_Added);
         if Item.Board_From = 0 then
            Nothing_Is_Added
              (Outputs_Of (Scans, Item.Board_From, Item.Board_Sticks),
               Item.Board_Added);
            Without_Sticks (Scans, Item.Board_From, Item.Board_Sticks);
            pragma Assert
              (Item.Board =
                 URV.PWM_Layout.To_Data_Area
                   (Outputs_Of (Scans, Item.Board_From, Item.Board_Sticks)));
            pragma Assert
              (Item.Board =
                 URV.PWM_Layout.To_Data_Area
                   (Outputs_Of (Scans, Item.Board_From)));
         end if;
      else
         Same_Switches
           (Item.Board_Of, Scans, Item.Board_From, Item.Board_By_Law,
            Item.Board_Sticks);
         if Item.Board_Made_Up then
            pragma Assert
              (Item.Board (URV.PWM_Layout.Channel_Of (Brake)) =
                 Outputs_Of (Scans, Item.Board_From) (Brake));
            pragma Assert
              (Item.Board (URV.PWM_Layout.Channel_Of (Discretes)) =
                 Outputs_Of (Scans, Item.Board_From) (Discretes));
         else
            Switches_Are_Out
              (Item.Board, Item.Board_Of, Item.Board_Added, Scans,
               Item.Board_From, Item.Board_By_Law, Item.Board_Sticks);
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
      Same_Switches
           (Item.Board_Of, Scans, Item.Board_From, Item.Board_By_Law,
            Item.Board_Sticks);
      pragma Assert (not Is_On (Commands (Switch)));
      Bit_Is_Off
        (Item.Board (URV.PWM_Layout.Channel_Of (Discretes)), Commands,
         Switch);
      if Switch = Switch_8 and then not Item.Board_Made_Up then
         pragma Assert (Flap_Command (Commands) = Flaps_Up);
         pragma Assert
           (for all Flap in PWM_Item range Left_Flap_1 .. Right_Flap_2 =>
              Transform (Item.Board_Of) (Flap) = Flaps_Up);
         Flaps_Are_Up
           (Item.Board,
            With_Inputs (Transform (Item.Board_Of), Item.Board_Added));
      end if;
   end Switches_Are_Off_Until_A_Scan_Says_On;

   procedure No_Law_Flies_Unless_Asked
     (Item  : in out Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count;
      Usual : URV.Laws.Settings;
      Law   : URV.LAW_Steps.Kept;
      Got   : URV.LAW_Steps.Inputs)
   is
   begin
      Run_LAW (Item, Scans, Done, Usual, Law, Got);
   end No_Law_Flies_Unless_Asked;

   procedure Old_Commands_Move_Nothing
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   is
   begin
      Run_PWM (Item, Scans, Done);
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
      Run_AD
        (Item, Scans,
         (Schedule => Report,
          Time     => 0,
          Timeout  => Begun (0, 0),
          Most     => 0));
   end A_Repeated_Scan_Is_Marked;

   procedure A_Frame_Without_A_Scan_Is_Marked
     (Item : in out Ground_Way; Scans : Scan_History; Got : AD_Inputs)
   is
   begin
      Run_AD (Item, Scans, Got);
   end A_Frame_Without_A_Scan_Is_Marked;

   procedure A_Marked_Image_Is_Sent_As_Old
     (Item       : in out Ground_Way;
      Scans      : Scan_History;
      Bits       : Word;
      Order      : Uplink_Buffer;
      Is_Ordered : Boolean)
   is
   begin
      Run_GDCOUT (Item, Scans, Bits, Order, Is_Ordered);
   end A_Marked_Image_Is_Sent_As_Old;

   procedure A_Repeated_Image_Is_Marked
     (Item       : in out Ground_Way;
      Scans      : Scan_History;
      Bits       : Word;
      Order      : Uplink_Buffer;
      Is_Ordered : Boolean)
   is
   begin
      Run_GDCOUT (Item, Scans, Bits, Order, Is_Ordered);
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
     (Item   : in out Aircraft_Way;
      Scans  : Scan_History;
      Done   : Scan_Count;
      Usual  : URV.Laws.Settings;
      Law    : URV.LAW_Steps.Kept;
      Got    : URV.LAW_Steps.Inputs;
      By_Law : out Boolean)
   is
   begin
      Run_MDCIN (Item, Scans, Done);
      Run_LAW (Item, Scans, Done, Usual, Law, Got);
      By_Law := Item.PWM_By_Law or else Item.PWM_By_Card;
      Run_PWM (Item, Scans, Done);
   end Another_Kind_Moves_Nothing;

   procedure A_Scan_Is_What_Was_Converted
     (Item : in out Scan; Values : Channel_Words; Next : out Next_Step)
   is
   begin
      Item := Restarted (Item);
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
