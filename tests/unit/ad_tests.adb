with Checks;           use Checks;
with Devices.AD_Board; use Devices.AD_Board;
with Devices.Shared_AD_Board;
with Expect_Value;
with Expectations;     use Expectations;
with Task_Doubles;     use Task_Doubles;
with URVOS;            use URVOS;
with URV.AD_Scans;     use URV.AD_Scans;
with URV.AD_Task;
with URV.ADINT_Handler;
with URV.Buffers;      use URV.Buffers;
with URV.Errors;       use URV.Errors;

package body AD_Tests is

   --  The tests, in order.
   procedure Scan_Itself;
   procedure Past_The_Last;
   procedure Whole_Scan;
   procedure Stray_Interrupt;
   procedure Broken_Off_Scan;
   procedure Not_Consumed;
   procedure Fresh_Scan;
   procedure Old_Scan;
   procedure Image_Unread;
   procedure The_Board;
   procedure Each_Start_Once;
   procedure Abandoned;

   procedure Expect is new Expect_Value (Next_Step);
   procedure Expect is new Expect_Value (Activity);

   --  The board under the handler: what it gives, and the channels that
   --  were started.
   Board_Data : Word    := 0;
   Started    : Natural := 0;
   Last_Start : Channel_Number := 0;

   procedure Read_Board (Data : out Word);
   procedure Start_Channel (Which : Channel_Number);

   package Handler is new URV.ADINT_Handler
     (Read_Board    => Read_Board,
      Start_Channel => Start_Channel,
      Send_ADINT    => Words.Send,
      Report        => Report);

   --  The task on its own, and how far it finds the scan before.
   Scans_Begun  : Natural       := 0;
   Scan_Reached : Channel_Count := 32;

   procedure Begin_Scan (Reached : out Channel_Count);

   --  A whole scan, after one that had come so far.
   procedure Whole_Scan (Reached : Channel_Count);

   package AD is new URV.AD_Task
     (Receive_ADINT => Words.Receive,
      Send_AD       => Image.Send,
      Begin_Scan    => Begin_Scan,
      Report        => Report);

   procedure Read_Board (Data : out Word) is
   begin
      Data := Board_Data;
   end Read_Board;

   procedure Start_Channel (Which : Channel_Number) is
   begin
      Started    := Started + 1;
      Last_Start := Which;
   end Start_Channel;

   procedure Begin_Scan (Reached : out Channel_Count) is
   begin
      Scans_Begun := Scans_Begun + 1;
      Reached     := Scan_Reached;
   end Begin_Scan;

   procedure Scan_Itself is
      Item : Scan;
      Next : Next_Step;
   begin
      Expect ("a new scan is complete", Is_Complete (Item), True);
      Item := Restarted (Item);
      for Number in Channel loop
         Expect_Number
           ("channel awaited", Integer (Item.Current), Integer (Number));
         Store (Item, 16#200# + Word (Number), Next);
         Expect
           ("after channel" & Number'Image, Next,
            (if Number = 31 then Send_Words else Start_Channel));
         for Other in Channel loop
            Expect
              ("after channel" & Number'Image & ", word" & Other'Image,
               Item.Words (Other),
               (if Other <= Number
                then 16#200# + Word (Other) else 16#800#));
         end loop;
      end loop;
      Expect ("complete", Is_Complete (Item), True);
   end Scan_Itself;

   procedure Past_The_Last is
      Item : Scan;
      Next : Next_Step;
   begin
      Store (Item, 16#FFF#, Next);
      Expect ("without a scan", Next, Ignore);
      for Number in Channel loop
         Expect ("word" & Number'Image, Item.Words (Number), 16#800#);
      end loop;
   end Past_The_Last;

   procedure Whole_Scan (Reached : Channel_Count) is
      Before : Channel_Count;
   begin
      Clear;
      Started := 0;
      Handler.Begin_Scan (Before);
      Expect_Number
        ("how far the scan before came", Integer (Before),
         Integer (Reached));
      for Number in Channel loop
         Expect_Number ("starts", Started, Integer (Number) + 1);
         Expect_Number
           ("channel started", Integer (Last_Start), Integer (Number));
         Expect_Number ("sent before the last", Words.Sent, 0);
         Board_Data := 16#300# + Word (Number);
         Handler.Handle_Interrupt;
      end loop;
      Expect_Number ("starts after the last channel", Started, 32);
      Expect_Number ("sent", Words.Sent, 1);
      for Number in Channel loop
         Expect
           ("channel" & Number'Image, Words.Kept (Number),
            16#300# + Word (Number));
      end loop;
      Expect_Errors ("a scan", None);
   end Whole_Scan;

   procedure Whole_Scan is
   begin
      Whole_Scan (Reached => 32);
   end Whole_Scan;

   procedure Stray_Interrupt is
   begin
      Whole_Scan;
      Board_Data := 16#ABC#;
      Handler.Handle_Interrupt;
      Expect_Number ("starts", Started, 32);
      Expect_Number ("sent", Words.Sent, 1);
      Expect_Errors
        ("after the scan", (1 => AD_Unexpected_Interrupt),
         Detail => 16#ABC#);
   end Stray_Interrupt;

   procedure Broken_Off_Scan is
      Reached : Channel_Count;
   begin
      --  The board stalls at any channel; the next scan is whole.
      for Stall in Channel loop
         Clear;
         Started := 0;
         Handler.Begin_Scan (Reached);
         Board_Data := 1;
         for Number in 1 .. Stall loop
            Handler.Handle_Interrupt;
         end loop;
         Expect_Number ("sent", Words.Sent, 0);
         Whole_Scan (Reached => Channel_Count (Stall));
      end loop;
   end Broken_Off_Scan;

   procedure Not_Consumed is
      Unused_Reached : Channel_Count;
   begin
      Clear;
      Words.Succeeds := False;
      Handler.Begin_Scan (Unused_Reached);
      for Number in Channel loop
         Handler.Handle_Interrupt;
      end loop;
      Expect_Errors ("overwritten", (1 => Scan_Not_Consumed));
   end Not_Consumed;

   procedure Fresh_Scan is
   begin
      Clear;
      Scans_Begun := 0;
      AD.Initialise;
      Expect_Number ("scans begun at first", Scans_Begun, 1);
      Words.Given := Image_Of (16#100#, 0).Words;
      AD.Run_Transaction;
      Expect_Number ("received", Words.Received, 1);
      Expect_Number ("sent", Image.Sent, 1);
      Expect ("error word", Image.Kept.Error_Status, No_Error);
      for Number in Channel loop
         Expect
           ("channel" & Number'Image, Image.Kept.Words (Number),
            16#100# + Word (Number));
      end loop;
      Expect_Number ("scans begun", Scans_Begun, 2);
      Expect_Errors ("a fresh scan", None);
   end Fresh_Scan;

   procedure Old_Scan is
   begin
      Clear;
      Scans_Begun := 0;
      Words.Given := Image_Of (16#100#, 0).Words;
      AD.Run_Transaction;
      Words.Is_Fresh := False;
      Scan_Reached   := 17;
      AD.Run_Transaction;
      Expect_Number ("sent all the same", Image.Sent, 2);
      Expect ("error word", Image.Kept.Error_Status, Stale_Data);
      Expect ("the words before", Image.Kept.Words (31), 16#11F#);
      Expect_Number ("scans begun", Scans_Begun, 2);
      Expect_Errors ("no scan", (1 => AD_No_Scan), Detail => 17);

      Words.Is_Fresh := True;
      AD.Run_Transaction;
      Expect ("error word cleared", Image.Kept.Error_Status, No_Error);
   end Old_Scan;

   procedure Image_Unread is
   begin
      Clear;
      Image.Succeeds := False;
      AD.Run_Transaction;
      Expect_Errors ("overwritten", (1 => Image_Not_Consumed));
   end Image_Unread;

   procedure The_Board is
      Board : Registers;
   begin
      Expect ("interrupt at power up", Board.Interrupt_Enabled, False);
      Expect ("at power up", Board.Doing, Idle);
      Board := Initialised (Board);
      Expect ("interrupt", Board.Interrupt_Enabled, True);
      Expect ("vector", Board.Vector, 16#40#);
      Expect_Number
        ("microseconds a scan", Microseconds_Per_Conversion * 32, 512);

      Board := Devices.AD_Board.Started (Board, 7);
      Expect ("started", Board.Doing, Start_Wanted);
      Board := Begun (Board);
      Expect ("begun", Board.Doing, Converting);
      Expect_Number ("channel", Integer (Board.Channel), 7);
      Board := Finished (Board, 16#ABC#);
      Expect ("finished", Board.Doing, Idle);
      Expect ("data", Board.Data, 16#ABC#);

      --  A new start abandons the conversion.
      Board := Begun (Devices.AD_Board.Started (Board, 3));
      Board := Devices.AD_Board.Started (Board, 4);
      Expect ("started anew", Board.Doing, Start_Wanted);
      Expect_Number ("channel", Integer (Board.Channel), 4);

      --  Whose value comes when the hardware has not seen that yet.
      Board := Finished (Board, 16#123#);
      Expect ("still wanted", Board.Doing, Start_Wanted);
      Expect ("no data of the abandoned", Board.Data, 16#ABC#);
      Board := Finished (Begun (Board), 16#456#);
      Expect ("data of the other", Board.Data, 16#456#);
   end The_Board;

   package Hardware is new Devices.Shared_AD_Board;

   procedure Each_Start_Once is
      Wanted    : Boolean;
      Interrupt : Boolean;
      Number    : Channel_Number;
      Data      : Word;
   begin
      Hardware.Take_Start (Wanted, Number);
      Expect ("at power up", Wanted, False);
      Hardware.Initialise;
      Hardware.Start (9);
      Hardware.Take_Start (Wanted, Number);
      Expect ("wanted", Wanted, True);
      Expect_Number ("channel", Integer (Number), 9);
      Hardware.Take_Start (Wanted, Number);
      Expect ("wanted again", Wanted, False);
      Hardware.Finish (16#DEF#, Interrupt);
      Expect ("interrupt", Interrupt, True);
      Hardware.Read (Data);
      Expect ("data", Data, 16#DEF#);
   end Each_Start_Once;

   procedure Abandoned is
      Wanted    : Boolean;
      Interrupt : Boolean;
      Number    : Channel_Number;
      Data      : Word;
   begin
      Hardware.Initialise;
      Hardware.Start (31);
      Hardware.Take_Start (Wanted, Number);
      Hardware.Finish (16#111#, Interrupt);
      Expect ("interrupt of channel 31", Interrupt, True);

      --  The next scan begins while the hardware is still at channel 31.
      Hardware.Start (31);
      Hardware.Take_Start (Wanted, Number);
      Hardware.Start (0);
      Hardware.Finish (16#800#, Interrupt);
      Expect ("interrupt", Interrupt, False);
      Hardware.Read (Data);
      Expect ("data", Data, 16#111#);
      Hardware.Take_Start (Wanted, Number);
      Expect ("channel 0 wanted", Wanted, True);
      Expect_Number ("channel", Integer (Number), 0);
      Hardware.Finish (16#222#, Interrupt);
      Expect ("interrupt of channel 0", Interrupt, True);
      Hardware.Read (Data);
      Expect ("data of channel 0", Data, 16#222#);
   end Abandoned;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "ADI-1 a scan stores its channels in order",
         Scan_Itself'Access);
      Add
        (Suite, "ADI-1 D-19 past the last channel nothing is stored",
         Past_The_Last'Access);
      Add
        (Suite, "ADI-1 32 interrupts are a scan, sent after channel 31",
         Whole_Scan'Access);
      Add
        (Suite, "ADI-1 an interrupt outside a scan starts and sends nothing",
         Stray_Interrupt'Access);
      Add
        (Suite, "ADI-1 a scan that breaks off does not spoil the next",
         Broken_Off_Scan'Access);
      Add
        (Suite, "ADI-1 a scan that nobody took is reported",
         Not_Consumed'Access);
      Add
        (Suite, "AD-1 a fresh scan clears the error word", Fresh_Scan'Access);
      Add
        (Suite, "AD-1 without a scan the words before go out as stale",
         Old_Scan'Access);
      Add
        (Suite, "AD-1 an image that nobody took is reported",
         Image_Unread'Access);
      Add
        (Suite, "INI-5 the board's vector is set and its interrupt enabled",
         The_Board'Access);
      Add
        (Suite, "ADI-1 the board's hardware sees each start once",
         Each_Start_Once'Access);
      Add
        (Suite, "ADI-1 SAF-2 an abandoned conversion gives no channel a word",
         Abandoned'Access);
   end Add_To;

end AD_Tests;
