--  SPDX-License-Identifier: Apache-2.0

with Checks;           use Checks;
with Devices.AD_Board; use Devices.AD_Board;
with Expect_Value;
with Expectations;     use Expectations;
with Task_Rig;         use Task_Rig;
with URVOS;            use URVOS;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Task_Trees; use URVOS.Task_Trees;
with URV.AD_Boards;
with URV.AD_Scans;     use URV.AD_Scans;
with URV.AD_Task;
with URV.ADINT_Handler;
with URV.Buffers;      use URV.Buffers;
with URV.Errors;       use URV.Errors;
with URV.Mailboxes;    use URV.Mailboxes;
with URV.Shared_Errors;
with URV.Shared_Schedules;

separate (Task_Suite)
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
   procedure Fast_Scans;
   procedure The_Board;
   procedure Each_Start_Once;
   procedure Abandoned;
   procedure Not_Prepared;
   procedure In_One_Call;

   procedure Expect is new Expect_Value (Next_Step);
   procedure Expect is new Expect_Value (Activity);

   --  The handler's and the task's surroundings

   Board : URV.AD_Boards.Board;

   ADINT_Variable : For_Sensor_Words.Variable;
   AD_Variable    : For_Sensor_Images.Variable;

   Errors : URV.Shared_Errors.Shared_Log;

   Schedule : URV.Shared_Schedules.Store;

   package Handler is new URV.ADINT_Handler
     (For_Sensor_Words, Board, ADINT_Variable, Errors);

   --  The scans that the task has begun, and the number in a frame of the fast
   --  schedule.
   Scans_Begun : Natural := 0;
   Scans_Made  : constant := 3;

   procedure Counted_Begin_Scan (Reached : out Channel_Count);

   package AD is new URV.AD_Task
     (For_Sensor_Words, For_Sensor_Images, ADINT_Variable, AD_Variable,
      Errors, Schedule, Counted_Begin_Scan, Fast_Scans => Scans_Made);

   --  Nothing sent, nothing reported, no conversion wanted.
   procedure Clear;

   --  Expects that the board wants a conversion of this channel, once.
   procedure Expect_Start (Number : Channel);
   procedure Expect_No_Start (What : String);

   --  The board converts and interrupts the processor.
   procedure Convert (Value : Word);

   --  Makes a whole scan after one that had reached this channel.
   procedure Whole_Scan (Reached : Channel_Count);

   procedure Counted_Begin_Scan (Reached : out Channel_Count) is
   begin
      Scans_Begun := Scans_Begun + 1;
      Handler.Begin_Scan (Reached);
   end Counted_Begin_Scan;

   procedure Clear is
      Unused_Wanted  : Boolean;
      Unused_Channel : Channel_Number;
   begin
      ADINT_Variable.Reset;
      AD_Variable.Reset;
      Errors.Clear;
      Board.Initialise;
      Board.Take_Start (Unused_Wanted, Unused_Channel);
      Scans_Begun := 0;
   end Clear;

   procedure Expect_Start (Number : Channel) is
      Wanted : Boolean;
      Which  : Channel_Number;
   begin
      Board.Take_Start (Wanted, Which);
      Expect ("channel" & Number'Image & " is started", Wanted, True);
      Expect_Number ("channel started", Integer (Which), Integer (Number));
   end Expect_Start;

   procedure Expect_No_Start (What : String) is
      Wanted       : Boolean;
      Unused_Which : Channel_Number;
   begin
      Board.Take_Start (Wanted, Unused_Which);
      Expect (What & ", a start", Wanted, False);
   end Expect_No_Start;

   procedure Convert (Value : Word) is
      Unused_Wanted : Boolean;
      Unused_Which  : Channel_Number;
      Interrupt     : Boolean;
   begin
      Board.Take_Start (Unused_Wanted, Unused_Which);
      Board.Finish (Value, Interrupt);
      Expect ("interrupt", Interrupt, True);
      Handler.Handle_Interrupt;
   end Convert;

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
      Sent   : Channel_Words;
   begin
      Clear;
      Handler.Begin_Scan (Before);
      Expect_Number
        ("how far the scan before came", Integer (Before),
         Integer (Reached));
      for Number in Channel loop
         Expect_Start (Number);
         Expect_No_Start ("until it has converted");
         Words.Expect_Counts ("before the last", ADINT_Variable, 0, 0);
         Convert (16#300# + Word (Number));
      end loop;
      Expect_No_Start ("after the last channel");
      Words.Expect_Counts ("sent", ADINT_Variable, 1, 0);
      Sent := Words.Taken ("the scan", ADINT_Variable);
      for Number in Channel loop
         Expect
           ("channel" & Number'Image, Sent (Number),
            16#300# + Word (Number));
      end loop;
      Expect_Errors ("a scan", Errors, None);
   end Whole_Scan;

   procedure Whole_Scan is
      Unused_Reached : Channel_Count;
   begin
      --  A complete scan comes first, whatever preceded it.
      Clear;
      Handler.Begin_Scan (Unused_Reached);
      for Number in Channel loop
         Convert (0);
      end loop;
      Whole_Scan (Reached => 32);
   end Whole_Scan;

   procedure Stray_Interrupt is
   begin
      Whole_Scan;
      Handler.Handle_Interrupt;
      Expect_No_Start ("after the scan");
      Words.Expect_Counts ("nothing more sent", ADINT_Variable, 1, 1);
      Expect_Errors
        ("after the scan", Errors, (1 => AD_Unexpected_Interrupt),
         Detail => 16#300# + 31);
   end Stray_Interrupt;

   procedure Broken_Off_Scan is
      Unused_Reached : Channel_Count;
   begin
      --  The board stalls at any channel; the next scan is complete.
      for Stall in Channel loop
         Clear;
         Handler.Begin_Scan (Unused_Reached);
         for Number in 1 .. Stall loop
            Convert (1);
         end loop;
         Words.Expect_Counts ("sent", ADINT_Variable, 0, 0);
         Whole_Scan (Reached => Channel_Count (Stall));
      end loop;
   end Broken_Off_Scan;

   procedure Not_Consumed is
      Unused_Reached : Channel_Count;
   begin
      Clear;
      Words.Give (ADINT_Variable, (others => 1));
      Handler.Begin_Scan (Unused_Reached);
      for Number in Channel loop
         Convert (2);
      end loop;
      Expect_Errors ("overwritten", Errors, (1 => Scan_Not_Consumed));
      Expect
        ("the newest", Words.Taken ("a scan", ADINT_Variable) (31), 2);
   end Not_Consumed;

   procedure Fresh_Scan is
      Image : AD_Image;
   begin
      Clear;
      AD.Initialise;
      Expect_Number ("scans begun at first", Scans_Begun, 1);
      Expect_Start (0);
      Images.Expect_Counts ("nothing sent at first", AD_Variable, 0, 0);
      Words.Give (ADINT_Variable, Image_Of (16#100#, 0).Words);
      AD.Run_Transaction (0);
      Words.Expect_Counts ("received", ADINT_Variable, 1, 1);
      Images.Expect_Counts ("sent", AD_Variable, 1, 0);
      Image := Images.Taken ("image", AD_Variable);
      Expect ("error word", Image.Error_Status, No_Error);
      for Number in Channel loop
         Expect
           ("channel" & Number'Image, Image.Words (Number),
            16#100# + Word (Number));
      end loop;
      Expect_Number ("scans begun", Scans_Begun, 2);
      Expect_Start (0);
      Expect_Errors ("a fresh scan", Errors, None);
   end Fresh_Scan;

   procedure Old_Scan is
      Image : AD_Image;
   begin
      Fresh_Scan;
      for Number in 1 .. 17 loop
         Convert (0);
      end loop;
      AD.Run_Transaction (0);
      Image := Images.Taken ("sent all the same", AD_Variable);
      Expect ("error word", Image.Error_Status, Stale_Data);
      Expect ("the words before", Image.Words (31), 16#11F#);
      Expect_Number ("scans begun", Scans_Begun, 3);
      Expect_Start (0);
      Expect_Errors ("no scan", Errors, (1 => AD_No_Scan), Detail => 17);

      for Number in Channel loop
         Convert (16#200#);
      end loop;
      AD.Run_Transaction (0);
      Image := Images.Taken ("the next", AD_Variable);
      Expect ("error word cleared", Image.Error_Status, No_Error);
      Expect ("the new words", Image.Words (31), 16#200#);
      Expect_Errors ("a scan again", Errors, None);
   end Old_Scan;

   procedure Fast_Scans is
      Begun : Natural := 0;

      --  Runs the AD task's steps at this tick. It ends them with EXIT, or
      --  sleeps until the next frame.
      procedure Run (What : String; Now : Clock_Tick; Waits : Boolean);

      --  Expects that the task has begun another scan.
      procedure Expect_Begun (What : String);

      --  The board converts it.
      procedure Scan (Value : Word);

      procedure Expect_Image
        (What : String; Value, Mark : Word);

      procedure Run (What : String; Now : Clock_Tick; Waits : Boolean) is
         Call : Kernel_Call := (Next_Frame_Call, Offset => 0, others => <>);
      begin
         AD.Run_Transaction (Now);
         AD.Await_Scan (Call);
         Expect (What & ", waits", Call.Name = Exit_Call, Waits);
         Expect (What & ", sleeps", Call.Name = Next_Frame_Call, not Waits);
      end Run;

      procedure Expect_Begun (What : String) is
      begin
         Begun := Begun + 1;
         Expect_Number (What & ", scans begun", Scans_Begun, Begun);
         Expect_Start (0);
      end Expect_Begun;

      procedure Scan (Value : Word) is
      begin
         Convert (Value);
         for Number in 1 .. 31 loop
            Expect_Start (Channel (Number));
            Convert (Value);
         end loop;
      end Scan;

      procedure Expect_Image
        (What : String; Value, Mark : Word)
      is
         Image : constant AD_Image := Images.Taken (What, AD_Variable);
      begin
         Expect (What & ", first word", Image.Words (0), Value);
         Expect (What & ", last word", Image.Words (31), Value);
         Expect (What & ", mark", Image.Error_Status, Mark);
      end Expect_Image;

      Unused_Call : Kernel_Call := (Next_Frame_Call, others => <>);
   begin
      Clear;
      Schedule.Write (Fast);
      AD.Initialise;
      Expect_Number ("no scan at first", Scans_Begun, 0);
      AD.Await_Scan (Unused_Call);
      Expect
        ("does not wait at first", Unused_Call.Name = Next_Frame_Call, True);

      --  The task makes all scans that fit in a minor frame, and sends on the
      --  last.
      for Frame in Word range 1 .. 2 loop
         Run ("frame", 10 * Tick (Frame), Waits => True);
         for Number in Word range 1 .. Scans_Made loop
            Expect_Begun ("scan" & Number'Image);
            Run ("too early", 10 * Tick (Frame), Waits => True);
            Images.Expect_Counts
              ("nothing sent yet", AD_Variable, Count (Frame) - 1,
               Count (Frame) - 1);
            Scan (16#100# * Frame + Number);
            Run ("in time", 10 * Tick (Frame),
                 Waits => Number < Scans_Made);
         end loop;
         Expect_No_Start ("behind the last");
         Expect_Image
           ("the last", 16#100# * Frame + Scans_Made, No_Error);
      end loop;
      Expect_Errors ("fresh scans", Errors, None);
      Words.Expect_Counts
        ("scans received", ADINT_Variable, 2 * Scans_Made,
         2 * Scans_Made);

      --  The tick ends before the second scan: the first is sent on.
      Run ("one scan", 30, Waits => True);
      Expect_Begun ("one scan");
      Scan (16#301#);
      Run ("one scan in time", 30, Waits => True);
      Expect_Begun ("the second");
      Convert (16#302#);
      Run ("the next tick", 31, Waits => False);
      Expect_Image ("the newest in time", 16#301#, No_Error);
      Expect_Errors ("one is enough", Errors, None);
      Words.Expect_Counts
        ("one missed", ADINT_Variable, 2 * Scans_Made + 1,
         2 * Scans_Made + 1, Misses => 1);

      --  No scan ends in time.
      Expect_Start (1);
      Run ("no scan", 40, Waits => True);
      Expect_Begun ("no scan");
      Expect_Errors ("there was one before", Errors, None);
      Convert (0);
      Expect_Start (1);
      Run ("no scan in time", 41, Waits => False);
      Expect_Image ("the words before", 16#301#, Stale_Data);
      Expect_Errors ("not told before the next", Errors, None);
      Run ("the frame after", 50, Waits => True);
      Expect_Begun ("the frame after");
      Expect_Errors ("no scan", Errors, (1 => AD_No_Scan), Detail => 1);

      --  A scan that ends too late does not count for the next frame.
      Run ("none in time again", 51, Waits => False);
      Expect_Image ("without a scan", 16#301#, Stale_Data);
      for Number in Channel loop
         Convert (16#500#);
      end loop;
      Run ("behind a late one", 60, Waits => True);
      Expect_Begun ("behind a late one");
      Run ("none but the late one", 61, Waits => False);
      Expect_Image ("the words of the late one", 16#500#, Stale_Data);
      Expect_Errors
        ("none in time", Errors, (1 => AD_No_Scan), Detail => 32);

      --  A scan that is complete when the time is over is taken as the last.
      Run ("a late look", 70, Waits => True);
      Expect_Errors
        ("none the frame before", Errors, (1 => AD_No_Scan), Detail => 0);
      Expect_Begun ("a late look");
      Scan (16#600#);
      Run ("at the end", 71, Waits => False);
      Expect_Number ("no other is begun", Scans_Begun, Begun);
      Expect_Image ("the late one", 16#600#, No_Error);

      --  A start of the node's tasks restarts the AD task.
      Run ("scanning", 80, Waits => True);
      AD.Initialise;
      AD.Await_Scan (Unused_Call);
      Expect
        ("does not wait after a start", Unused_Call.Name = Next_Frame_Call,
         True);
      Schedule.Write (Report);
   end Fast_Scans;

   procedure Image_Unread is
   begin
      Clear;
      for Mark in Word range 1 .. 2 loop
         Words.Give (ADINT_Variable, (others => Mark));
         AD.Run_Transaction (0);
         Expect_Errors
           ("image" & Mark'Image, Errors,
            (if Mark = 1 then None else (1 => Image_Not_Consumed)));
      end loop;
      Expect
        ("the newest", Images.Taken ("an image", AD_Variable).Words (0), 2);
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
      Expect ("restarted", Board.Doing, Start_Wanted);
      Expect_Number ("channel", Integer (Board.Channel), 4);

      --  The value comes before the hardware has seen the new start.
      Board := Finished (Board, 16#123#);
      Expect ("still wanted", Board.Doing, Start_Wanted);
      Expect ("no data of the abandoned", Board.Data, 16#ABC#);
      Board := Finished (Begun (Board), 16#456#);
      Expect ("data of the other", Board.Data, 16#456#);
   end The_Board;

   procedure Each_Start_Once is
      Hardware       : URV.AD_Boards.Board;
      Unused_Reached : Channel_Count;
      Wanted         : Boolean;
      Interrupt      : Boolean;
      Number         : Channel_Number;
      Data           : Word;
      Next           : Next_Step;
   begin
      Hardware.Take_Start (Wanted, Number);
      Expect ("at power up", Wanted, False);
      Hardware.Initialise;
      Hardware.Begin_Scan (Unused_Reached);
      Hardware.Take_Start (Wanted, Number);
      Expect ("wanted", Wanted, True);
      Expect_Number ("channel", Integer (Number), 0);
      Hardware.Take_Start (Wanted, Number);
      Expect ("wanted again", Wanted, False);
      Hardware.Finish (16#DEF#, Interrupt);
      Expect ("interrupt", Interrupt, True);
      Hardware.Take_Value (Data, Next);
      Expect ("data", Data, 16#DEF#);
      Expect ("next", Next, Start_Channel);
   end Each_Start_Once;

   procedure Abandoned is
      Hardware  : URV.AD_Boards.Board;
      Reached   : Channel_Count;
      Wanted    : Boolean;
      Interrupt : Boolean;
      Number    : Channel_Number;
      Data      : Word;
      Next      : Next_Step;
   begin
      Hardware.Initialise;
      Hardware.Begin_Scan (Reached);
      Hardware.Take_Start (Wanted, Number);
      Hardware.Finish (16#111#, Interrupt);
      Expect ("interrupt of channel 0", Interrupt, True);
      Hardware.Take_Value (Data, Next);
      Hardware.Take_Start (Wanted, Number);
      Expect_Number ("channel", Integer (Number), 1);

      --  The next scan begins while the hardware is still at channel 1.
      Hardware.Begin_Scan (Reached);
      Expect_Number ("reached", Integer (Reached), 1);
      Hardware.Finish (16#800#, Interrupt);
      Expect ("interrupt", Interrupt, False);
      Hardware.Take_Start (Wanted, Number);
      Expect ("channel 0 wanted", Wanted, True);
      Expect_Number ("channel", Integer (Number), 0);
      Hardware.Finish (16#222#, Interrupt);
      Expect ("interrupt of channel 0", Interrupt, True);
      Hardware.Take_Value (Data, Next);
      Expect ("data of channel 0", Data, 16#222#);
      Expect ("stored", Hardware.Words (0), 16#222#);
   end Abandoned;

   procedure Not_Prepared is
      Hardware       : URV.AD_Boards.Board;
      Unused_Reached : Channel_Count;
      Wanted         : Boolean;
      Interrupt      : Boolean;
      Number         : Channel_Number;
   begin
      Hardware.Begin_Scan (Unused_Reached);
      Hardware.Take_Start (Wanted, Number);
      Hardware.Finish (16#111#, Interrupt);
      Expect ("interrupt", Interrupt, False);
   end Not_Prepared;

   procedure In_One_Call is
      Whole, Parts   : URV.AD_Boards.Board;
      Unused_Reached : Channel_Count;
      Wanted         : Boolean;
      Interrupt      : Boolean;
      Number         : Channel_Number;
      Next           : Successor;
      Part           : Next_Step;
      Unused_Data    : Word;

      --  The board is prepared, or a scan begins, now and then.
      procedure Prepare (Step : Natural);

      procedure Prepare (Step : Natural) is
      begin
         if Step = 5 then
            Whole.Initialise;
            Parts.Initialise;
         end if;
         if Step mod 41 = 3 then
            Whole.Begin_Scan (Unused_Reached);
            Parts.Begin_Scan (Unused_Reached);
         end if;
         if Step mod 82 = 3 then
            Whole.Take_Start (Wanted, Number);
            Parts.Take_Start (Wanted, Number);
         end if;
      end Prepare;

   begin
      for Step in 0 .. 400 loop
         Prepare (Step);
         Whole.Pass_Value (Word (Step), Next);
         Parts.Finish (Word (Step), Interrupt);
         Part := Discard;
         if Interrupt then
            Parts.Take_Value (Unused_Data, Part);
         end if;
         Parts.Take_Start (Wanted, Number);
         Expect_Number
           ("next at" & Step'Image, Integer (Next),
            (if Wanted then Integer (Number)
             else
               (case Part is
                   when Start_Channel => -1,
                   when Send_Words    => Integer (Scan_Complete),
                   when Ignore        => Integer (Not_Expected),
                   when Discard       => Integer (Nothing_Wanted))));
         Expect ("words at" & Step'Image, Whole.Words = Parts.Words, True);
      end loop;
   end In_One_Call;

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
        (Suite, "ADI-1 a scan not taken is reported",
         Not_Consumed'Access);
      Add
        (Suite, "AD-1 a fresh scan clears the error word", Fresh_Scan'Access);
      Add
        (Suite, "AD-1 without a scan the words before go out as stale",
         Old_Scan'Access);
      Add
        (Suite, "FRM-5 AD-1 MBX-3 in the fast schedule the newest scan of the"
         & " minor frame is handed on in it", Fast_Scans'Access);
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
      Add
        (Suite, "INI-5 an unprepared board does not interrupt",
         Not_Prepared'Access);
      Add
        (Suite, "ADI-1 a conversion's end in one call does the same",
         In_One_Call'Access);
   end Add_To;

end AD_Tests;
