with Checks;              use Checks;
with Devices.AD_Board;
with Devices.CORE_Memory;
with Devices.PWM_Board;
with Expectations;        use Expectations;
with GSC;
with MCS;
with Telemetry;           use Telemetry;
with Telemetry.Headers;   use Telemetry.Headers;
with Telemetry.Senders;
with URVOS;               use URVOS;
with URVOS.Frames;        use URVOS.Frames;
with URV.Buffers;         use URV.Buffers;
with URV.Codecs;
with URV.CORE_Layout;     use URV.CORE_Layout;
with URV.Errors;          use URV.Errors;
with URV.PWM_Layout;      use URV.PWM_Layout;
with URV.Routing;

package body Node_Tests is

   --  The tests, in order.
   procedure Offsets;
   procedure Late_Release;
   procedure Cold_Start_Of_PWM;
   procedure Cold_Start_Of_AD;
   procedure Cold_Start_Of_Telemetry;
   procedure Cold_Start_Of_CORE;
   procedure Type_Codes;
   procedure First_Variables;
   procedure Scan_To_Image;
   procedure Missing_Scan;
   procedure Nothing_Before_First_Message;
   procedure Previous_Message;
   procedure Commands_Pass;
   procedure Commands_Of_Before;
   procedure Commands_Out_Of_Range;
   procedure PWM_Left_Alone;
   procedure Output_Once;
   procedure Output_Overwrites;
   procedure CORE_Not_Rewritten;
   procedure Sensors_Pass;
   procedure Ground_Input;
   procedure Ground_Output;

   --  Rig

   procedure Start;
   --  Both nodes as after power up.

   procedure Uplink_Arrives (Item : Uplink_Buffer);
   procedure Downlink_Arrives (Item : Downlink_Buffer);
   --  The other end's block comes in at the telemetry board, whole.

   procedure Scan_On_MCS (First : Word);
   procedure Scan_On_GSC (First : Word);
   --  The converter gives First for channel 0 and one more for each next.

   function CORE_Of_MCS return Devices.CORE_Memory.Memory;
   function CORE_Of_GSC return Devices.CORE_Memory.Memory;

   function Outputs return PWM_Buffer;

   function MCS_Errors (Kind : Error_Kind) return Count;
   function GSC_Errors (Kind : Error_Kind) return Count;

   generic
      Length : Block_Length;
      with procedure Accept_Character
        (Elapsed      : Character_Times;
         Data         : Byte;
         Parity_Error : Boolean;
         May_Speak    : out Boolean);
      with procedure Next_Character
        (Elapsed   : Character_Times;
         Send      : out Boolean;
         Data      : out Byte;
         Time_Left : out Character_Times);
   procedure Deliver (Data : Block_Data);

   --  Commands that differ from each other and from neutral.
   Some_Commands : constant Uplink_Buffer :=
     (Roll         => 16#101#,
      Pitch        => 16#202#,
      Yaw          => 16#303#,
      Throttle     => 16#404#,
      Brake        => 16#905#,
      Switch_Item  => 0,
      Error_Status => No_Error);

   procedure Start is
   begin
      GSC.Telemetry_Board.Start;
      GSC.Cold_Start (0);
      MCS.Telemetry_Board.Start;
      MCS.Cold_Start (0);
   end Start;

   procedure Deliver (Data : Block_Data) is
      Sender    : Telemetry.Senders.Sender;
      Item      : Byte;
      May_Speak : Boolean;
      Send      : Boolean;
      Time_Left : Character_Times;
   begin
      for Place in 1 .. Telemetry.Senders.Message_Length (Length) loop
         Telemetry.Senders.Send_Next (Sender, Data, Length, Item);
         Accept_Character (1, Item, False, May_Speak);
      end loop;

      --  The status it answers with, and an empty transmitter again.
      Next_Character (0, Send, Item, Time_Left);
      Expect ("an answer", Send, True);
      Expect ("the answer is good", Decode (Item).Good, True);
      Next_Character (1, Send, Item, Time_Left);
   end Deliver;

   procedure Deliver_To_MCS is new Deliver
     (28,
      MCS.Telemetry_Board.Accept_Character,
      MCS.Telemetry_Board.Next_Character);

   --  The ground takes data only when it has commanded it; so it sends a
   --  block, hears that the aircraft wants to downlink, and commands.
   procedure Deliver_To_GSC (Data : Block_Data);

   procedure Uplink_Arrives (Item : Uplink_Buffer) is
   begin
      Deliver_To_MCS (URV.Codecs.Uplink.Encode (Item));
   end Uplink_Arrives;

   procedure Deliver_To_GSC (Data : Block_Data) is
      procedure Deliver_Data is new Deliver
        (56,
         GSC.Telemetry_Board.Accept_Character,
         GSC.Telemetry_Board.Next_Character);

      Overwrote : Boolean;
      Send      : Boolean;
      Item      : Byte;
      Time_Left : Character_Times;
      May_Speak : Boolean;
   begin
      GSC.Telemetry_Board.Put ((others => 0), Overwrote);
      loop
         GSC.Telemetry_Board.Next_Character (1, Send, Item, Time_Left);
         exit when not Send;
      end loop;
      GSC.Telemetry_Board.Accept_Character
        (1,
         Encode ((Status, Good => True, Wants_Downlink => True)),
         False,
         May_Speak);
      GSC.Telemetry_Board.Next_Character (0, Send, Item, Time_Left);
      Expect ("command to downlink", Item, 16#4B#);
      GSC.Telemetry_Board.Next_Character (1, Send, Item, Time_Left);
      Deliver_Data (Data);
   end Deliver_To_GSC;

   procedure Downlink_Arrives (Item : Downlink_Buffer) is
   begin
      Deliver_To_GSC (URV.Codecs.Downlink.Encode (Item));
   end Downlink_Arrives;

   procedure Scan_On_MCS (First : Word) is
      Interrupt : Boolean;
   begin
      for Which in Channel loop
         MCS.AD_Board.Finish (First + Word (Which), Interrupt);
         MCS.AD_Interrupt;
      end loop;
   end Scan_On_MCS;

   procedure Scan_On_GSC (First : Word) is
      Interrupt : Boolean;
   begin
      for Which in Channel loop
         GSC.AD_Board.Finish (First + Word (Which), Interrupt);
         GSC.AD_Interrupt;
      end loop;
   end Scan_On_GSC;

   function CORE_Of_MCS return Devices.CORE_Memory.Memory is
      Result : Devices.CORE_Memory.Memory;
   begin
      MCS.CORE_Memory.Inspect (Result);
      return Result;
   end CORE_Of_MCS;

   function CORE_Of_GSC return Devices.CORE_Memory.Memory is
      Result : Devices.CORE_Memory.Memory;
   begin
      GSC.CORE_Memory.Inspect (Result);
      return Result;
   end CORE_Of_GSC;

   function Outputs return PWM_Buffer is
      Area : Devices.PWM_Board.Data_Area;
   begin
      MCS.PWM_Board.Read (Area);
      return To_Outputs (Area);
   end Outputs;

   function MCS_Errors (Kind : Error_Kind) return Count is
      Counts : Error_Counts;
   begin
      MCS.Errors.Inspect (Counts);
      return Counts (Kind);
   end MCS_Errors;

   function GSC_Errors (Kind : Error_Kind) return Count is
      Counts : Error_Counts;
   begin
      GSC.Errors.Inspect (Counts);
      return Counts (Kind);
   end GSC_Errors;

   --  Tests

   procedure Offsets is
      Of_MCS : constant array (MCS.Task_Name) of Tick :=
        (MCS.AD_Task     => 0, MCS.TELIN_Task  => 0, MCS.MDCIN_Task => 1,
         MCS.MDCOUT_Task => 1, MCS.PWM_Task    => 2, MCS.TELOUT_Task => 2,
         MCS.CORE_Task   => 4);
      Of_GSC : constant array (GSC.Task_Name) of Tick :=
        (GSC.AD_Task     => 0, GSC.TELIN_Task  => 0, GSC.GDCIN_Task => 1,
         GSC.GDCOUT_Task => 1, GSC.TELOUT_Task => 2, GSC.CORE_Task => 4);
   begin
      Start;
      for Frame in Tick range 1 .. 3 loop
         for Who in MCS.Task_Name loop
            Expect ("MCS " & Who'Image, MCS.Executive.Wake_Up (Who),
                    Frame * 10 + Of_MCS (Who));
         end loop;
         for Who in GSC.Task_Name loop
            Expect ("GSC " & Who'Image, GSC.Executive.Wake_Up (Who),
                    Frame * 10 + Of_GSC (Who));
         end loop;
         for Now in Frame * 10 .. Frame * 10 + 9 loop
            MCS.Clock_Interrupt (Now);
            GSC.Clock_Interrupt (Now);
         end loop;
      end loop;
   end Offsets;

   procedure Late_Release is
   begin
      Start;
      MCS.Clock_Interrupt (10);
      Expect ("overruns at tick 10", MCS.Executive.Overruns, 0);

      --  Ticks 11 to 13 are missed: four tasks are late, CORE is not.
      MCS.Clock_Interrupt (14);
      Expect ("overruns at tick 14", MCS.Executive.Overruns, 4);
   end Late_Release;

   procedure Cold_Start_Of_PWM is
   begin
      MCS.PWM_Board.Write ((others => 16#0123#));
      Start;
      for Item in PWM_Item loop
         Expect (Item'Image, Outputs (Item), 16#0800#);
      end loop;
   end Cold_Start_Of_PWM;

   procedure Cold_Start_Of_AD is
      use Devices.AD_Board;
      Board     : constant Registers := Initialised ((others => <>));
      Interrupt : Boolean;
   begin
      Expect ("vector", Board.Vector, Interrupt_Vector);
      Expect ("enabled", Board.Interrupt_Enabled, True);
      Start;
      MCS.AD_Board.Finish (0, Interrupt);
      Expect ("the board interrupts", Interrupt, True);
   end Cold_Start_Of_AD;

   procedure Cold_Start_Of_Telemetry is
      Overwrote : Boolean;
   begin
      Start;
      MCS.Telemetry_Board.Put ((others => 1), Overwrote);
      Expect ("a block of before overwrote", Overwrote, False);
      MCS.Telemetry_Board.Put ((others => 2), Overwrote);
      Expect ("another of before overwrote", Overwrote, False);
      Start;
      MCS.Telemetry_Board.Put ((others => 3), Overwrote);
      Expect ("first block overwrote", Overwrote, False);
      MCS.Telemetry_Board.Put ((others => 4), Overwrote);
      Expect ("second block overwrote", Overwrote, False);
      MCS.Telemetry_Board.Put ((others => 5), Overwrote);
      Expect ("third block overwrote", Overwrote, True);
   end Cold_Start_Of_Telemetry;

   procedure Cold_Start_Of_CORE is
      use type Devices.CORE_Memory.Memory;
   begin
      MCS.CORE_Memory.Write_Uplink ((others => 1));
      MCS.CORE_Memory.Write_Downlink ((others => 2));
      Start;
      Expect ("CORE is clear", CORE_Of_MCS = Devices.CORE_Memory.Cleared,
              True);
   end Cold_Start_Of_CORE;

   procedure Type_Codes is
   begin
      Start;
      MCS.CORE.Run_Transaction;
      for Item in Uplink_Item loop
         Expect (Item'Image, CORE_Of_MCS.Uplink_Codes (Place (Item)),
                 16#0101# + Word (Uplink_Item'Pos (Item)));
      end loop;
      for Item in Downlink_Item loop
         Expect (Item'Image, CORE_Of_MCS.Downlink_Codes (Place (Item)),
                 16#0201# + Word (Downlink_Item'Pos (Item)));
      end loop;

      --  Only the first run writes them.
      MCS.CORE_Memory.Clear;
      MCS.CORE.Run_Transaction;
      Expect ("code after the second run", CORE_Of_MCS.Uplink_Codes (1), 0);
   end Type_Codes;

   procedure First_Variables is
      Item  : Uplink_Buffer;
      Fresh : Boolean;
   begin
      Start;
      MCS.PWM_Variable.Receive (Item, Fresh);
      Expect ("fresh", Fresh, False);
      Expect ("roll", Item (Roll), 16#0800#);
      Expect ("switch 8", Item (Switch_8), 0);
   end First_Variables;

   procedure Scan_To_Image is
      Image : AD_Image;
      Fresh : Boolean;
   begin
      Start;
      Scan_On_MCS (16#100#);
      MCS.AD.Run_Transaction;
      MCS.AD_Variable.Receive (Image, Fresh);
      Expect ("fresh", Fresh, True);
      Expect ("channel 0", Image.Words (0), 16#100#);
      Expect ("channel 31", Image.Words (31), 16#11F#);
      Expect ("error word", Image.Error_Status, No_Error);
   end Scan_To_Image;

   procedure Missing_Scan is
      Image : AD_Image;
      Fresh : Boolean;
   begin
      Start;
      Scan_On_MCS (16#100#);
      MCS.AD.Run_Transaction;
      MCS.AD_Variable.Receive (Image, Fresh);

      --  No interrupt comes in this frame.
      MCS.AD.Run_Transaction;
      MCS.AD_Variable.Receive (Image, Fresh);
      Expect ("sent all the same", Fresh, True);
      Expect ("channel 31 of before", Image.Words (31), 16#11F#);
      Expect ("error word", Image.Error_Status, Stale_Data);
      Expect ("counted", MCS_Errors (AD_No_Scan), 1);

      --  The scan was begun again and the next one clears the error.
      Scan_On_MCS (16#200#);
      MCS.AD.Run_Transaction;
      MCS.AD_Variable.Receive (Image, Fresh);
      Expect ("channel 0, anew", Image.Words (0), 16#200#);
      Expect ("error word, anew", Image.Error_Status, No_Error);
   end Missing_Scan;

   procedure Nothing_Before_First_Message is
      Item  : Uplink_Buffer;
      Fresh : Boolean;
   begin
      Start;
      MCS.TELIN.Run_Transaction;
      MCS.TELIN_Variable.Receive (Item, Fresh);
      Expect ("sent before any message", Fresh, False);
   end Nothing_Before_First_Message;

   procedure Previous_Message is
      Item  : Uplink_Buffer;
      Fresh : Boolean;
   begin
      Start;
      Uplink_Arrives (Some_Commands);
      MCS.TELIN.Run_Transaction;
      MCS.TELIN_Variable.Receive (Item, Fresh);
      Expect ("first frame, fresh", Fresh, True);
      Expect ("first frame, pitch", Item (Pitch), 16#202#);

      MCS.TELIN.Run_Transaction;
      MCS.TELIN_Variable.Receive (Item, Fresh);
      Expect ("second frame, sent", Fresh, True);
      Expect ("second frame, pitch of before", Item (Pitch), 16#202#);
      Expect ("counted", MCS_Errors (TELIN_No_Block), 1);
   end Previous_Message;

   procedure Commands_Pass is
   begin
      Start;
      Uplink_Arrives (Some_Commands);
      MCS.TELIN.Run_Transaction;
      MCS.MDCIN.Run_Transaction;
      MCS.PWM.Run_Transaction;
      MCS.CORE.Run_Transaction;
      for Item in Uplink_Item loop
         Expect ("CORE " & Item'Image, CORE_Of_MCS.Uplink (Place (Item)),
                 Some_Commands (Item));
      end loop;
      Expect ("left elevator", Outputs (Left_Elevator), 16#202#);
      Expect ("brake", Outputs (Brake), 16#905#);
   end Commands_Pass;

   procedure Commands_Of_Before is
      Item  : Uplink_Buffer;
      Fresh : Boolean;
   begin
      Start;
      Uplink_Arrives (Some_Commands);
      MCS.TELIN.Run_Transaction;
      MCS.MDCIN.Run_Transaction;
      MCS.PWM_Variable.Receive (Item, Fresh);

      MCS.MDCIN.Run_Transaction;
      MCS.PWM_Variable.Receive (Item, Fresh);
      Expect ("sent again", Fresh, True);
      Expect ("yaw of before", Item (Yaw), 16#303#);
      Expect ("counted", MCS_Errors (No_Input), 1);
   end Commands_Of_Before;

   procedure Commands_Out_Of_Range is
   begin
      Start;
      Uplink_Arrives ((Some_Commands with delta Yaw => 16#F303#));
      MCS.TELIN.Run_Transaction;
      MCS.MDCIN.Run_Transaction;
      MCS.PWM.Run_Transaction;
      MCS.CORE.Run_Transaction;
      Expect ("CORE", CORE_Of_MCS.Uplink (Place (Uplink_Item'(Yaw))),
              16#F303#);
      Expect ("rudder", Outputs (Left_Rudder), 16#0FFF#);
      Expect ("counted", MCS_Errors (Input_Out_Of_Range), 1);
   end Commands_Out_Of_Range;

   procedure PWM_Left_Alone is
   begin
      Start;
      MCS.PWM_Board.Write ((others => 16#0123#));
      MCS.PWM.Run_Transaction;
      Expect ("steering", Outputs (Steering), 16#0123#);
      Expect ("counted", MCS_Errors (No_Commands), 1);
   end PWM_Left_Alone;

   procedure Output_Once is
      Overwrote : Boolean;
   begin
      Start;
      GSC.AD.Run_Transaction;
      GSC.GDCOUT.Run_Transaction;
      GSC.TELOUT.Run_Transaction;
      GSC.TELOUT.Run_Transaction;
      Expect ("counted", GSC_Errors (No_Output), 1);

      --  One buffer is full, the other is not.
      GSC.Telemetry_Board.Put ((others => 0), Overwrote);
      Expect ("the second buffer was full", Overwrote, False);
      GSC.Telemetry_Board.Put ((others => 0), Overwrote);
      Expect ("the first buffer was full", Overwrote, True);
   end Output_Once;

   procedure Output_Overwrites is
   begin
      Start;
      for Frame in 1 .. 3 loop
         GSC.AD.Run_Transaction;
         GSC.GDCOUT.Run_Transaction;
         GSC.TELOUT.Run_Transaction;
      end loop;
      Expect ("counted", GSC_Errors (TELOUT_Overwrote_Block), 1);
   end Output_Overwrites;

   procedure CORE_Not_Rewritten is
   begin
      Start;
      Uplink_Arrives (Some_Commands);
      MCS.TELIN.Run_Transaction;
      MCS.MDCIN.Run_Transaction;
      MCS.CORE.Run_Transaction;
      MCS.CORE_Memory.Write_Uplink ((others => 7));
      MCS.CORE.Run_Transaction;
      Expect ("roll", CORE_Of_MCS.Uplink (1), 7);
      Expect ("counted", MCS_Errors (CORE_No_Uplink), 1);
   end CORE_Not_Rewritten;

   procedure Sensors_Pass is
   begin
      Start;
      Scan_On_MCS (16#300#);
      MCS.AD.Run_Transaction;
      MCS.MDCOUT.Run_Transaction;
      MCS.CORE.Run_Transaction;
      for Item in Sensor_Item loop
         Expect
           (Item'Image, CORE_Of_MCS.Downlink (Place (Item)),
            16#300# + Word (URV.Routing.Channel_Of (Item)));
      end loop;
      Expect ("error word is the 28th", CORE_Of_MCS.Downlink (28), No_Error);

      --  Nothing new from the converter: the same goes out again.
      MCS.MDCOUT.Run_Transaction;
      MCS.CORE.Run_Transaction;
      Expect ("the first sensor, again", CORE_Of_MCS.Downlink (1), 16#300#);
      Expect ("counted", MCS_Errors (No_Image), 1);
   end Sensors_Pass;

   procedure Ground_Input is
      Sent : Downlink_Buffer := Neutral_Downlink;
   begin
      Start;
      for Item in Downlink_Item loop
         Sent (Item) := 16#500# + Word (Downlink_Item'Pos (Item));
      end loop;
      Downlink_Arrives (Sent);
      GSC.TELIN.Run_Transaction;
      GSC.GDCIN.Run_Transaction;
      GSC.CORE.Run_Transaction;
      for Item in Downlink_Item loop
         Expect (Item'Image, CORE_Of_GSC.Downlink (Place (Item)),
                 Sent (Item));
      end loop;

      --  Nothing new: the same goes on.
      GSC.GDCIN.Run_Transaction;
      GSC.CORE.Run_Transaction;
      Expect ("rpm, again", CORE_Of_GSC.Downlink (Place (RPM)), Sent (RPM));
      Expect ("counted", GSC_Errors (No_Input), 1);
   end Ground_Input;

   procedure Ground_Output is
   begin
      Start;
      Scan_On_GSC (16#400#);
      GSC.AD.Run_Transaction;
      GSC.GDCOUT.Run_Transaction;
      GSC.CORE.Run_Transaction;
      for Item in Command_Item loop
         Expect
           (Item'Image, CORE_Of_GSC.Uplink (Place (Item)),
            16#400# + Word (URV.Routing.Channel_Of (Item)));
      end loop;
      Expect ("error word is the 14th", CORE_Of_GSC.Uplink (14), No_Error);
   end Ground_Output;

   procedure Add_To (Suite : not null AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "FRM-2 each task is released at its minor frame, SET-1",
           Offsets'Access);
      Add (Suite, "FRM-4 a task released late is counted",
           Late_Release'Access);
      Add (Suite, "INI-3 a cold start puts every PWM channel at 0800h",
           Cold_Start_Of_PWM'Access);
      Add (Suite, "INI-4 a cold start empties the transmit buffers",
           Cold_Start_Of_Telemetry'Access);
      Add (Suite, "INI-5 a cold start enables the A/D interrupt",
           Cold_Start_Of_AD'Access);
      Add (Suite, "INI-6 a cold start clears CORE",
           Cold_Start_Of_CORE'Access);
      Add (Suite, "INI-7 BUF-4 CORE's first run writes the type codes",
           Type_Codes'Access);
      Add (Suite, "INI-8 a variable first holds neutral data, not fresh",
           First_Variables'Access);
      Add (Suite, "AD-1 a scan becomes an image without error",
           Scan_To_Image'Access);
      Add (Suite, "AD-1 a missing scan sets the error word",
           Missing_Scan'Access);
      Add (Suite, "TIN-1 nothing is sent before the first message",
           Nothing_Before_First_Message'Access);
      Add (Suite, "TIN-1 with nothing new the message before is sent",
           Previous_Message'Access);
      Add (Suite, "MDI-1 PWM-1 commands reach CORE and the servos",
           Commands_Pass'Access);
      Add (Suite, "MDI-1 with nothing new the commands before are sent",
           Commands_Of_Before'Access);
      Add (Suite, "D-11 a word above 0fffh: CORE as it is, servo clipped",
           Commands_Out_Of_Range'Access);
      Add (Suite, "PWM-1 with nothing new the board is left alone",
           PWM_Left_Alone'Access);
      Add (Suite, "TOU-1 with nothing new nothing is written",
           Output_Once'Access);
      Add (Suite, "TOU-1 with no buffer free the newest overwrites, counted",
           Output_Overwrites'Access);
      Add (Suite, "COR-1 what has not come anew is not written again",
           CORE_Not_Rewritten'Access);
      Add (Suite, "MDO-1 D-1 sensors reach CORE, the error word is the 28th",
           Sensors_Pass'Access);
      Add (Suite, "GDI-1 sensor data reaches the ground's CORE",
           Ground_Input'Access);
      Add (Suite, "GDO-1 D-3 stick data reaches CORE, 14 words",
           Ground_Output'Access);
   end Add_To;

end Node_Tests;
