--  SPDX-License-Identifier: Apache-2.0

with Checks;         use Checks;
with Expectations;   use Expectations;
with GSC;
with MCS;
with Task_Rig;       use Task_Rig;
with URVOS;          use URVOS;
with URVOS.Frames;   use URVOS.Frames;
with URVOS.Task_Trees;
with URV.Buffers;    use URV.Buffers;
with URV.Errors;     use URV.Errors;
with URV.Laws;
with URV.Log_Pieces; use URV.Log_Pieces;
with URV.PWM_Layout;
with URV.Routing;    use URV.Routing;
with URV.Spare_Bits; use URV.Spare_Bits;

separate (Task_Suite)
package body Exchange_Tests is

   --  The tests, in order.
   procedure Aircraft_In;
   procedure Aircraft_In_Old;
   procedure Aircraft_In_Unread;
   procedure Aircraft_In_Too_Large;
   procedure Aircraft_Out;
   procedure Aircraft_Out_Old;
   procedure Aircraft_Out_Frame;
   procedure Aircraft_Out_Too_Large;
   procedure Ground_In;
   procedure Ground_In_Frame;
   procedure Ground_In_Too_Large;
   procedure Ground_Out;

   --  Both nodes' variables, logs and status are new; no fragment of a log is
   --  under way.
   procedure Clear;

   --  The outputs of the aircraft's tasks
   procedure Expect_Commands_Sent (What : String; Expected : Uplink_Buffer);

   procedure Clear is
   begin
      MCS.Reset_Variables;
      MCS.Law_Settings.Write (URV.Laws.Laws_Off);
      MCS.Errors.Clear;
      MCS.Status.Write (No_Error);
      MCS.Log_Sender.Progress.Write ((others => <>));
      GSC.Reset_Variables;
      GSC.Errors.Clear;
      GSC.Status.Write (No_Error);
      GSC.Log_Receiver.Incoming.Write ((others => <>));
   end Clear;

   procedure Expect_Commands_Sent (What : String; Expected : Uplink_Buffer)
   is
   begin
      Expect_Buffer
        (What & ", to CORE", Up.Taken ("to CORE", MCS.Uplink_Variable),
         Expected);
      Expect_Buffer
        (What & ", to PWM", Up.Taken ("to PWM", MCS.Commands_Variable),
         Expected);
   end Expect_Commands_Sent;

   procedure Aircraft_In is
   begin
      Clear;
      Up.Give (MCS.TELIN_Variable, Uplink_Of (16#100#));
      MCS.MDCIN.Run_Transaction;
      Up.Expect_Counts ("received", MCS.TELIN_Variable, 1, 1);
      Up.Expect_Counts ("sent to CORE", MCS.Uplink_Variable, 1, 0);
      Up.Expect_Counts ("sent to PWM", MCS.Commands_Variable, 1, 0);
      Expect_Commands_Sent ("fresh input", Uplink_Of (16#100#));
      Expect_Errors ("fresh input", MCS.Errors, None);
   end Aircraft_In;

   procedure Aircraft_In_Old is
   begin
      Aircraft_In;
      MCS.MDCIN.Run_Transaction;
      Up.Expect_Counts ("received", MCS.TELIN_Variable, 1, 1, Misses => 1);
      Up.Expect_Counts ("sent to CORE", MCS.Uplink_Variable, 2, 1);
      Up.Expect_Counts ("sent to PWM", MCS.Commands_Variable, 2, 1);
      Expect_Commands_Sent ("old input", As_Old (Uplink_Of (16#100#)));
      Expect_Errors ("old input", MCS.Errors, (1 => No_Input));
   end Aircraft_In_Old;

   procedure Aircraft_In_Unread is
   begin
      Clear;
      Up.Give (MCS.Uplink_Variable, Uplink_Of (16#100#));
      Up.Give (MCS.TELIN_Variable, Uplink_Of (16#200#));
      MCS.MDCIN.Run_Transaction;
      Expect_Commands_Sent
        ("sent to both all the same", Uplink_Of (16#200#));
      Expect_Errors
        ("CORE did not take", MCS.Errors, (1 => Uplink_Not_Consumed));

      Up.Give (MCS.Commands_Variable, Uplink_Of (16#200#));
      Up.Give (MCS.TELIN_Variable, Uplink_Of (16#300#));
      MCS.MDCIN.Run_Transaction;
      Expect_Commands_Sent ("the newest to both", Uplink_Of (16#300#));
      Expect_Errors
        ("PWM did not take", MCS.Errors, (1 => Commands_Not_Consumed));
   end Aircraft_In_Unread;

   procedure Aircraft_In_Too_Large is
      Item : Uplink_Buffer;
   begin
      for Which in Command_Item loop
         Clear;
         Item := Uplink_Of (16#100#);
         Item (Which) := 16#1000#;
         Up.Give (MCS.TELIN_Variable, Item);
         MCS.MDCIN.Run_Transaction;
         Expect_Commands_Sent ("as they came", Item);
         Expect_Errors
           (Which'Image, MCS.Errors, (1 => Input_Out_Of_Range),
            Detail => Command_Item'Pos (Which) + 1);
      end loop;

      --  The error word may hold any value.
      Clear;
      Item := Uplink_Of (16#100#);
      Item (Error_Status) := 16#FFFF#;
      Up.Give (MCS.TELIN_Variable, Item);
      MCS.MDCIN.Run_Transaction;
      Expect_Errors ("error word", MCS.Errors, None);
   end Aircraft_In_Too_Large;

   procedure Aircraft_Out is
      To_CORE : Downlink_Buffer;
   begin
      Clear;
      Images.Give (MCS.AD_Variable, Image_Of (16#100#, Error => 16#7#));
      MCS.MDCOUT.Run_Transaction (Now => 0);
      Images.Expect_Counts ("received", MCS.AD_Variable, 1, 1);
      Framed.Expect_Counts ("sent to CORE", MCS.Downlink_Variable, 1, 0);
      Down.Expect_Counts ("sent to TELOUT", MCS.TELOUT_Variable, 1, 0);
      To_CORE := Framed.Taken ("to CORE", MCS.Downlink_Variable).Words;
      for Item in Sensor_Item loop
         Expect (Item'Image, To_CORE (Item), Downlink_Of (16#100#) (Item));
      end loop;
      Expect ("error word", To_CORE (Error_Status), 16#7#);
      Expect_Buffer
        ("to TELOUT",
         Sensors_In (Down.Taken ("to TELOUT", MCS.TELOUT_Variable)),
         To_CORE);
      Expect_Errors ("fresh image", MCS.Errors, None);

      MCS.Status.Write (16#8#);
      Images.Give (MCS.AD_Variable, Image_Of (16#100#, Error => 16#7#));
      MCS.MDCOUT.Run_Transaction (Now => 0);
      Expect
        ("with the node's own",
         Framed.Taken ("to CORE", MCS.Downlink_Variable).Words
           (Error_Status),
         16#F#);
      Expect
        ("down, too",
         Down.Taken ("to TELOUT", MCS.TELOUT_Variable) (Error_Status),
         16#F#);

      --  The log's fragments are sent to the ground but not to CORE: the
      --  number of the row, then its words.
      MCS.Errors.Report (No_Input, 0);
      for Piece in Word range 1 .. 2 loop
         Images.Give (MCS.AD_Variable, Image_Of (16#100#, Error => 16#7#));
         MCS.MDCOUT.Run_Transaction (Now => 0);
         Expect
           ("CORE has no piece",
            Framed.Taken ("to CORE", MCS.Downlink_Variable).Words
              (Error_Status),
            16#F#);
         Expect
           ("down it goes",
            Down.Taken ("to TELOUT", MCS.TELOUT_Variable) (Error_Status),
            (if Piece = 1 then 16#107F# else 16#200F#));
      end loop;
   end Aircraft_Out;

   procedure Aircraft_Out_Old is
      To_CORE, To_Ground : Downlink_Buffer;
   begin
      Clear;
      Images.Give (MCS.AD_Variable, Image_Of (16#100#, Error => 0));
      MCS.MDCOUT.Run_Transaction (Now => 0);
      To_CORE := Framed.Taken ("to CORE", MCS.Downlink_Variable).Words;
      To_Ground :=
        Sensors_In (Down.Taken ("to TELOUT", MCS.TELOUT_Variable));
      Expect ("no mark", To_CORE (Error_Status), No_Error);
      Expect ("no mark, down", To_Ground (Error_Status), No_Error);
      Expect_Errors ("fresh image", MCS.Errors, None);

      MCS.MDCOUT.Run_Transaction (Now => 0);
      To_CORE := Framed.Taken ("to CORE", MCS.Downlink_Variable).Words;
      To_Ground :=
        Sensors_In (Down.Taken ("to TELOUT", MCS.TELOUT_Variable));
      Expect ("to CORE", To_CORE (Altitude), 16#119#);
      Expect ("to TELOUT", To_Ground (Altitude), 16#119#);
      Expect ("the mark", To_CORE (Error_Status), Stale_Data);

      --  The error itself is sent as a fragment of the log.
      Expect
        ("the mark, down", Without_Piece (To_Ground (Error_Status)),
         Stale_Data);
      Expect_Errors ("old image", MCS.Errors, (1 => No_Image));

      for Time in 1 .. 2 loop
         Images.Give (MCS.AD_Variable, Image_Of (16#100#, Error => 0));
         MCS.MDCOUT.Run_Transaction (Now => 0);
         Expect_Errors
           ("nobody took", MCS.Errors,
            (if Time = 1 then None
             else (Downlink_Not_Consumed, Output_Not_Consumed)));
      end loop;
   end Aircraft_Out_Old;

   procedure Aircraft_Out_Frame is
      Servos : constant PWM_Buffer :=
        (Safe_Outputs with delta
           Left_Aileron   => 16#A12#,
           Right_Aileron  => 16#B34#,
           Left_Elevator  => 16#C56#,
           Right_Elevator => 16#D78#,
           Left_Rudder    => 16#E9A#,
           Right_Rudder   => 16#FBC#,
           Throttle       => 16#123#);

      --  Expects the frame of a downlink at this time, in CORE and on the
      --  link.
      procedure Expect_Frame
        (What     : String;
         Set      : URVOS.Task_Trees.Schedule_Name;
         Now      : Clock_Tick;
         Expected : Frame_Words);

      procedure Expect_Frame
        (What     : String;
         Set      : URVOS.Task_Trees.Schedule_Name;
         Now      : Clock_Tick;
         Expected : Frame_Words)
      is
         In_CORE : Framed_Downlink;
         On_Link : Downlink_Buffer;
      begin
         MCS.Schedule.Write (Set);
         Images.Give (MCS.AD_Variable, Image_Of (16#100#, Error => 0));
         MCS.MDCOUT.Run_Transaction (Now);
         In_CORE := Framed.Taken ("to CORE", MCS.Downlink_Variable);
         On_Link := Down.Taken ("to TELOUT", MCS.TELOUT_Variable);
         for Item in Frame_Item loop
            Expect
              (What & ", CORE's " & Item'Image, In_CORE.Frame (Item),
               Expected (Item));
            Expect
              (What & ", the link's " & Item'Image,
               Frame_In (On_Link) (Item), Expected (Item));
         end loop;
      end Expect_Frame;

      Expected : Frame_Words :=
        (Frame_Number   => 0,
         Running_Card   => 0,
         Card_Phase     => 0,
         Left_Aileron   => 16#A12#,
         Right_Aileron  => 16#B34#,
         Left_Elevator  => 16#C56#,
         Right_Elevator => 16#D78#,
         Left_Rudder    => 16#E9A#,
         Right_Rudder   => 16#FBC#,
         Throttle       => 16#123#);

      use URVOS.Task_Trees;
   begin
      Clear;
      MCS.PWM_Board.Write (URV.PWM_Layout.To_Data_Area (Servos));
      Expect_Frame ("the first, fast", Fast, 1, Expected);

      --  The report's schedule hands on the scan of the frame before.
      Expected (Frame_Number) := 4_095;
      Expect_Frame ("the first", Report, 1, Expected);
      Expected (Frame_Number) := 4_094;
      Expect_Frame ("the last number", Report, 40_951, Expected);
      Expected (Frame_Number) := 16#ABC#;
      MCS.Card_Shown.Write (8 * 16 + 13);
      Expected (Running_Card) := 8;
      Expected (Card_Phase) := 13;
      Expect_Frame
        ("much later, fast", Fast, 10 * (4_096 * 1_000_000 + 16#ABC#) + 3,
         Expected);
      MCS.Schedule.Write (Report);
      MCS.Card_Shown.Write (0);
   end Aircraft_Out_Frame;

   procedure Aircraft_Out_Too_Large is
      Image : AD_Image;
   begin
      for Which in Sensor_Item loop
         Clear;
         Image := Image_Of (16#100#, Error => 0);
         Image.Words (Channel_Of (Which)) := 16#5678#;
         Images.Give (MCS.AD_Variable, Image);
         MCS.MDCOUT.Run_Transaction (Now => 0);
         Expect
           ("as it came, to CORE",
            Framed.Taken ("to CORE", MCS.Downlink_Variable).Words (Which),
            16#5678#);
         Expect
           ("limited, to the ground",
            Sensors_In (Down.Taken ("down", MCS.TELOUT_Variable)) (Which),
            16#FFF#);
         Expect_Errors
           (Which'Image, MCS.Errors, (1 => Input_Out_Of_Range),
            Detail => 16#201# + Sensor_Item'Pos (Which));
      end loop;
   end Aircraft_Out_Too_Large;

   procedure Ground_In_Frame is
      Frame : Frame_Words := (others => 0);
      Found : Framed_Downlink;
   begin
      Clear;
      for Item in Frame_Item loop
         Frame (Item) := 10 + Frame_Item'Pos (Item);
      end loop;
      Frame (Frame_Number) := 16#FED#;
      Frame (Running_Card) := 7;
      Down.Give (GSC.TELIN_Variable, Packed (Downlink_Of (16#300#), Frame));
      GSC.GDCIN.Run_Transaction;
      Found := Framed.Taken ("to CORE", GSC.Downlink_Variable);
      Expect_Buffer ("sensors", Found.Words, Downlink_Of (16#300#));
      for Item in Frame_Item loop
         Expect (Item'Image, Found.Frame (Item), Frame (Item));
      end loop;
      Expect_Errors ("spare bits are no error", GSC.Errors, None);

      --  Without a new block CORE has the last one's words, marked as old,
      --  with their frame.
      GSC.GDCIN.Run_Transaction;
      Found := Framed.Taken ("again", GSC.Downlink_Variable);
      Expect_Buffer
        ("old sensors", Found.Words, As_Old (Downlink_Of (16#300#)));
      Expect ("their number", Found.Frame (Frame_Number), 16#FED#);
      Expect_Errors ("nothing new", GSC.Errors, (1 => No_Input));

      --  A block of an older aircraft.
      Down.Give (GSC.TELIN_Variable, Downlink_Of (16#400#));
      GSC.GDCIN.Run_Transaction;
      Found := Framed.Taken ("an older one", GSC.Downlink_Variable);
      Expect_Buffer ("its sensors", Found.Words, Downlink_Of (16#400#));
      for Item in Frame_Item loop
         Expect ("no " & Item'Image, Found.Frame (Item), Unknown_Word);
      end loop;
   end Ground_In_Frame;

   procedure Ground_In is
      Item : Downlink_Buffer := Downlink_Of (16#200#);

      --  Receives a message with this error/status word, and expects it in
      --  CORE with these flags.
      procedure Receive (Error : Word; Flags : Word);

      procedure Expect_Pieces (What : String; Number : Word);

      procedure Receive (Error : Word; Flags : Word) is
      begin
         Item (Error_Status) := Error;
         Down.Give (GSC.TELIN_Variable, Item);
         GSC.GDCIN.Run_Transaction;
         Item (Error_Status) := Flags;
         Expect_Buffer
           ("to CORE",
            Framed.Taken ("to CORE", GSC.Downlink_Variable).Words, Item);
         Expect_Errors ("fresh input", GSC.Errors, None);
      end Receive;

      procedure Expect_Pieces (What : String; Number : Word) is
      begin
         Expect
           (What, Word (GSC.Log_Receiver.Incoming.Contents.Got), Number);
      end Expect_Pieces;

   begin
      Clear;
      Receive (Error => 0, Flags => 0);
      Down.Expect_Counts ("received", GSC.TELIN_Variable, 1, 1);
      Framed.Expect_Counts ("sent", GSC.Downlink_Variable, 1, 1);
      Expect_Pieces ("no piece", 0);

      --  A fragment of the log is taken out, unless it came before.
      Receive (Error => 16#1074#, Flags => 4);
      Expect_Pieces ("the first piece", 1);
      Expect
        ("its row", Word (GSC.Log_Receiver.Incoming.Contents.Which), 7);
      Receive (Error => 16#2AB5#, Flags => 5);
      Expect_Pieces ("no piece of an old one", 1);
      Receive (Error => 16#2CD0#, Flags => 0);
      Expect_Pieces ("the second piece", 2);

      GSC.GDCIN.Run_Transaction;
      Expect_Buffer
        ("old, to CORE", Framed.Taken ("again", GSC.Downlink_Variable).Words,
         As_Old (Downlink_Of (16#200#)));
      Expect_Pieces ("no piece of what did not come", 2);
      Expect_Errors ("old input", GSC.Errors, (1 => No_Input));

      Framed.Give (GSC.Downlink_Variable, Framed_Of (16#100#));
      Down.Give (GSC.TELIN_Variable, Downlink_Of (16#200#));
      GSC.GDCIN.Run_Transaction;
      Expect_Buffer
        ("to CORE", Framed.Taken ("the newest", GSC.Downlink_Variable).Words,
         Downlink_Of (16#200#));
      Expect_Errors
        ("CORE did not take", GSC.Errors, (1 => Downlink_Not_Consumed));
   end Ground_In;

   procedure Ground_In_Too_Large is
      Item : Downlink_Buffer;
   begin
      for Which in Sensor_Item loop
         Clear;
         Item := Downlink_Of (16#100#);
         Item (Which) := 16#FFFF#;
         Down.Give (GSC.TELIN_Variable, Item);
         GSC.GDCIN.Run_Transaction;
         Expect_Buffer
           ("to CORE",
            Framed.Taken ("to CORE", GSC.Downlink_Variable).Words, Item);
         Expect_Errors
           (Which'Image, GSC.Errors, (1 => Input_Out_Of_Range),
            Detail => Sensor_Item'Pos (Which) + 1);
      end loop;
   end Ground_In_Too_Large;

   procedure Ground_Out is
      To_CORE : Uplink_Buffer;
   begin
      Clear;
      Stick_Images.Give
        (GSC.AD_Variable, Image_Of (16#300#, Error => 16#91#));
      GSC.Status.Write (16#8#);
      GSC.GDCOUT.Run_Transaction;
      Stick_Images.Expect_Counts ("received", GSC.AD_Variable, 1, 1);
      Up.Expect_Counts ("sent to CORE", GSC.Uplink_Variable, 1, 0);
      Up.Expect_Counts ("sent to TELOUT", GSC.TELOUT_Variable, 1, 0);
      To_CORE := Up.Taken ("to CORE", GSC.Uplink_Variable);
      for Item in Command_Item loop
         Expect (Item'Image, To_CORE (Item), Uplink_Of (16#300#) (Item));
      end loop;
      Expect ("error word", To_CORE (Error_Status), 16#99#);
      Expect_Buffer
        ("to TELOUT", Up.Taken ("to TELOUT", GSC.TELOUT_Variable), To_CORE);
      Expect_Errors ("fresh image", GSC.Errors, None);

      Clear;
      Stick_Images.Give (GSC.AD_Variable, Image_Of (16#300#, Error => 0));
      GSC.GDCOUT.Run_Transaction;
      Expect_Errors ("fresh image", GSC.Errors, None);
      GSC.GDCOUT.Run_Transaction;
      Expect_Buffer
        ("old, to CORE", Up.Taken ("to CORE", GSC.Uplink_Variable),
         As_Old (Uplink_Of (16#300#)));
      Expect_Buffer
        ("old, to TELOUT", Up.Taken ("to TELOUT", GSC.TELOUT_Variable),
         As_Old (Uplink_Of (16#300#)));
      Expect_Errors
        ("old image, nobody took", GSC.Errors,
         (No_Image, Uplink_Not_Consumed, Output_Not_Consumed));
   end Ground_Out;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "MDI-1 commands go to CORE and to PWM", Aircraft_In'Access);
      Add
        (Suite, "MDI-1 SAF-5 D-14 without new commands old ones go out",
         Aircraft_In_Old'Access);
      Add
        (Suite, "MDI-1 commands not taken are reported",
         Aircraft_In_Unread'Access);
      Add
        (Suite, "D-11 commands above 0FFFh go to CORE and are an error",
         Aircraft_In_Too_Large'Access);
      Add
        (Suite, "MDO-1 27 sensors and the error word go to CORE and down",
         Aircraft_Out'Access);
      Add
        (Suite, "MDO-1 SAF-5 D-14 without a new image an old one goes out",
         Aircraft_Out_Old'Access);
      Add
        (Suite, "FTI-12 a downlink and CORE have the frame, card and servos",
         Aircraft_Out_Frame'Access);
      Add
        (Suite, "FTI-12 D-11 sensors above 0FFFh go down limited, an error",
         Aircraft_Out_Too_Large'Access);
      Add
        (Suite, "FTI-12 the ground's CORE has the sensors and their frame",
         Ground_In_Frame'Access);
      Add
        (Suite, "GDI-1 SAF-5 sensors go to CORE, marked if none are new",
         Ground_In'Access);
      Add
        (Suite, "D-11 sensors above 0FFFh go to CORE and are an error",
         Ground_In_Too_Large'Access);
      Add
        (Suite, "GDO-1 SAF-5 13 commands and error word go to CORE and up",
         Ground_Out'Access);
   end Add_To;

end Exchange_Tests;
