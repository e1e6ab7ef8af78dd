with Checks;       use Checks;
with Expectations; use Expectations;
with Task_Doubles; use Task_Doubles;
with Telemetry;    use Telemetry;
with URV.Buffers;  use URV.Buffers;
with URV.Codecs;
with URV.Errors;   use URV.Errors;
with URV.Routing;  use URV.Routing;
with URV.TELIN_Task;
with URV.TELOUT_Task;

package body Telemetry_Task_Tests is

   --  The tests, in order.
   procedure Before_The_First;
   procedure New_Block;
   procedure Block_Again;
   procedure Not_Consumed;
   procedure Cold_Again;
   procedure New_Output;
   procedure No_Output_Now;
   procedure No_Buffer;

   --  The telemetry board under the tasks.
   Block         : Block_Data := (others => 0);
   Block_Fresh   : Boolean    := False;
   Ever          : Boolean    := False;
   Taken         : Natural    := 0;
   Put_Data      : Block_Data := (others => 0);
   Put_Count     : Natural    := 0;
   Put_Overwrote : Boolean    := False;

   procedure Take_Block
     (Data          : out Block_Data;
      Fresh         : out Boolean;
      Ever_Received : out Boolean);

   procedure Put_Block (Data : Block_Data; Overwrote : out Boolean);

   package TELIN is new URV.TELIN_Task
     (Message    => Uplink_Buffer,
      Neutral    => Neutral_Uplink,
      As_Old     => URV.Routing.As_Old,
      Decode     => URV.Codecs.Uplink.Decode,
      Take_Block => Take_Block,
      Send_TELIN => Input_Up.Send,
      Report     => Report);

   package TELOUT is new URV.TELOUT_Task
     (Message        => Downlink_Buffer,
      Encode         => URV.Codecs.Downlink.Encode,
      Receive_TELOUT => Output_Down.Receive,
      Put_Block      => Put_Block,
      Report         => Report);

   procedure Take_Block
     (Data          : out Block_Data;
      Fresh         : out Boolean;
      Ever_Received : out Boolean) is
   begin
      Taken         := Taken + 1;
      Data          := (if Block_Fresh then Block else (others => 0));
      Fresh         := Block_Fresh;
      Ever_Received := Ever;
   end Take_Block;

   procedure Put_Block (Data : Block_Data; Overwrote : out Boolean) is
   begin
      Put_Count := Put_Count + 1;
      Put_Data  := Data;
      Overwrote := Put_Overwrote;
   end Put_Block;

   procedure Before_The_First is
   begin
      Clear;
      Taken       := 0;
      Block_Fresh := False;
      Ever        := False;
      TELIN.Initialise;
      for Frame in 1 .. 5 loop
         TELIN.Run_Transaction;
      end loop;
      Expect_Number ("looked", Taken, 5);
      Expect_Number ("sent", Input_Up.Sent, 0);
      Expect_Errors ("before the first message", None);
   end Before_The_First;

   procedure New_Block is
   begin
      Before_The_First;
      Block       := URV.Codecs.Uplink.Encode (Uplink_Of (16#100#));
      Block_Fresh := True;
      Ever        := True;
      TELIN.Run_Transaction;
      Expect_Number ("sent", Input_Up.Sent, 1);
      Expect_Buffer ("message", Input_Up.Kept, Uplink_Of (16#100#));
      Expect_Errors ("a new block", None);
   end New_Block;

   procedure Block_Again is
   begin
      New_Block;
      Block_Fresh := False;
      for Frame in 1 .. 3 loop
         TELIN.Run_Transaction;
         Expect_Number ("sent", Input_Up.Sent, 1 + Frame);
         Expect_Buffer
           ("previous", Input_Up.Kept, As_Old (Uplink_Of (16#100#)));
         Expect_Errors ("nothing new", (1 => TELIN_No_Block));
      end loop;

      Block       := URV.Codecs.Uplink.Encode (Uplink_Of (16#200#));
      Block_Fresh := True;
      TELIN.Run_Transaction;
      Expect_Buffer ("the next", Input_Up.Kept, Uplink_Of (16#200#));
   end Block_Again;

   procedure Not_Consumed is
   begin
      New_Block;
      Input_Up.Succeeds := False;
      TELIN.Run_Transaction;
      Expect_Errors ("nobody took", (1 => Input_Not_Consumed));
   end Not_Consumed;

   procedure Cold_Again is
   begin
      --  The board has received messages before, but the one before the
      --  start is lost: nothing may go to the servos in its place.
      New_Block;
      TELIN.Initialise;
      Block_Fresh := False;
      Input_Up.Sent := 0;
      TELIN.Run_Transaction;
      Expect_Number ("nothing sent", Input_Up.Sent, 0);
      Block_Fresh := True;
      TELIN.Run_Transaction;
      Expect_Number ("sent when one has come", Input_Up.Sent, 1);
   end Cold_Again;

   procedure New_Output is
   begin
      Clear;
      Put_Count         := 0;
      Put_Overwrote     := False;
      Output_Down.Given := Downlink_Of (16#300#);
      TELOUT.Run_Transaction;
      Expect_Number ("put", Put_Count, 1);
      Expect_Buffer
        ("block", URV.Codecs.Downlink.Decode (Put_Data),
         Downlink_Of (16#300#));
      Expect_Errors ("new output", None);
   end New_Output;

   procedure No_Output_Now is
   begin
      New_Output;
      Output_Down.Is_Fresh := False;
      TELOUT.Run_Transaction;
      Expect_Number ("put", Put_Count, 1);
      Expect_Errors ("nothing new", (1 => No_Output));
   end No_Output_Now;

   procedure No_Buffer is
   begin
      New_Output;
      Put_Overwrote := True;
      TELOUT.Run_Transaction;
      Expect_Number ("put", Put_Count, 2);
      Expect_Errors ("no buffer", (1 => TELOUT_Overwrote_Block));
   end No_Buffer;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "TIN-1 before the first message nothing is sent",
         Before_The_First'Access);
      Add (Suite, "TIN-1 a new block is sent on", New_Block'Access);
      Add
        (Suite, "TIN-1 without a new block the one before is sent on",
         Block_Again'Access);
      Add
        (Suite, "TIN-1 a message that nobody took is reported",
         Not_Consumed'Access);
      Add
        (Suite, "INI-8 TIN-1 a start sends nothing on until a message comes",
         Cold_Again'Access);
      Add (Suite, "TOU-1 a new message goes to the board", New_Output'Access);
      Add
        (Suite, "TOU-1 nothing is written when nothing new has come",
         No_Output_Now'Access);
      Add
        (Suite, "TOU-1 a block that replaces another is reported",
         No_Buffer'Access);
   end Add_To;

end Telemetry_Task_Tests;
