with Checks;       use Checks;
with Expectations; use Expectations;
with Task_Doubles; use Task_Doubles;
with URVOS;        use URVOS;
with URV.Buffers;  use URV.Buffers;
with URV.Errors;   use URV.Errors;
with URV.Log_Pieces;  use URV.Log_Pieces;
with URV.GDCIN_Task;
with URV.GDCOUT_Task;
with URV.MDCIN_Task;
with URV.MDCOUT_Task;
with URV.Routing;      use URV.Routing;

package body Exchange_Tests is

   --  The tests, in order.
   procedure Aircraft_In;
   procedure Aircraft_In_Old;
   procedure Aircraft_In_Unread;
   procedure Aircraft_In_Too_Large;
   procedure Aircraft_Out;
   procedure Aircraft_Out_Old;
   procedure Ground_In;
   procedure Ground_In_Too_Large;
   procedure Ground_Out;

   --  The pieces of the log that go down, and the last that came.
   Down, Came : Piece := No_Piece;

   procedure Next_Piece (Item : out Piece);
   procedure Take_Piece (Item : Piece);

   package MDCIN is new URV.MDCIN_Task
     (Input_Up.Receive, Uplink.Send, Commands.Send, Report);

   package MDCOUT is new URV.MDCOUT_Task
     (Image.Receive, Downlink.Send, Output_Down.Send, Read_Status,
      Next_Piece, Report);

   package GDCIN is new URV.GDCIN_Task
     (Input_Down.Receive, Downlink.Send, Take_Piece, Report);

   package GDCOUT is new URV.GDCOUT_Task
     (Image.Receive, Uplink.Send, Output_Up.Send, Read_Status, Report);

   procedure Next_Piece (Item : out Piece) is
   begin
      Item := Down;
   end Next_Piece;

   procedure Take_Piece (Item : Piece) is
   begin
      Came := Item;
   end Take_Piece;

   procedure Aircraft_In is
   begin
      Clear;
      Input_Up.Given := Uplink_Of (16#100#);
      MDCIN.Run_Transaction;
      Expect_Number ("received", Input_Up.Received, 1);
      Expect_Number ("sent to CORE", Uplink.Sent, 1);
      Expect_Number ("sent to PWM", Commands.Sent, 1);
      Expect_Buffer ("to CORE", Uplink.Kept, Uplink_Of (16#100#));
      Expect_Buffer ("to PWM", Commands.Kept, Uplink_Of (16#100#));
      Expect_Errors ("fresh input", None);
   end Aircraft_In;

   procedure Aircraft_In_Old is
   begin
      Clear;
      Input_Up.Given    := Uplink_Of (16#100#);
      Input_Up.Is_Fresh := False;
      MDCIN.Run_Transaction;
      Expect_Buffer ("to CORE", Uplink.Kept, As_Old (Uplink_Of (16#100#)));
      Expect_Buffer ("to PWM", Commands.Kept, As_Old (Uplink_Of (16#100#)));
      Expect_Number ("sent to CORE", Uplink.Sent, 1);
      Expect_Number ("sent to PWM", Commands.Sent, 1);
      Expect_Errors ("old input", (1 => No_Input));
   end Aircraft_In_Old;

   procedure Aircraft_In_Unread is
   begin
      Clear;
      Uplink.Succeeds := False;
      MDCIN.Run_Transaction;
      Expect_Number ("sent to PWM all the same", Commands.Sent, 1);
      Expect_Errors ("CORE did not take", (1 => Uplink_Not_Consumed));

      Uplink.Succeeds   := True;
      Commands.Succeeds := False;
      MDCIN.Run_Transaction;
      Expect_Errors ("PWM did not take", (1 => Commands_Not_Consumed));
   end Aircraft_In_Unread;

   procedure Aircraft_In_Too_Large is
   begin
      for Item in Command_Item loop
         Clear;
         Input_Up.Given (Item) := 16#1000#;
         MDCIN.Run_Transaction;
         Expect_Buffer ("to CORE", Uplink.Kept, Input_Up.Given);
         Expect_Errors
           (Item'Image, (1 => Input_Out_Of_Range),
            Detail => Command_Item'Pos (Item) + 1);
      end loop;

      --  The error word may hold anything.
      Clear;
      Input_Up.Given (Error_Status) := 16#FFFF#;
      MDCIN.Run_Transaction;
      Expect_Errors ("error word", None);
   end Aircraft_In_Too_Large;

   procedure Aircraft_Out is
   begin
      Clear;
      Image.Given := Image_Of (16#100#, Error => 16#7#);
      MDCOUT.Run_Transaction;
      for Item in Sensor_Item loop
         Expect
           (Item'Image, Downlink.Kept (Item), Downlink_Of (16#100#) (Item));
      end loop;
      Expect ("error word", Downlink.Kept (Error_Status), 16#7#);
      Expect_Buffer ("to TELOUT", Output_Down.Kept, Downlink.Kept);
      Expect_Number ("received", Image.Received, 1);
      Expect_Number ("sent to CORE", Downlink.Sent, 1);
      Expect_Number ("sent to TELOUT", Output_Down.Sent, 1);
      Expect_Errors ("fresh image", None);

      Status := 16#8#;
      MDCOUT.Run_Transaction;
      Expect ("with the node's own", Downlink.Kept (Error_Status), 16#F#);

      --  The log's piece goes down, and not to CORE.
      Down := 16#ABC#;
      MDCOUT.Run_Transaction;
      Expect ("CORE has no piece", Downlink.Kept (Error_Status), 16#F#);
      Expect ("down it goes", Output_Down.Kept (Error_Status), 16#ABCF#);
      Down := No_Piece;
   end Aircraft_Out;

   procedure Aircraft_Out_Old is
   begin
      Clear;
      Image.Given    := Image_Of (16#100#, Error => 0);
      Image.Is_Fresh := False;
      MDCOUT.Run_Transaction;
      Expect ("to CORE", Downlink.Kept (Altitude), 16#119#);
      Expect ("to TELOUT", Output_Down.Kept (Altitude), 16#119#);
      Expect ("the mark", Downlink.Kept (Error_Status), Stale_Data);
      Expect ("the mark, down", Output_Down.Kept (Error_Status), Stale_Data);
      Expect_Errors ("old image", (1 => No_Image));

      Image.Is_Fresh       := True;
      Downlink.Succeeds    := False;
      Output_Down.Succeeds := False;
      MDCOUT.Run_Transaction;
      Expect_Errors
        ("nobody took", (Downlink_Not_Consumed, Output_Not_Consumed));
   end Aircraft_Out_Old;

   procedure Ground_In is
   begin
      Clear;
      Input_Down.Given := Downlink_Of (16#200#);
      GDCIN.Run_Transaction;
      Expect_Buffer ("to CORE", Downlink.Kept, Downlink_Of (16#200#));
      Expect_Number ("sent", Downlink.Sent, 1);
      Expect_Errors ("fresh input", None);

      --  A piece of the log is taken out, unless it came before.
      Input_Down.Given (Error_Status) := 16#ABC4#;
      GDCIN.Run_Transaction;
      Expect ("the piece", Came, 16#ABC#);
      Expect ("CORE's flags", Downlink.Kept (Error_Status), 4);
      Input_Down.Given (Error_Status) := 16#1235#;
      GDCIN.Run_Transaction;
      Expect ("no piece of an old one", Came, 16#ABC#);
      Expect ("CORE's flags, old", Downlink.Kept (Error_Status), 5);
      Input_Down.Given := Downlink_Of (16#200#);
      Downlink.Clear;

      Input_Down.Is_Fresh := False;
      GDCIN.Run_Transaction;
      Expect_Buffer
        ("old, to CORE", Downlink.Kept, As_Old (Downlink_Of (16#200#)));
      Expect_Number ("sent again", Downlink.Sent, 1);
      Expect_Errors ("old input", (1 => No_Input));

      Input_Down.Is_Fresh := True;
      Downlink.Succeeds   := False;
      GDCIN.Run_Transaction;
      Expect_Errors ("CORE did not take", (1 => Downlink_Not_Consumed));
   end Ground_In;

   procedure Ground_In_Too_Large is
   begin
      for Item in Sensor_Item loop
         Clear;
         Input_Down.Given (Item) := 16#FFFF#;
         GDCIN.Run_Transaction;
         Expect_Buffer ("to CORE", Downlink.Kept, Input_Down.Given);
         Expect_Errors
           (Item'Image, (1 => Input_Out_Of_Range),
            Detail => Sensor_Item'Pos (Item) + 1);
      end loop;
   end Ground_In_Too_Large;

   procedure Ground_Out is
   begin
      Clear;
      Image.Given := Image_Of (16#300#, Error => 16#99#);
      GDCOUT.Run_Transaction;
      for Item in Command_Item loop
         Expect (Item'Image, Uplink.Kept (Item), Uplink_Of (16#300#) (Item));
      end loop;
      Expect ("error word", Uplink.Kept (Error_Status), 16#99#);
      Expect_Buffer ("to TELOUT", Output_Up.Kept, Uplink.Kept);
      Expect_Number ("sent to CORE", Uplink.Sent, 1);
      Expect_Number ("sent to TELOUT", Output_Up.Sent, 1);
      Expect_Errors ("fresh image", None);

      Image.Given        := Image_Of (16#300#, Error => 0);
      Image.Is_Fresh     := False;
      Uplink.Succeeds    := False;
      Output_Up.Succeeds := False;
      GDCOUT.Run_Transaction;
      Expect ("old, to TELOUT", Output_Up.Kept (Roll), 16#300#);
      Expect ("the mark", Uplink.Kept (Error_Status), Stale_Data);
      Expect ("the mark, up", Output_Up.Kept (Error_Status), Stale_Data);
      Expect_Errors
        ("old image, nobody took",
         (No_Image, Uplink_Not_Consumed, Output_Not_Consumed));
   end Ground_Out;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "MDI-1 commands go to CORE and to PWM", Aircraft_In'Access);
      Add
        (Suite, "MDI-1 SAF-5 D-14 without new commands old ones go out",
         Aircraft_In_Old'Access);
      Add
        (Suite, "MDI-1 who did not take the commands is reported",
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
