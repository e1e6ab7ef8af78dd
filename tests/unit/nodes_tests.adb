--  SPDX-License-Identifier: Apache-2.0

with Checks;            use Checks;
with Devices.PWM_Board; use Devices.PWM_Board;
with Expectations;      use Expectations;
with GSC.Virtual_Time;
with MCS.Virtual_Time;
with Node_Rig;          use Node_Rig;
with Telemetry;         use Telemetry;
with Telemetry.Boards;
with URVOS;             use URVOS;
with URVOS.Frames;      use URVOS.Frames;
with URVOS.Shared_Mailboxes;
with URVOS.Starts;
with URV.Buffers;       use URV.Buffers;
with URV.CORE_Layout;   use URV.CORE_Layout;
with URV.CORE_Memory;   use URV.CORE_Memory;
with URV.Errors;        use URV.Errors;
with URV.Laws;
with URV.Mailboxes;     use URV.Mailboxes;
with URV.Type_Codes;    use URV.Type_Codes;

package body Nodes_Tests is

   --  The tests, in order.
   procedure Data_Through;
   procedure Each_Frame;
   procedure Flaps_And_Discretes;
   procedure Too_Large;
   procedure Cut_Link;
   procedure Dead_Converter;
   procedure Cold_Start;
   procedure New_Variables;
   procedure Misses_Are_Told;
   procedure Controller_Alone;
   procedure First_Frames;
   procedure Type_Codes;
   procedure Logged_Flight;
   procedure Logged_Range;

   procedure Data_Through is
   begin
      Switch_On;
      Console := Numbered (16#100#);
      Sensors := Numbered (16#500#);
      Fly (6);
      Expect_Commands ("flight", 16#100#, No_Error);
      Expect_Sensors ("flight", 16#500#, No_Error);

      --  Figure 13, by channel of the board
      Expect ("left aileron", Servos (1), 16#100#);
      Expect ("right aileron", Servos (2), 16#100#);
      Expect ("left elevator", Servos (3), 16#101#);
      Expect ("right elevator", Servos (4), 16#101#);
      Expect ("left rudder", Servos (5), 16#102#);
      Expect ("right rudder", Servos (6), 16#102#);
      Expect ("steering", Servos (7), 16#102#);
      Expect ("throttle", Servos (8), 16#103#);
      Expect ("brake", Servos (9), 16#104#);
      for Flap in Channel_Number range 10 .. 13 loop
         Expect ("flap, channel" & Flap'Image, Servos (Flap), 16#800#);
      end loop;
      Expect ("discretes", Servos (14), 0);
      Expect ("unused channel", Servos (15), 16#800#);
      Expect ("unused channel", Servos (16), 16#800#);
      Expect ("overruns of GSC", GSC.Virtual_Time.Overruns, 0);
      Expect ("overruns of MCS", MCS.Virtual_Time.Overruns, 0);
   end Data_Through;

   procedure Each_Frame is
      Tally : Telemetry.Boards.Statistics;
   begin
      Switch_On;
      Fly (4);
      for Number in Word range 1 .. 200 loop
         Console := Numbered (Number);
         Sensors := Numbered (16#400# + Number);
         Fly (1);
      end loop;
      Tally := GSC.Telemetry_Board.Tally;
      Expect ("bad blocks down", Tally.Bad, 0);
      Expect ("resets of the ground", Tally.Resets, 0);
      Expect
        ("all frames but the first ones down", Tally.Received > 200, True);
      Tally := MCS.Telemetry_Board.Tally;
      Expect ("bad blocks up", Tally.Bad, 0);
      Expect ("resets of the aircraft", Tally.Resets, 0);
      Expect ("all frames but the first ones up", Tally.Received > 200, True);
      Fly (6);
      Expect_Commands ("the last frame", 200, No_Error);
      Expect_Sensors ("the last frame", 16#400# + 200, No_Error);
   end Each_Frame;

   procedure Flaps_And_Discretes is
   begin
      Switch_On;
      Console (5)  := 16#FFF#;
      Console (12) := 16#FFF#;
      Fly (6);
      for Flap in Channel_Number range 10 .. 13 loop
         Expect ("flap, channel" & Flap'Image, Servos (Flap), 16#FFF#);
      end loop;
      Expect ("switches 1 and 8", Servos (14), 16#81#);
   end Flaps_And_Discretes;

   procedure Too_Large is
   begin
      Switch_On;
      Console (3) := 16#8123#;
      Sensors (9) := 16#FFFF#;
      Fly (6);
      Expect
        ("throttle in GSC CORE", CORE_Of_GSC.Uplink (Throttle), 16#8123#);
      Expect
        ("throttle in MCS CORE", CORE_Of_MCS.Uplink (Throttle), 16#8123#);
      Expect ("throttle servo", Servos (8), 16#FFF#);
      Expect
        ("left rudder in MCS CORE", CORE_Of_MCS.Downlink (Left_Rudder),
         16#FFFF#);
      Expect
        ("left rudder in GSC CORE", CORE_Of_GSC.Downlink (Left_Rudder),
         16#FFF#);
   end Too_Large;

   procedure Cut_Link is
      Seen : Data_Area;
   begin
      Switch_On;
      Console := Numbered (16#100#);
      Sensors := Numbered (16#500#);
      Fly (6);
      Link_Is_Cut := True;
      Console := Numbered (16#200#);
      Sensors := Numbered (16#600#);
      Seen    := Servos;
      Fly (50);
      for Number in Seen'Range loop
         Expect
           ("servo" & Number'Image & " held", Servos (Number), Seen (Number));
      end loop;
      Expect ("commands in MCS CORE held", CORE_Of_MCS.Uplink (Roll), 16#100#);
      Expect
        ("sensors in GSC CORE held", CORE_Of_GSC.Downlink (Right_Flap_1),
         16#500#);
      Expect
        ("commands in GSC CORE are new", CORE_Of_GSC.Uplink (Roll), 16#200#);
      Expect
        ("sensors in MCS CORE are new", CORE_Of_MCS.Downlink (Right_Flap_1),
         16#600#);

      Link_Is_Cut := False;
      Fly (8);
      Expect_Commands ("after the cut", 16#200#, No_Error);
      Expect_Sensors ("after the cut", 16#600#, No_Error);
   end Cut_Link;

   procedure Dead_Converter is
   begin
      Switch_On;
      Sensors := Numbered (16#500#);
      Fly (6);
      MCS_Stalls := True;
      Sensors    := Numbered (16#600#);
      Fly (6);
      Expect_Sensors ("stalled", 16#500#, Stale_Data);

      MCS_Stalls := False;
      Fly (6);
      Expect_Sensors ("again", 16#600#, No_Error);
   end Dead_Converter;

   procedure Cold_Start is
      Before, After : Memory;
   begin
      --  A flight first, so that there is state to clear.
      Switch_On;
      Console := Numbered (16#100#);
      Sensors := Numbered (16#500#);
      Fly (6);
      Before := CORE_Of_MCS;
      Expect ("commands before", Before.Uplink (Roll), 16#100#);

      Switch_On;
      for Number in Channel_Number loop
         Expect
           ("servo" & Number'Image, Servos (Number), Safe_Words (Number));
      end loop;
      for Ground in Boolean loop
         After := (if Ground then CORE_Of_GSC else CORE_Of_MCS);
         for Item in Uplink_Item loop
            Expect
              ("CORE uplink " & Item'Image, After.Uplink (Item),
               No_Uplink (Item));
            Expect ("CORE code " & Item'Image, After.Uplink_Codes (Item), 0);
         end loop;
         for Item in Downlink_Item loop
            Expect
              ("CORE downlink " & Item'Image, After.Downlink (Item),
               No_Downlink (Item));
            Expect ("CORE code " & Item'Image, After.Downlink_Codes (Item), 0);
         end loop;
      end loop;
   end Cold_Start;

   procedure New_Variables is

      --  Expects nothing produced, consumed or missed.
      generic
         with package Messages is new URVOS.Shared_Mailboxes (<>);
      procedure Expect_New (What : String; Variable : Messages.Variable);

      procedure Expect_New (What : String; Variable : Messages.Variable) is
         Box : constant Messages.Boxes.Mailbox := Variable.Snapshot;
      begin
         Expect
           (What & ", produced", Count (Messages.Boxes.Produced (Box)), 0);
         Expect
           (What & ", consumed", Count (Messages.Boxes.Consumed (Box)), 0);
         Expect (What & ", misses", Messages.Boxes.Misses (Box), 0);
      end Expect_New;

      procedure Expect is new Expect_New (For_Stick_Words);
      procedure Expect is new Expect_New (For_Stick_Images);
      procedure Expect is new Expect_New (For_Sensor_Words);
      procedure Expect is new Expect_New (For_Sensor_Images);
      procedure Expect is new Expect_New (For_Uplink);
      procedure Expect is new Expect_New (For_Downlink);
      procedure Expect is new Expect_New (For_Framed_Downlink);

   begin
      Switch_On;

      --  Stops between tasks, so that the variables hold new messages.
      Fly (6);
      for Ticks in 1 .. 5 loop
         Clock_Tick_Of_Both;
      end loop;
      Switch_On;
      Expect ("MCS ADINT_variable", MCS.ADINT_Variable);
      Expect ("MCS AD_variable", MCS.AD_Variable);
      Expect ("MCS TELIN_variable", MCS.TELIN_Variable);
      Expect ("MCS uplink_variable", MCS.Uplink_Variable);
      Expect ("MCS downlink_variable", MCS.Downlink_Variable);
      Expect ("MCS TELOUT_variable", MCS.TELOUT_Variable);
      Expect ("MCS commands_variable", MCS.Commands_Variable);
      Expect ("MCS sensors_variable", MCS.Sensors_Variable);
      Expect ("MCS PWM_variable", MCS.PWM_Variable);
      Expect ("GSC ADINT_variable", GSC.ADINT_Variable);
      Expect ("GSC AD_variable", GSC.AD_Variable);
      Expect ("GSC TELIN_variable", GSC.TELIN_Variable);
      Expect ("GSC uplink_variable", GSC.Uplink_Variable);
      Expect ("GSC downlink_variable", GSC.Downlink_Variable);
      Expect ("GSC TELOUT_variable", GSC.TELOUT_Variable);
   end New_Variables;

   procedure Misses_Are_Told is

      generic
         with package Messages is new URVOS.Shared_Mailboxes (<>);
      function Misses_Of (Variable : Messages.Variable) return Count;

      function Misses_Of (Variable : Messages.Variable) return Count is
        (Messages.Boxes.Misses (Variable.Snapshot));

      function Misses is new Misses_Of (For_Stick_Words);
      function Misses is new Misses_Of (For_Stick_Images);
      function Misses is new Misses_Of (For_Sensor_Words);
      function Misses is new Misses_Of (For_Sensor_Images);
      function Misses is new Misses_Of (For_Uplink);
      function Misses is new Misses_Of (For_Downlink);
      function Misses is new Misses_Of (For_Framed_Downlink);

      --  Expects the log's count of a kind, at least one.
      procedure Expect_Told
        (Node : Station; Kind : Error_Kind; Missed : Count);

      procedure Expect_Told
        (Node : Station; Kind : Error_Kind; Missed : Count)
      is
         What : constant String := Node'Image & " " & Kind'Image;
      begin
         Expect
           (What, Logs.History_Of (Log_Of (Node), Kind).Occurrences, Missed);
         Expect (What & " happened", Missed > 0, True);
      end Expect_Told;

   begin
      for Laws_On in Boolean loop
         MCS.Law_Settings.Write ((On => Laws_On, others => <>));
         Switch_On;
         Fly (6);

         --  The same with the consumer of each variable before its producer;
         --  twice if the producer may have run before.
         MCS.CORE.Run_Transaction;
         MCS.TELOUT.Run_Transaction;
         MCS.PWM.Run_Transaction;
         MCS.LAW.Run_Transaction;
         MCS.MDCOUT.Run_Transaction (Now => 0);
         MCS.MDCIN.Run_Transaction;
         MCS.AD.Run_Transaction (0);
         MCS.AD.Run_Transaction (0);
         GSC.CORE.Run_Transaction;
         GSC.TELOUT.Run_Transaction;
         GSC.GDCOUT.Run_Transaction;
         GSC.GDCOUT.Run_Transaction;
         GSC.GDCIN.Run_Transaction;
         GSC.AD.Run_Transaction (0);
         GSC.AD.Run_Transaction (0);

         Expect_Told (Aircraft, AD_No_Scan, Misses (MCS.ADINT_Variable));
         Expect_Told (Aircraft, No_Input, Misses (MCS.TELIN_Variable));
         Expect_Told
           (Aircraft, No_Image,
            Misses (MCS.AD_Variable)
            + (if Laws_On then Misses (MCS.Sensors_Variable) else 0));
         Expect_Told
           (Aircraft, No_Commands,
            Misses (MCS.PWM_Variable)
            + (if Laws_On then Misses (MCS.Commands_Variable) else 0));
         Expect_Told (Aircraft, No_Output, Misses (MCS.TELOUT_Variable));
         Expect_Told
           (Aircraft, CORE_No_Uplink, Misses (MCS.Uplink_Variable));
         Expect_Told
           (Aircraft, CORE_No_Downlink, Misses (MCS.Downlink_Variable));
         Expect_Told (Ground, AD_No_Scan, Misses (GSC.ADINT_Variable));
         Expect_Told (Ground, No_Input, Misses (GSC.TELIN_Variable));
         Expect_Told (Ground, No_Image, Misses (GSC.AD_Variable));
         Expect_Told (Ground, No_Output, Misses (GSC.TELOUT_Variable));
         Expect_Told (Ground, CORE_No_Uplink, Misses (GSC.Uplink_Variable));
         Expect_Told
           (Ground, CORE_No_Downlink, Misses (GSC.Downlink_Variable));
      end loop;
      MCS.Law_Settings.Write (URV.Laws.Laws_Off);
   end Misses_Are_Told;

   procedure Controller_Alone is
   begin
      --  Only the controllers restart: their boards have received messages
      --  before, but none now.
      Data_Through;
      Link_Is_Cut := True;
      Fly (4);
      Now := 0;
      MCS.Virtual_Time.Start (URVOS.Starts.Cold_Start, 0);
      GSC.Virtual_Time.Start (URVOS.Starts.Cold_Start, 0);
      Fly (4);
      for Item in Uplink_Item loop
         Expect
           ("MCS CORE " & Item'Image, CORE_Of_MCS.Uplink (Item),
            Neutral_Uplink (Item));
      end loop;
      for Item in Downlink_Item loop
         Expect
           ("GSC CORE " & Item'Image, CORE_Of_GSC.Downlink (Item),
            Neutral_Downlink (Item));
      end loop;
   end Controller_Alone;

   procedure First_Frames is
      CORE : Memory;
   begin
      --  The aircraft receives nothing: the words in its CORE and at its
      --  servos are neutral and marked stale, whatever they were before.
      Data_Through;
      Switch_On;
      Link_Is_Cut := True;
      Fly (4);
      CORE := CORE_Of_MCS;
      for Item in Uplink_Item loop
         Expect
           ("MCS CORE " & Item'Image, CORE.Uplink (Item),
            Neutral_Uplink (Item));
      end loop;
      for Servo in Channel_Number loop
         Expect
           ("servo" & Servo'Image, Servos (Servo), Safe_Words (Servo));
      end loop;
      CORE := CORE_Of_GSC;
      for Item in Downlink_Item loop
         Expect
           ("GSC CORE " & Item'Image, CORE.Downlink (Item),
            Neutral_Downlink (Item));
      end loop;
   end First_Frames;

   procedure Type_Codes is
   begin
      Switch_On;
      Fly (2);
      for Item in Uplink_Item loop
         Expect
           ("MCS code of " & Item'Image,
            CORE_Of_MCS.Uplink_Codes (Item), Code_Of (Item));
         Expect
           ("GSC code of " & Item'Image,
            CORE_Of_GSC.Uplink_Codes (Item), Code_Of (Item));
      end loop;
      for Item in Downlink_Item loop
         Expect
           ("MCS code of " & Item'Image,
            CORE_Of_MCS.Downlink_Codes (Item), Code_Of (Item));
         Expect
           ("GSC code of " & Item'Image,
            CORE_Of_GSC.Downlink_Codes (Item), Code_Of (Item));
      end loop;
      for Item in Status_Item loop
         Expect
           ("MCS code of " & Item'Image,
            CORE_Of_MCS.Status_Codes (Item), Type_Code (Item));
         Expect
           ("GSC code of " & Item'Image,
            CORE_Of_GSC.Status_Codes (Item), Type_Code (Item));
      end loop;
   end Type_Codes;

   procedure Logged_Flight is
      Log    : Error_Log;
      Before : Count;
   begin
      Switch_On;
      Fly (6);
      Log := Log_Of (Telemetry.Aircraft);
      Before := Logs.Total (Log);
      Expect
        ("no resets before",
         Logs.History_Of (Log, Link_Reset).Occurrences, 0);

      --  The cut begins with frame 6 of the ground, before its data. It
      --  interrupts nothing, since answers come at once.
      for Number in 1 .. Ticks_Per_Major_Frame loop
         exit when Silence > 2;
         Clock_Tick_Of_Both;
      end loop;
      Link_Is_Cut := True;
      Fly (4);
      Log := Log_Of (Telemetry.Aircraft);
      Expect
        ("frames without a block",
         Logs.History_Of (Log, TELIN_No_Block).Occurrences, 3);
      Expect
        ("the last of them",
         Logs.History_Of (Log, TELIN_No_Block).Last, 90);
      Expect
        ("the ground's silence is no error of the aircraft's link",
         Logs.History_Of (Log, Link_Reset).Occurrences, 0);
      Expect
        ("total in CORE", Count (CORE_Of_MCS.Status (Error_Total_Low)),
         Logs.Total (Log));
      Expect ("more than before", Logs.Total (Log) > Before, True);

      Log := Log_Of (Telemetry.Ground);
      Expect
        ("the ground has reset",
         Logs.History_Of (Log, Link_Reset).Occurrences > 0, True);
      Expect
        ("and scrapped",
         Logs.History_Of (Log, Link_Block_Scrapped).Occurrences > 0, True);

      Switch_On;
      Log := Log_Of (Telemetry.Ground);
      Expect ("after a cold start", Logs.Total (Log), 0);
      Fly (6);
      Log := Log_Of (Telemetry.Ground);
      Expect
        ("what the board had counted is forgotten",
         Logs.History_Of (Log, Link_Reset).Occurrences, 0);
   end Logged_Flight;

   procedure Logged_Range is
   begin
      Switch_On;
      Console (3) := 16#8123#;
      Fly (6);
      Expect
        ("throttle is word 4",
         Logs.History_Of
           (Log_Of (Telemetry.Aircraft), Input_Out_Of_Range).Last_Detail,
         4);
      Sensors (9) := 16#FFFF#;
      Fly (6);
      Expect
        ("left rudder has code 020Ah",
         Logs.History_Of
           (Log_Of (Telemetry.Aircraft), Input_Out_Of_Range).Last_Detail,
         16#20A#);
      Expect
        ("in CORE", CORE_Of_MCS.Status (Last_Error),
         Error_Kind'Pos (Input_Out_Of_Range) + 1);
   end Logged_Range;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "SET-2 sticks reach CORE twice and the servos, sensors CORE",
         Data_Through'Access);
      Add
        (Suite, "SET-2 each frame's words go all the way, 200 times",
         Each_Frame'Access);
      Add
        (Suite, "SET-2 switches reach flaps and discretes",
         Flaps_And_Discretes'Access);
      Add
        (Suite, "D-11 a word above 0FFFh is limited at servos, and down",
         Too_Large'Access);
      Add
        (Suite, "LNK-9 a cut link holds the last words, and recovers",
         Cut_Link'Access);
      Add
        (Suite, "AD-1 a dead converter is told to the ground as stale",
         Dead_Converter'Access);
      Add
        (Suite, "INI-3 INI-6 a cold start forgets the flight before",
         Cold_Start'Access);
      Add
        (Suite, "INI-8 until something is heard all data is neutral, stale",
         First_Frames'Access);
      Add
        (Suite, "INI-8 a cold start leaves every variable as new",
         New_Variables'Access);
      Add
        (Suite, "MBX-3 each miss that a variable counts is reported",
         Misses_Are_Told'Access);
      Add
        (Suite, "INI-8 a cold start forgets the message before, too",
         Controller_Alone'Access);
      Add
        (Suite, "INI-7 the type codes are there after the first frame",
         Type_Codes'Access);
      Add
        (Suite, "EXT-1 a cut link is logged on both nodes, until a cold start",
         Logged_Flight'Access);
      Add
        (Suite, "EXT-1 D-11 a word out of range is logged with its place",
         Logged_Range'Access);
   end Add_To;

end Nodes_Tests;
