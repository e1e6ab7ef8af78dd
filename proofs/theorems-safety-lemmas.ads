--  SPDX-License-Identifier: Apache-2.0

--  Intermediate steps for the proof of Theorems.Safety (SAF-2). They promise
--  nothing to a user of the flight software.

private package Theorems.Safety.Lemmas with SPARK_Mode, Ghost is

   --  Commands of a scan, with these inputs to its sticks, have the outputs of
   --  the scan with them.
   procedure Same_Outputs
     (Item   : Uplink_Buffer;
      Scans  : Scan_History;
      Scan   : Scan_Count;
      Sticks : Stick_Inputs)
   with
     Global => null,
     Pre    => Is_Flown (Item, Scans, Scan, False, Sticks),
     Post   =>
       URV.PWM_Layout.To_Data_Area (Transform (Item)) =
         URV.PWM_Layout.To_Data_Area (Outputs_Of (Scans, Scan, Sticks))
       and then
         (for all Name in PWM_Item =>
            Transform (Item) (Name) = Outputs_Of (Scans, Scan, Sticks) (Name));

   --  Without inputs these are the outputs of the scan.
   procedure Without_Sticks
     (Scans : Scan_History; Scan : Scan_Count; Sticks : Stick_Inputs)
   with
     Global => null,
     Pre    => Sticks = No_Sticks,
     Post   =>
       URV.PWM_Layout.To_Data_Area (Outputs_Of (Scans, Scan, Sticks)) =
         URV.PWM_Layout.To_Data_Area (Outputs_Of (Scans, Scan));

   --  The brake, the flaps and the discretes are those of the scan, also while
   --  a law flies.
   procedure Same_Switches
     (Item   : Uplink_Buffer;
      Scans  : Scan_History;
      Scan   : Scan_Count;
      By_Law : Boolean;
      Sticks : Stick_Inputs)
   with
     Global => null,
     Pre    => Is_Flown (Item, Scans, Scan, By_Law, Sticks),
     Post   =>
       (for all Name in PWM_Item range Brake .. Discretes =>
          Transform (Item) (Name) = Outputs_Of (Scans, Scan) (Name));

   --  The same outputs give the same data area.
   procedure Same_Area (One, Other : PWM_Buffer)
   with
     Global => null,
     Pre    => (for all Name in PWM_Item => One (Name) = Other (Name)),
     Post   =>
       URV.PWM_Layout.To_Data_Area (One) =
         URV.PWM_Layout.To_Data_Area (Other);

   --  The same outputs with the same test inputs.
   procedure Same_With_Inputs (One, Other : PWM_Buffer; Added : Increments)
   with
     Global => null,
     Pre    =>
       (for all Name in PWM_Item => One (Name) = Other (Name))
       and then
         (for all Name in Servo_Item =>
            One (Name) in Converter_Value
            and then Other (Name) in Converter_Value),
     Post   =>
       URV.PWM_Layout.To_Data_Area (With_Inputs (One, Added)) =
         URV.PWM_Layout.To_Data_Area (With_Inputs (Other, Added));

   --  Without test inputs the outputs are the same.
   procedure Nothing_Is_Added (Outputs : PWM_Buffer; Added : Increments)
   with
     Global => null,
     Pre    =>
       Added = Nothing_Added
       and then
         (for all Name in Servo_Item => Outputs (Name) in Converter_Value),
     Post   =>
       URV.PWM_Layout.To_Data_Area (With_Inputs (Outputs, Added)) =
         URV.PWM_Layout.To_Data_Area (Outputs);

   --  Each output is in its channel.
   procedure Area_Has_Output
     (Area : Data_Area; Outputs : PWM_Buffer; Name : PWM_Item)
   with
     Global => null,
     Pre    => Area = URV.PWM_Layout.To_Data_Area (Outputs),
     Post   => Area (URV.PWM_Layout.Channel_Of (Name)) = Outputs (Name);

   --  The same for flaps that are up.
   procedure Flaps_Are_Up (Area : Data_Area; Outputs : PWM_Buffer)
   with
     Global => null,
     Pre    =>
       Area = URV.PWM_Layout.To_Data_Area (Outputs)
       and then
         (for all Flap in PWM_Item range Left_Flap_1 .. Right_Flap_2 =>
            Outputs (Flap) = Flaps_Up),
     Post   =>
       (for all Flap in PWM_Item range Left_Flap_1 .. Right_Flap_2 =>
          Area (URV.PWM_Layout.Channel_Of (Flap)) = Flaps_Up);

   --  The data area of commands that a law may fly, with test inputs, has the
   --  scan's brake, flaps and discretes.
   procedure Switches_Are_Out
     (Area   : Data_Area;
      Item   : Uplink_Buffer;
      Added  : Increments;
      Scans  : Scan_History;
      Scan   : Scan_Count;
      By_Law : Boolean;
      Sticks : Stick_Inputs)
   with
     Global => null,
     Pre    =>
       Area =
         URV.PWM_Layout.To_Data_Area (With_Inputs (Transform (Item), Added))
       and then Is_Flown (Item, Scans, Scan, By_Law, Sticks),
     Post   =>
       (for all Name in PWM_Item range Brake .. Discretes =>
          Area (URV.PWM_Layout.Channel_Of (Name)) =
            Outputs_Of (Scans, Scan) (Name));

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

   --  Commands of a scan are flown without inputs.
   procedure Of_A_Scan_Is_Flown
     (Item : Uplink_Buffer; Scans : Scan_History; Scan : Scan_Count)
   with
     Global => null,
     Pre    => Is_Of (Item, Scans, Scan),
     Post   => Is_Flown (Item, Scans, Scan, False, No_Sticks);

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

   procedure Same_Through (One, Other, Third : Uplink_Buffer)
   with
     Global => null,
     Pre    => One = Other and then Other = Third,
     Post   => One = Third;

   procedure Same_Disconnect (One, Other : Uplink_Buffer)
   with
     Global => null,
     Pre    => One = Other,
     Post   =>
       URV.Laws.Is_Disconnected (One) = URV.Laws.Is_Disconnected (Other);

   --  The bit of a switch that is off is 0.
   procedure Bit_Is_Off
     (Discretes : Word; Commands : Uplink_Buffer; Switch : Switch_Item)
   with
     Global => null,
     Pre    =>
       Discretes = Packed_Switches (Commands)
       and then not Is_On (Commands (Switch)),
     Post   => (Discretes and Switch_Bit (Switch)) = 0;

   --  A property with fewer scans also holds with more.
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

end Theorems.Safety.Lemmas;
