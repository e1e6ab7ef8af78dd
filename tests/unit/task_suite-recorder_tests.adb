--  SPDX-License-Identifier: Apache-2.0

with Checks;              use Checks;
with Expectations;        use Expectations;
with URV.Buffers;         use URV.Buffers;
with URV.Law_Gains;       use URV.Law_Gains;
with URV.Mailboxes;       use URV.Mailboxes;
with URV.Recorder_Blocks; use URV.Recorder_Blocks;
with URV.Recorder_Rings;  use URV.Recorder_Rings;
with URV.Recorder_Rows;   use URV.Recorder_Rows;
with URV.Recorder_Senders;
with URV.Recorder_Steps;  use URV.Recorder_Steps;
with URV.Routing;         use URV.Routing;
with URV.Shared_Recorders;
with URV.Type_Codes;      use URV.Type_Codes;
with URVOS;               use URVOS;

separate (Task_Suite)
package body Recorder_Tests is

   --  The tests, in order.
   procedure The_Newest_Rows;
   procedure Sums;
   procedure Stops_And_Goes_On;
   procedure Second_Flight;
   procedure Cleared_After_Flight;
   procedure Unknown_State;
   procedure Sends_On_Request;

   Requests : For_Uplink.Variable;
   Recorder : URV.Shared_Recorders.Recorder;

   package Sender is new URV.Recorder_Senders (Requests, Recorder);

   Flying : constant Downlink_Buffer :=
     (Neutral_Downlink with delta
        Airspeed => Flying_Speed, Altitude => 0, Error_Status => No_Error);

   Standing : constant Downlink_Buffer :=
     (Flying with delta
        Airspeed => Flying_Speed - 1, Altitude => Flying_Height - 1);

   --  Each has words of its own.
   function Words_Of
     (Sensors : Downlink_Buffer; Value : Word) return Recorded_Words
   is
     ((Sensors => (Sensors with delta Alpha => Value), others => <>));

   procedure Record_Frames (Sensors : Downlink_Buffer; Frames : Positive);

   procedure Record_Frames (Sensors : Downlink_Buffer; Frames : Positive) is
   begin
      for Frame in 1 .. Frames loop
         Recorder.Take
           (Words_Of (Sensors, Word (Recorder.Contents.Next mod 4_096)));
      end loop;
   end Record_Frames;

   procedure Expect_Held (What : String; First, Rows : Natural);

   procedure Expect_Held (What : String; First, Rows : Natural) is
      Kept : constant Ring := Recorder.Contents;
   begin
      Expect_Number (What & ": rows", Integer (Kept.Held), Rows);
      Expect_Number
        (What & ": the first", Integer (URV.Recorder_Rings.First (Kept)),
         First);
      for Number in First .. First + Rows - 1 loop
         Expect
           ("row" & Number'Image,
            Recorder.Row_At (Row_Number (Number)).Words.Sensors (Alpha),
            Word (Number));
      end loop;
      Expect
        ("none after them",
         Recorder.Row_At (Kept.Next) = (others => <>), True);
      Expect
        ("none before them",
         First = 0
         or else Recorder.Row_At (Row_Number (First - 1)) = (others => <>),
         True);
   end Expect_Held;

   procedure The_Newest_Rows is
   begin
      for Length in Ring_Length range 1 .. 4 loop
         Recorder.Set_Length (Length);
         Expect_Held ("at first", 0, 0);
         for Rows in 1 .. 3 * Integer (Length) + 1 loop
            Record_Frames (Flying, 1);
            Expect_Held
              (Rows'Image, Integer'Max (Rows - Integer (Length), 0),
               Integer'Min (Rows, Integer (Length)));
         end loop;
         Recorder.Clear;
         Expect_Held ("cleared", 0, 0);
         Expect_Number
           ("length", Integer (Recorder.Contents.Length), Integer (Length));
      end loop;
   end The_Newest_Rows;

   procedure Sums is
      Item  : constant Row := Row_Of (70_000, Words_Of (Flying, 16#FFF#));
      Sum   : Word := 0;
      Whole : Word := 0;
   begin
      for Place in Content_Word loop
         Sum := Sum + Word_At (Item, Place);
         Whole := Whole + Sum;
      end loop;
      Expect ("number, high", Word_At (Item, 1), 1);
      Expect ("number, low", Word_At (Item, 2), 4_464);
      Expect ("sum", Word_At (Item, 71), Sum);
      Expect ("sum of sums", Word_At (Item, 72), Whole);
   end Sums;

   procedure Stops_And_Goes_On is
      Before : Integer;
   begin
      Recorder.Set_Length (200);

      --  Before the first flight it records, standing for any time.
      Record_Frames (Standing, 3 * Frames_After_Landing);
      Expect_Number
        ("standing", Integer (Recorder.Contents.Next),
         3 * Frames_After_Landing);

      Record_Frames (Flying, 1);
      Record_Frames (Standing, 2 * Frames_After_Landing);
      Before := Integer (Recorder.Contents.Next);
      Expect_Number
        ("landed", Before, 4 * Frames_After_Landing);

      --  Either sensor is enough to fly again.
      Record_Frames
        ((Standing with delta Altitude => Flying_Height), 1);
      Expect_Number
        ("high", Integer (Recorder.Contents.Next), Before + 1);
   end Stops_And_Goes_On;

   procedure Second_Flight is
      Before : Integer;
   begin
      --  A landing after another flight has its second, too.
      Recorder.Set_Length (200);
      Record_Frames (Flying, 1);
      Record_Frames (Standing, 2 * Frames_After_Landing);
      Before := Integer (Recorder.Contents.Next);
      Record_Frames (Flying, 10);
      Expect_Number
        ("second flight", Integer (Recorder.Contents.Next), Before + 10);
      Record_Frames (Standing, 2 * Frames_After_Landing);
      Expect_Number
        ("second landing", Integer (Recorder.Contents.Next),
         Before + 9 + Frames_After_Landing);
   end Second_Flight;

   procedure Cleared_After_Flight is
   begin
      --  After a cold start it records as before the first flight, for any
      --  time, although rows were fetched before the start.
      Recorder.Set_Length (200);
      Record_Frames (Flying, 1);
      Record_Frames (Standing, 2 * Frames_After_Landing);
      Recorder.Stop;
      Recorder.Clear;
      Record_Frames (Standing, 3 * Frames_After_Landing);
      Expect_Number
        ("standing after a cold start", Integer (Recorder.Contents.Next),
         3 * Frames_After_Landing);
   end Cleared_After_Flight;

   procedure Unknown_State is
   begin
      Recorder.Set_Length (200);
      Record_Frames (As_Old (Standing), 3 * Frames_After_Landing);
      Record_Frames (Standing, 3 * Frames_After_Landing);
      Expect_Number
        ("old words are no flight", Integer (Recorder.Contents.Next),
         6 * Frames_After_Landing);
      Recorder.Stop;
      Record_Frames (As_Old (Flying), 10);
      Expect_Number
        ("they do not let it go on", Integer (Recorder.Contents.Next),
         6 * Frames_After_Landing);
      Expect ("no ground", Is_On_Ground (As_Old (Standing)), False);
      Expect ("no flight", Is_Flying (As_Old (Flying)), False);
   end Unknown_State;

   procedure Sends_On_Request is

      procedure Ask (First : Row_Number; Rows : Field);

      procedure Expect_Next
        (What : String; Sensors, Block : Downlink_Buffer);

      procedure Expect_None (What : String; Sensors : Downlink_Buffer);

      procedure Ask (First : Row_Number; Rows : Field) is
         Unused_Success : Boolean;
      begin
         Requests.Send (Block_Of (Request'(First, Rows)), Unused_Success);
      end Ask;

      procedure Expect_Next
        (What : String; Sensors, Block : Downlink_Buffer)
      is
         Found   : Downlink_Buffer;
         Is_Sent : Boolean;
      begin
         Sender.Next (Sensors, Found, Is_Sent);
         Expect (What & " comes", Is_Sent, True);
         Expect (What, Found = Block, True);
         Expect
           (What & ": its kind", Is_Other_Kind (Found) and then
              Kind_Of (Found) in Recorder_Kind | Recorder_Report_Kind, True);
         Expect (What & ": 12 bits", Any_Out_Of_Range (Found), False);
      end Expect_Next;

      procedure Expect_None (What : String; Sensors : Downlink_Buffer) is
         Unused_Block : Downlink_Buffer;
         Is_Sent      : Boolean;
      begin
         Sender.Next (Sensors, Unused_Block, Is_Sent);
         Expect (What, Is_Sent, False);
      end Expect_None;

   begin
      Recorder.Set_Length (8);
      Record_Frames (Flying, 20);
      Sender.Restart;
      Requests.Reset;
      Expect_None ("nothing asked", Standing);

      Ask (13, 2);
      Expect_Next
        ("report", Standing, Report_Of (Accepted, Recorder.Contents));
      for Number in Row_Number range 13 .. 14 loop
         for Which in Part loop
            Expect_Next
              ("row", Standing,
               Block_Of (Recorder.Row_At (Number), Which));
         end loop;
         Expect_None ("sensors", Standing);
      end loop;
      Expect_None ("all is sent", Standing);

      --  The oldest one is the first.
      Ask (0, 1);
      Expect_Next
        ("report", Standing, Report_Of (Accepted, Recorder.Contents));
      Expect_Next
        ("row 12", Standing, Block_Of (Recorder.Row_At (12), 0));

      --  Flight ends it. A request is then answered once.
      Expect_None ("flying", Flying);
      Expect_None ("standing again", Standing);
      Ask (13, 2);
      Expect_Next ("refused", Flying, Report_Of (Flies, Recorder.Contents));
      Expect_None ("once", Standing);
      Ask (20, 2);
      Expect_Next
        ("not held", Standing, Report_Of (Not_Held, Recorder.Contents));
      Expect_None ("no row", Standing);
   end Sends_On_Request;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "FTI-9 the ring holds the newest rows in order",
           The_Newest_Rows'Access);
      Add (Suite, "FTI-9 a row has the sums of its words", Sums'Access);
      Add (Suite, "FTI-9 the recorder stops a second after a landing",
           Stops_And_Goes_On'Access);
      Add (Suite, "FTI-9 after a second landing it stops a second later",
           Second_Flight'Access);
      Add (Suite, "FTI-9 a cold start forgets the flight before",
           Cleared_After_Flight'Access);
      Add (Suite, "FTI-9 old sensors neither stop it nor let it go on",
           Unknown_State'Access);
      Add (Suite, "FTI-10 rows go down on request, on the ground",
           Sends_On_Request'Access);
   end Add_To;

end Recorder_Tests;
