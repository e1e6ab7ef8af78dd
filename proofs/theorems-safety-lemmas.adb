--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Safety.Lemmas with SPARK_Mode is

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

   procedure Same_With_Inputs (One, Other : PWM_Buffer; Added : Increments)
   is
      First  : constant PWM_Buffer := With_Inputs (One, Added);
      Second : constant PWM_Buffer := With_Inputs (Other, Added);
   begin
      pragma Assert
        (for all Name in PWM_Item => First (Name) = Second (Name));
      Same_Area (First, Second);
   end Same_With_Inputs;

   procedure Nothing_Is_Added (Outputs : PWM_Buffer; Added : Increments) is
   begin
      Same_Area (With_Inputs (Outputs, Added), Outputs);
   end Nothing_Is_Added;

   procedure Same_Outputs
     (Item   : Uplink_Buffer;
      Scans  : Scan_History;
      Scan   : Scan_Count;
      Sticks : Stick_Inputs)
   is
      Given : constant Uplink_Buffer :=
        To_Uplink (Stamped (Held (Scans, Scan), Fresh => True));
      Other : constant Uplink_Buffer := With_Sticks (Given, Sticks);
   begin
      pragma Assert
        (for all Name in Command_Item =>
           Given (Name) = Held (Scans, Scan) (Channel_Of (Name)));
      pragma Assert
        (for all Name in Command_Item => Item (Name) = Other (Name));
      pragma Assert (Packed_Switches (Item) = Packed_Switches (Other));
      pragma Assert (Flap_Command (Item) = Flap_Command (Other));
      Same_Area (Transform (Item), Outputs_Of (Scans, Scan, Sticks));
   end Same_Outputs;

   procedure Without_Sticks
     (Scans : Scan_History; Scan : Scan_Count; Sticks : Stick_Inputs)
   is
      Given : constant Uplink_Buffer :=
        To_Uplink (Stamped (Held (Scans, Scan), Fresh => True));
      Other : constant Uplink_Buffer := With_Sticks (Given, Sticks);
   begin
      pragma Assert
        (for all Name in Command_Item => Given (Name) = Other (Name));
      pragma Assert (Packed_Switches (Given) = Packed_Switches (Other));
      pragma Assert (Flap_Command (Given) = Flap_Command (Other));
      Same_Area
        (Outputs_Of (Scans, Scan, Sticks), Outputs_Of (Scans, Scan));
   end Without_Sticks;

   procedure Same_Switches
     (Item   : Uplink_Buffer;
      Scans  : Scan_History;
      Scan   : Scan_Count;
      By_Law : Boolean;
      Sticks : Stick_Inputs)
   is
      pragma Unreferenced (By_Law, Sticks);
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

   procedure Area_Has_Output
     (Area : Data_Area; Outputs : PWM_Buffer; Name : PWM_Item)
   is null;

   procedure Flaps_Are_Up (Area : Data_Area; Outputs : PWM_Buffer) is
   begin
      for Flap in PWM_Item range Left_Flap_1 .. Right_Flap_2 loop
         Area_Has_Output (Area, Outputs, Flap);
         pragma Loop_Invariant
           (for all Earlier in Left_Flap_1 .. Flap =>
              Area (URV.PWM_Layout.Channel_Of (Earlier)) = Flaps_Up);
      end loop;
   end Flaps_Are_Up;

   procedure Switches_Are_Out
     (Area   : Data_Area;
      Item   : Uplink_Buffer;
      Added  : Increments;
      Scans  : Scan_History;
      Scan   : Scan_Count;
      By_Law : Boolean;
      Sticks : Stick_Inputs)
   is
      Given  : constant PWM_Buffer := With_Inputs (Transform (Item), Added);
      Wanted : constant PWM_Buffer := Outputs_Of (Scans, Scan);
   begin
      Same_Switches (Item, Scans, Scan, By_Law, Sticks);
      for Name in PWM_Item range Brake .. Discretes loop
         Area_Has_Output (Area, Given, Name);
         pragma Assert (Given (Name) = Transform (Item) (Name));
         pragma Assert (Given (Name) = Wanted (Name));
         pragma Loop_Invariant
           (for all Earlier in Brake .. Name =>
              Area (URV.PWM_Layout.Channel_Of (Earlier)) = Wanted (Earlier));
      end loop;
   end Switches_Are_Out;

   procedure Marked_Is_Of
     (Item  : Uplink_Buffer;
      Bits  : Word;
      Scans : Scan_History;
      Scan  : Scan_Count)
   is null;

   procedure Of_A_Scan_Is_Flown
     (Item : Uplink_Buffer; Scans : Scan_History; Scan : Scan_Count)
   is null;

   procedure As_Old_Is_Sent
     (Item : Uplink_Buffer; Scans : Scan_History; Scan : Scan_Count)
   is
   begin
      if not Is_Other_Kind (Item) then
         Marked_Is_Of (Item, 0, Scans, Scan);
      end if;
   end As_Old_Is_Sent;

   procedure Same_Is_Sent
     (One, Other : Uplink_Buffer; Scans : Scan_History; Scan : Scan_Count)
   is null;

   procedure Same_Through (One, Other, Third : Uplink_Buffer) is null;

   procedure Same_Disconnect (One, Other : Uplink_Buffer) is
   begin
      pragma Assert (One (Error_Status) = Other (Error_Status));
      pragma Assert (One (Switch_7) = Other (Switch_7));
   end Same_Disconnect;

   procedure Bit_Is_Off
     (Discretes : Word; Commands : Uplink_Buffer; Switch : Switch_Item)
   is null;

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

end Theorems.Safety.Lemmas;
