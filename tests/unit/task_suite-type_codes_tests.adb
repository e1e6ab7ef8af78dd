--  SPDX-License-Identifier: Apache-2.0

with Checks;             use Checks;
with Expectations;       use Expectations;
with GSC;
with Law_Rig;            use Law_Rig;
with MCS;
with Task_Rig;           use Task_Rig;
with URVOS;              use URVOS;
with URV.Buffers;        use URV.Buffers;
with URV.Configurations; use URV.Configurations;
with URV.CORE_Layout;    use URV.CORE_Layout;
with URV.CORE_Memory;    use URV.CORE_Memory;
with URV.CORE_Task;
with URV.Errors;         use URV.Errors;
with URV.Law_Gains;
with URV.Law_Status;
with URV.Laws;           use URV.Laws;
with URV.Laws.Frames;    use URV.Laws.Frames;
with URV.Mailboxes;      use URV.Mailboxes;
with URV.GDCOUT_Task;
with URV.Routing;        use URV.Routing;
with URV.Shared_CORE_Memory;
with URV.Shared_Errors;
with URV.Shared_Status;
with URV.Type_Codes;     use URV.Type_Codes;

separate (Task_Suite)
package body Type_Codes_Tests is

   --  The tests, in order.
   procedure Channels_By_Code;
   procedure Places_By_Code;
   procedure Codes_Of_Nothing;
   procedure Unknown_Up;
   procedure Unknown_Down;
   procedure Ordered;
   procedure Delivered;
   procedure Taken_On_The_Ground;
   procedure Refused_Otherwise;
   procedure Starts;
   procedure Softer;

   --  Orbit after 2 s, glide after 9 s, the softer table.
   Softly : constant Configuration :=
     (Serial => 5, Gains => 1, Orbit_From => 20, End_From => 90);

   Standing : constant Downlink_Buffer :=
     (Level with delta Altitude => 0, Airspeed => 0);

   procedure Clear;

   procedure Clear is
   begin
      MCS.Reset_Variables;
      MCS.Law_Settings.Write (Laws_Off);
      MCS.Errors.Clear;
      MCS.Status.Write (No_Error);
      GSC.Reset_Variables;
      GSC.Errors.Clear;
      GSC.Status.Write (No_Error);
   end Clear;

   --  A node with its first two channels exchanged, and an unknown code on the
   --  third

   Codes : constant Channel_Codes :=
     (Stick_Codes with delta 0 => 16#102#, 1 => 16#101#, 2 => 16#1234#);

   From   : For_Stick_Images.Variable;
   CORE   : For_Uplink.Variable;
   Out_Of : For_Uplink.Variable;
   Orders : For_Uplink.Variable;
   Status : URV.Shared_Status.Status;
   Errors : URV.Shared_Errors.Shared_Log;

   package Turned is new URV.GDCOUT_Task
     (From, CORE, Out_Of, Orders, Status, Errors, Codes);

   procedure Channels_By_Code is
      Image : constant AD_Image := Image_Of (16#300#, Error => 0);
      Item  : Uplink_Buffer;
   begin
      Stick_Images.Give (From, Image);
      Turned.Run_Transaction;
      Item := Up.Taken ("to CORE", CORE);
      Expect ("roll", Item (Roll), Image.Words (1));
      Expect ("pitch", Item (Pitch), Image.Words (0));
      Expect ("yaw has no channel", Item (Yaw), Neutral_Value);
      Expect ("throttle", Item (Throttle), Image.Words (3));
      Expect_Buffer ("to TELOUT", Up.Taken ("to TELOUT", Out_Of), Item);
      Expect_Errors
        ("the third", Errors, (1 => Unknown_Code), Detail => 16#1234#);
   end Channels_By_Code;

   --  CORE

   Uplink   : For_Uplink.Variable;
   Downlink : For_Framed_Downlink.Variable;
   Board    : URV.Shared_CORE_Memory.Board;

   package CORE_Under_Test is new URV.CORE_Task
     (Uplink, Downlink, Board, Errors);

   procedure Places_By_Code is
      Up_Codes   : Uplink_Code_List   := Uplink_Type_Codes;
      Down_Codes : Downlink_Code_List := Downlink_Type_Codes;
      Found      : URV.CORE_Memory.Memory;
   begin
      CORE_Under_Test.Initialise;
      Up.Give (Uplink, Uplink_Of (16#100#));
      Framed.Give (Downlink, Framed_Of (16#200#));
      CORE_Under_Test.Run_Transaction;
      Expect_Errors ("its own codes", Errors, None);

      Up_Codes (Roll) := 16#102#;
      Up_Codes (Pitch) := 16#101#;
      Down_Codes (Right_Flap_2) := 16#101#;
      Board.Write_Codes (Up_Codes, Down_Codes, Status_Type_Codes);
      Up.Give (Uplink, Uplink_Of (16#300#));
      Framed.Give (Downlink, Framed_Of (16#400#));
      CORE_Under_Test.Run_Transaction;
      Found := Board.Contents;
      Expect ("pitch is first", Found.Uplink (Roll), 16#301#);
      Expect ("roll is second", Found.Uplink (Pitch), 16#300#);
      Expect ("yaw where it was", Found.Uplink (Yaw), 16#302#);
      Expect
        ("a place without an item", Found.Downlink (Right_Flap_2), 16#202#);
      Expect ("the next", Found.Downlink (Left_Flap_2), 16#403#);
      Expect_Errors
        ("a command's code among sensors", Errors, (1 => Unknown_Code),
         Detail => 16#101#);

      --  The codes are written again, and all words have their places.
      Up.Give (Uplink, Uplink_Of (16#500#));
      Framed.Give (Downlink, Framed_Of (16#600#));
      CORE_Under_Test.Run_Transaction;
      Found := Board.Contents;
      Expect
        ("up again", Found.Uplink = Uplink_Of (16#500#), True);
      Expect
        ("down again", Found.Downlink = Downlink_Of (16#600#),
         True);
      Expect_Errors ("its own codes again", Errors, None);
   end Places_By_Code;

   procedure Codes_Of_Nothing is
      --  Writes the code to a place of an area and expects a report. The place
      --  keeps its word, and its code is restored.
      procedure Expect_Kept
        (Code    : Word;
         Is_Up   : Boolean;
         At_Up   : Uplink_Item   := Brake;
         At_Down : Downlink_Item := Right_Aileron);

      procedure Expect_Kept
        (Code    : Word;
         Is_Up   : Boolean;
         At_Up   : Uplink_Item   := Brake;
         At_Down : Downlink_Item := Right_Aileron)
      is
         Before : constant URV.CORE_Memory.Memory := Board.Contents;
         Up_Codes   : Uplink_Code_List   := Uplink_Type_Codes;
         Down_Codes : Downlink_Code_List := Downlink_Type_Codes;
         Found      : URV.CORE_Memory.Memory;
      begin
         if Is_Up then
            Up_Codes (At_Up) := Code;
         else
            Down_Codes (At_Down) := Code;
         end if;
         Board.Write_Codes (Up_Codes, Down_Codes, Status_Type_Codes);
         Up.Give (Uplink, Uplink_Of (Code xor 16#3000#));
         Framed.Give (Downlink, Framed_Of (Code xor 16#5000#));
         CORE_Under_Test.Run_Transaction;
         Found := Board.Contents;
         Expect
           ("up, code" & Code'Image,
            Found.Uplink
            = (if Is_Up
               then (Uplink_Of (Code xor 16#3000#) with delta
                       At_Up => Before.Uplink (At_Up))
               else Uplink_Of (Code xor 16#3000#)),
            True);
         Expect
           ("down, code" & Code'Image,
            Found.Downlink
            = (if Is_Up then Downlink_Of (Code xor 16#5000#)
               else (Downlink_Of (Code xor 16#5000#) with delta
                       At_Down => Before.Downlink (At_Down))),
            True);
         Expect_Errors
           ("code" & Code'Image, Errors, (1 => Unknown_Code),
            Detail => Code);

         Up.Give (Uplink, Uplink_Of (16#500#));
         Framed.Give (Downlink, Framed_Of (16#600#));
         CORE_Under_Test.Run_Transaction;
         Expect_Errors ("its own codes again", Errors, None);
      end Expect_Kept;

   begin
      CORE_Under_Test.Initialise;
      Up.Give (Uplink, Uplink_Of (16#100#));
      Framed.Give (Downlink, Framed_Of (16#200#));
      CORE_Under_Test.Run_Transaction;

      --  Just below the codes of either kind, just above, and far away.
      for Code of Word_List'
        (Commands_Kind, Uplink_Code'Last + 1, No_Code, Word'Last)
      loop
         Expect_Kept (Code, Is_Up => True);
      end loop;
      for Code of Word_List'
        (Sensors_Kind, Downlink_Code'Last + 1, No_Code, Word'Last)
      loop
         Expect_Kept (Code, Is_Up => False);
      end loop;

      --  At the first place and at the last one.
      Expect_Kept (No_Code, Is_Up => True, At_Up => Uplink_Item'First);
      Expect_Kept (No_Code, Is_Up => True, At_Up => Uplink_Item'Last);
      Expect_Kept (No_Code, Is_Up => False, At_Down => Downlink_Item'First);
      Expect_Kept (No_Code, Is_Up => False, At_Down => Downlink_Item'Last);

      --  A channel has a code above the sensors'.
      declare
         Codes : constant Channel_Codes :=
           (Sensor_Codes with delta 2 => Sensor_Code'Last + 1);
      begin
         Expect_Number
           ("channel", Integer (First_Unknown_Sensor (Codes)), 3);
         Expect
           ("the others have theirs",
            (for all Item in Sensor_Item =>
               Sensors_Of (Image_Of (16#300#, Error => 0), Codes) (Item)
               = (if Channel_Of (Item) = 2 then Neutral_Downlink (Item)
                  else 16#300# + Word (Channel_Of (Item)))),
            True);
      end;

      --  A block without another kind is as before.
      Expect ("commands", Kind_Of (Uplink_Of (16#100#)), Commands_Kind);
      Expect ("sensors", Kind_Of (Downlink_Of (16#100#)), Sensors_Kind);
   end Codes_Of_Nothing;

   procedure Unknown_Up is
      Item : constant Uplink_Buffer :=
        (Uplink_Of (16#F000#) with delta
           Roll => 16#600#, Error_Status => Other_Kind);

      procedure Expect_Last (What : String);

      procedure Expect_Last (What : String) is
      begin
         Expect_Buffer
           (What & ", CORE", Up.Taken ("to CORE", MCS.Uplink_Variable),
            As_Old (Uplink_Of (16#100#)));
         Expect_Buffer
           (What & ", laws", Up.Taken ("to LAW", MCS.Commands_Variable),
            As_Old (Uplink_Of (16#100#)));
         Up.Expect_Counts
           (What & ", configuration", MCS.Configuration_Variable, 0, 0);
      end Expect_Last;

      Unused : Uplink_Buffer;
   begin
      Clear;
      Up.Give (MCS.TELIN_Variable, Uplink_Of (16#100#));
      MCS.MDCIN.Run_Transaction;
      Unused := Up.Taken ("commands", MCS.Uplink_Variable);
      Unused := Up.Taken ("commands", MCS.Commands_Variable);

      Up.Give (MCS.TELIN_Variable, Item);
      MCS.MDCIN.Run_Transaction;
      Expect_Last ("unknown");
      Expect_Errors
        ("unknown", MCS.Errors, (1 => Unknown_Code), Detail => 16#600#);

      --  A frame without a block passes it on as old; it is reported only
      --  once.
      Up.Give (MCS.TELIN_Variable, As_Old (Item));
      MCS.MDCIN.Run_Transaction;
      Expect_Last ("old");
      Expect_Errors ("old", MCS.Errors, None);

      --  The same if it claims to be commands.
      Up.Give
        (MCS.TELIN_Variable, (Item with delta Roll => Commands_Kind));
      MCS.MDCIN.Run_Transaction;
      Expect_Last ("commands of another kind");
      Expect_Errors
        ("commands of another kind", MCS.Errors, (1 => Unknown_Code),
         Detail => Commands_Kind);

      MCS.MDCIN.Run_Transaction;
      Expect_Last ("nothing new");
      Expect_Errors ("nothing new", MCS.Errors, (1 => No_Input));
   end Unknown_Up;

   procedure Unknown_Down is
      Item   : constant Downlink_Buffer :=
        (Downlink_Of (16#300#) with delta Error_Status => 16#0050#);
      Unused : Downlink_Buffer;
   begin
      Clear;
      Down.Give (GSC.TELIN_Variable, Downlink_Of (16#200#));
      GSC.GDCIN.Run_Transaction;
      Unused := Framed.Taken ("to CORE", GSC.Downlink_Variable).Words;

      Down.Give (GSC.TELIN_Variable, Item);
      GSC.GDCIN.Run_Transaction;
      Expect_Buffer
        ("the last", Framed.Taken ("to CORE", GSC.Downlink_Variable).Words,
         As_Old (Downlink_Of (16#200#)));
      Expect_Errors
        ("unknown", GSC.Errors, (1 => Unknown_Code), Detail => 16#500#);

      Down.Give (GSC.TELIN_Variable, As_Old (Item));
      GSC.GDCIN.Run_Transaction;
      Expect_Buffer
        ("still", Framed.Taken ("to CORE", GSC.Downlink_Variable).Words,
         As_Old (Downlink_Of (16#200#)));
      Expect_Errors ("told once", GSC.Errors, None);
   end Unknown_Down;

   procedure Ordered is
      Order   : constant Uplink_Buffer := Block_Of (Softly);
      Success : Boolean;
   begin
      Clear;
      GSC.Console_Orders.Send (Order, Success);
      for Frame in 1 .. 2 loop
         Stick_Images.Give (GSC.AD_Variable, Image_Of (16#300#, Error => 0));
         GSC.GDCOUT.Run_Transaction;
         Expect_Buffer
           ("CORE has the sticks", Up.Taken ("CORE", GSC.Uplink_Variable),
            Uplink_Of (16#300#));
         Expect_Buffer
           ("up it goes once", Up.Taken ("TELOUT", GSC.TELOUT_Variable),
            (if Frame = 1 then Order else Uplink_Of (16#300#)));
      end loop;

      --  A block that is not of another kind never replaces the commands.
      GSC.Console_Orders.Send (Uplink_Of (16#700#), Success);
      Stick_Images.Give (GSC.AD_Variable, Image_Of (16#300#, Error => 0));
      GSC.GDCOUT.Run_Transaction;
      Expect_Buffer
        ("the sticks", Up.Taken ("TELOUT", GSC.TELOUT_Variable),
         Uplink_Of (16#300#));
   end Ordered;

   procedure Delivered is
   begin
      Clear;
      Up.Give (MCS.TELIN_Variable, Block_Of (Softly));
      MCS.MDCIN.Run_Transaction;
      Expect_Buffer
        ("to the laws", Up.Taken ("it", MCS.Configuration_Variable),
         Block_Of (Softly));
      Expect_Buffer
        ("no commands", Up.Taken ("old", MCS.Commands_Variable),
         As_Old (Neutral_Uplink));
      Expect_Errors ("delivered", MCS.Errors, None);
   end Delivered;

   --  The settings in force, and the ground's report.
   procedure Expect_Set (What : String; Is_Set : Boolean);

   procedure Expect_Set (What : String; Is_Set : Boolean) is
      Now : constant Settings :=
        In_Force (MCS.Law_Settings.Contents, MCS.Law_Memory.Contents.Set);
      Status : constant URV.Law_Status.Report := URV.Law_Status.Report_Of
        (MCS.Law_Memory.Contents.Flown, 0,
         MCS.Law_Memory.Contents.Set);
   begin
      Expect_Number
        (What & ", table", Integer (Now.Table), (if Is_Set then 1 else 0));
      Expect_Number
        (What & ", orbit", Integer (Now.By.Orbit),
         (if Is_Set then 100 else 250));
      Expect_Number
        (What & ", end", Integer (Now.By.Terminate_At),
         (if Is_Set then 450 else 6_000));
      Expect
        (What & ", told", Status (URV.Law_Status.Configuration),
         (if Is_Set then 16#51# else 0));
   end Expect_Set;

   procedure Taken_On_The_Ground is
   begin
      Clear;
      Fly (100, Standing);
      Up.Give (MCS.Configuration_Variable, Block_Of (Softly));
      Fly (1, Standing);
      Expect_Set ("standing", True);
      Expect_Errors ("standing", MCS.Errors, None);

      --  In flight while all modes are direct.
      Clear;
      Fly (100, Level);
      Up.Give (MCS.Configuration_Variable, Block_Of (Softly));
      Fly (1, Level);
      Expect_Set ("direct", True);
      Expect_Errors ("direct", MCS.Errors, None);
   end Taken_On_The_Ground;

   procedure Refused_Otherwise is
      Held : constant Uplink_Buffer := (Sticks with delta Switch_2 => 16#FFF#);

      procedure Expect_Refused
        (What     : String;
         Block    : Uplink_Buffer;
         Why      : Answer;
         Commands : Uplink_Buffer := Sticks);

      procedure Expect_Refused
        (What     : String;
         Block    : Uplink_Buffer;
         Why      : Answer;
         Commands : Uplink_Buffer := Sticks) is
      begin
         Up.Give (MCS.Configuration_Variable, Block);
         Fly (1, Level, Commands);
         Expect_Set (What, False);
         Expect_Errors
           (What, MCS.Errors, (1 => Configuration_Refused),
            Detail => Answer'Pos (Why));
      end Expect_Refused;

      Spoilt   : Uplink_Buffer;
      Bad      : Configuration;
      Direct   : constant Uplink_Buffer := Sticks;
      Levelled : constant Uplink_Buffer :=
        (Sticks with delta Switch_4 => 16#FFF#);
      Steady   : constant Uplink_Buffer :=
        (Sticks with delta Switch_3 => 16#FFF#);
   begin
      Clear;
      Fly (100, Level, Direct);
      for Where in Command_Item loop
         for Bit of Word_List'(16#40#, 16#1000#) loop
            Spoilt := Block_Of (Softly);
            Spoilt (Where) := Spoilt (Where) xor Bit;
            Expect_Refused (Where'Image, Spoilt, Not_Whole);
         end loop;
      end loop;
      Expect_Refused
        ("of no other kind",
         (Block_Of (Softly) with delta Error_Status => No_Error), Not_Whole);

      for Which in Setting_Item loop
         Bad := Softly;
         Bad (Which) :=
           (if Which = Serial then 0
            elsif Which = End_From then Bad (Orbit_From)
            else Field'Last);
         Expect_Refused (Which'Image, Block_Of (Bad), Not_In_Range);
      end loop;
      Bad := (Softly with delta Orbit_From => 9);
      Expect_Refused ("too early", Block_Of (Bad), Not_In_Range);
      Bad := (Softly with delta Orbit_From => 10, End_From => 19);
      Expect_Refused ("too early an end", Block_Of (Bad), Not_In_Range);
      Bad := (Softly with delta End_From => 3_001);
      Expect_Refused ("too late", Block_Of (Bad), Not_In_Range);

      --  Only one law flies: bank by its switch; pitch and the lever lack
      --  their sensors.
      Fly (2, Level, Levelled);
      Expect_Refused
        ("bank alone", Block_Of (Softly), Law_Flies, Levelled);
      Clear;
      Fly (100, Level, Direct);
      Fly (3, (Level with delta Roll_Rate => 0), Held);
      MCS.Errors.Clear;
      Expect_Refused ("nose alone", Block_Of (Softly), Law_Flies, Held);
      Clear;
      Fly (100, Level, Direct);
      Fly (3, (Level with delta Roll_Rate | Roll_Attitude => 0), Steady);
      MCS.Errors.Clear;
      Expect_Refused ("lever alone", Block_Of (Softly), Law_Flies, Steady);
      Clear;
      Fly (100, Level, Direct);
      Fly (2, Level, Held);
      Expect_Refused ("a law flies", Block_Of (Softly), Law_Flies, Held);

      --  The stick's word is not yet the axis's own.
      Fly
        (1, Level,
         (Held with delta Roll => 4_000, Switch_2 => 0));
      Expect_Refused
        ("letting go", Block_Of (Softly), Law_Flies,
         (Held with delta Roll => 4_000, Switch_2 => 0));

      Clear;
      Up.Give (MCS.Configuration_Variable, Block_Of (Softly));
      Up.Give (MCS.Commands_Variable, Sticks);
      MCS.LAW.Run_Transaction;
      Expect_Set ("no laws", False);
      Expect_Errors
        ("no laws", MCS.Errors, (1 => Configuration_Refused),
         Detail => Answer'Pos (No_Laws));
   end Refused_Otherwise;

   procedure Starts is
   begin
      Taken_On_The_Ground;
      MCS.Restart_Variables;
      Expect_Set ("kept over a warm start", True);
      MCS.Reset_Variables;
      Expect_Set ("forgotten at a cold one", False);
   end Starts;

   procedure Softer is
      Banked : constant Downlink_Buffer :=
        (Level with delta Roll_Attitude => 2_120);
      Levelled : constant Uplink_Buffer :=
        (Sticks with delta Switch_2 => 16#FFF#);

      --  The roll output after some frames with a bank, sticks at rest.
      function Roll_With (Table : URV.Law_Gains.Table_Number) return Integer;

      function Roll_With (Table : URV.Law_Gains.Table_Number) return Integer
      is
         Item : URV.Laws.Memory := At_Start;
      begin
         for Frame in 1 .. 90 loop
            Item := Next
              (Item, Levelled, Banked, Laws_Off.By, Table);
         end loop;
         return Item.Last.Roll;
      end Roll_With;
   begin
      Expect ("against the bank", Roll_With (0) < -60, True);
      Expect ("less so", Roll_With (1) in Roll_With (0) * 9 / 10 .. -30,
              True);
   end Softer;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "EXT-2 a channel goes to the item of its type code",
         Channels_By_Code'Access);
      Add
        (Suite, "EXT-2 BUF-4 CORE has each word at its type code's place",
         Places_By_Code'Access);
      Add
        (Suite, "EXT-2 BUF-4 a code of no item moves no word of CORE",
         Codes_Of_Nothing'Access);
      Add
        (Suite, "EXT-2 D-26 an unknown block goes nowhere, MDCIN",
         Unknown_Up'Access);
      Add
        (Suite, "EXT-2 D-26 an unknown block goes nowhere, GDCIN",
         Unknown_Down'Access);
      Add
        (Suite, "EXT-2 D-26 an order is up in the place of a frame's commands",
         Ordered'Access);
      Add
        (Suite, "EXT-2 a configuration goes to the laws, not to the servos",
         Delivered'Access);
      Add
        (Suite, "EXT-2 a configuration is taken standing, or in direct",
         Taken_On_The_Ground'Access);
      Add
        (Suite, "EXT-2 a refused configuration changes nothing",
         Refused_Otherwise'Access);
      Add
        (Suite, "EXT-2 a cold start forgets the configuration",
         Starts'Access);
      Add
        (Suite, "EXT-2 the ground's table of gains flies", Softer'Access);
   end Add_To;

end Type_Codes_Tests;
