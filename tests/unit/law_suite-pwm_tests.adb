--  SPDX-License-Identifier: Apache-2.0

with Checks;            use Checks;
with Devices.PWM_Board; use Devices.PWM_Board;
with Expectations;      use Expectations;
with Task_Rig;          use Task_Rig;
with URVOS.Frames;
with URVOS;             use URVOS;
with URV.Buffers;       use URV.Buffers;
with URV.Errors;        use URV.Errors;
with URV.Mailboxes;     use URV.Mailboxes;
with URV.PWM_Boards;
with URV.PWM_Layout;    use URV.PWM_Layout;
with URV.PWM_Task;
with URV.PWM_Transform; use URV.PWM_Transform;
with URV.Shared_Errors;
with URV.Shared_Inputs;
with URV.Shared_Surfaces;

separate (Law_Suite)
package body PWM_Tests is

   --  The tests, in order.
   procedure Neutral_All;
   procedure Each_Command;
   procedure Every_Switch;
   procedure Threshold;
   procedure Too_Large;
   procedure Error_Word;
   procedure Read_Back;
   procedure The_Task;
   procedure Hold_Timer;
   procedure Marked_Commands;

   --  Every command different, switches off.
   Commands : constant Uplink_Buffer :=
     (Roll         => 16#111#,
      Pitch        => 16#222#,
      Yaw          => 16#333#,
      Throttle     => 16#444#,
      Brake        => 16#555#,
      Switch_Item  => 0,
      Error_Status => No_Error);

   --  The command that each servo follows; the flaps follow none.
   type Servo_Source is array (Left_Aileron .. Brake) of Command_Item;
   Source : constant Servo_Source :=
     (Left_Aileron | Right_Aileron          => Roll,
      Left_Elevator | Right_Elevator        => Pitch,
      Left_Rudder | Right_Rudder | Steering => Yaw,
      Throttle                              => Throttle,
      Brake                                 => Brake);

   subtype Flap is PWM_Item range Left_Flap_1 .. Right_Flap_2;

   --  The task's surroundings

   Variable : For_Uplink.Variable;
   Health   : URV.Shared_Surfaces.Healths.Store;
   Added    : URV.Shared_Inputs.Store;
   Board    : URV.PWM_Boards.Board;
   Errors   : URV.Shared_Errors.Shared_Log;

   package PWM is new URV.PWM_Task (Variable, Health, Added, Board, Errors);

   --  Words that no task writes.
   Foreign : constant Data_Area := (others => 16#ABC#);

   --  All outputs for a set of commands.
   procedure Expect_Outputs
     (What  : String;
      Input : Uplink_Buffer;
      Flaps : Word;
      Bits  : Word);

   procedure Expect_Outputs
     (What  : String;
      Input : Uplink_Buffer;
      Flaps : Word;
      Bits  : Word)
   is
      Output : constant PWM_Buffer := Transform (Input);
   begin
      for Servo in Source'Range loop
         Expect
           (What & ", " & Servo'Image, Output (Servo),
            Word'Min (Input (Source (Servo)), 16#FFF#));
      end loop;
      for Servo in Flap loop
         Expect (What & ", " & Servo'Image, Output (Servo), Flaps);
      end loop;
      Expect (What & ", discretes", Output (Discretes), Bits);
   end Expect_Outputs;

   procedure Neutral_All is
      Output    : constant PWM_Buffer := Transform (Neutral_Uplink);
      New_Board : URV.PWM_Boards.Board;
   begin
      Expect
        ("at power up", New_Board.Contents = URV.PWM_Layout.Safe_Area, True);
      for Item in PWM_Item loop
         Expect
           ("safe " & Item'Image, Safe_Outputs (Item),
            (case Item is
                when URV.Buffers.Throttle => 0,
                when URV.Buffers.Brake    => 16#FFF#,
                when Discretes            => 0,
                when others               => 16#800#));
         Expect ("neutral " & Item'Image, Output (Item), Safe_Outputs (Item));
         Expect
           ("on the board, " & Item'Image,
            URV.PWM_Layout.Safe_Area (URV.PWM_Layout.Channel_Of (Item)),
            Safe_Outputs (Item));
      end loop;
      Expect_Number ("channels of the board", Data_Area'Length, 16);
      for Unused in Channel_Number range 15 .. 16 loop
         Expect
           ("unused channel" & Unused'Image,
            URV.PWM_Layout.Safe_Area (Unused), 16#800#);
      end loop;
   end Neutral_All;

   procedure Each_Command is
      Input : Uplink_Buffer;
   begin
      Expect_Outputs ("all different", Commands, 16#800#, 0);
      for Item in Uplink_Item range Roll .. Brake loop
         for Value in Word range 0 .. 16#FFF# loop
            Input := Commands;
            Input (Item) := Value;
            Expect_Outputs
              (Item'Image & " at" & Value'Image, Input, 16#800#, 0);
         end loop;
      end loop;
   end Each_Command;

   procedure Every_Switch is
      Input : Uplink_Buffer := Commands;
   begin
      --  All 256 positions of the eight switches.
      for Bits in Word range 0 .. 255 loop
         for Switch in Switch_Item loop
            Input (Switch) :=
              (if Bits / 2 ** (Switch_Item'Pos (Switch)
                               - Switch_Item'Pos (Switch_1)) mod 2 = 1
               then 16#FFF# else 0);
         end loop;
         Expect_Outputs
           ("switches" & Bits'Image, Input,
            (if Bits >= 128 then 16#FFF# else 16#800#), Bits);
      end loop;
   end Every_Switch;

   procedure Threshold is
      type Row is record
         Value : Word;
         Is_On : Boolean;
      end record;

      Table : constant array (Positive range <>) of Row :=
        ((0, False), (1, False), (16#7FF#, False), (16#800#, True),
         (16#801#, True), (16#FFF#, True), (16#1000#, True),
         (16#8000#, True), (16#FFFF#, True));

      Input : Uplink_Buffer;
   begin
      for Each of Table loop
         for Switch in Switch_Item loop
            Input := Commands;
            Input (Switch) := Each.Value;
            Expect_Outputs
              (Switch'Image & " at" & Each.Value'Image, Input,
               (if Switch = Switch_8 and Each.Is_On
                then 16#FFF# else 16#800#),
               (if Each.Is_On
                then 2 ** (Switch_Item'Pos (Switch) - 5) else 0));
         end loop;
      end loop;
   end Threshold;

   procedure Too_Large is
      type Values is array (Positive range <>) of Word;
      Table : constant Values :=
        (16#1000#, 16#1001#, 16#7FFF#, 16#8000#, 16#F000#, 16#FFFF#);
      Input : Uplink_Buffer;
   begin
      for Value of Table loop
         for Item in Uplink_Item range Roll .. Brake loop
            Input := Commands;
            Input (Item) := Value;
            Expect_Outputs
              (Item'Image & " at" & Value'Image, Input, 16#800#, 0);
         end loop;
      end loop;
   end Too_Large;

   procedure Error_Word is
      Input : Uplink_Buffer := Commands;
   begin
      Input (Error_Status) := 16#FFFF#;
      Expect_Outputs ("error word set", Input, 16#800#, 0);
   end Error_Word;

   procedure Read_Back is
      Area    : Data_Area;
      Outputs : PWM_Buffer;
   begin
      for Number in Channel_Number loop
         Area (Number) := Word (Number) * 16#101#;
      end loop;
      Outputs := To_Outputs (Area);
      for Item in PWM_Item loop
         Expect
           (Item'Image, Outputs (Item),
            Word (PWM_Item'Pos (Item) + 1) * 16#101#);
      end loop;
   end Read_Back;

   procedure The_Task is
      Area : Data_Area;
   begin
      Variable.Reset;
      Errors.Clear;
      Board.Write (Foreign);
      Up.Give (Variable, Commands);
      PWM.Run_Transaction;
      Up.Expect_Counts ("received", Variable, 1, 1);
      Area := Board.Contents;
      for Item in PWM_Item loop
         Expect
           (Item'Image, Area (Channel_Of (Item)),
            Transform (Commands) (Item));
         Expect_Number
           ("channel of " & Item'Image, Integer (Channel_Of (Item)),
            PWM_Item'Pos (Item) + 1);
      end loop;
      Expect ("unused channel 15", Area (15), 16#800#);
      Expect ("unused channel 16", Area (16), 16#800#);
      Expect_Errors ("new commands", Errors, None);

      Board.Write (Foreign);
      PWM.Run_Transaction;
      Expect
        ("left alone without new commands", Board.Contents = Foreign, True);
      Expect_Errors ("without new commands", Errors, (1 => No_Commands));
   end The_Task;

   procedure Hold_Timer is
      Words : Data_Area;

      procedure Tick (Ticks : Natural);

      procedure Tick (Ticks : Natural) is
      begin
         for Tick in 1 .. Ticks loop
            Board.Tick;
         end loop;
      end Tick;
   begin
      Expect_Number
        ("half a second", Hold_Ticks * URVOS.Frames.Microseconds_Per_Tick,
         500_000);
      Variable.Reset;
      Errors.Clear;
      for Brake_Word in Word range 0 .. 1 loop
         Words := Foreign;
         Words (Channel_Of (Brake)) := Brake_Word * 16#FFF#;
         Board.Write (Words);
         Tick (Hold_Ticks - 1);
         Expect ("not before 0.5 s", Board.Contents = Words, True);
         Expect ("attended", Board.Is_Unattended, False);

         --  The task runs, without commands.
         PWM.Run_Transaction;
         Tick (Hold_Ticks - 1);
         Expect ("not while the task runs", Board.Contents = Words, True);
         Tick (1);
         for Item in PWM_Item loop
            Expect
              (Item'Image, Board.Contents (Channel_Of (Item)),
               (if Item = Brake then Brake_Word * 16#FFF#
                else Safe_Outputs (Item)));
         end loop;
         Words := Board.Contents;
         Tick (4 * Hold_Ticks);
         Expect ("unattended", Board.Is_Unattended, True);
         PWM.Run_Transaction;
         Expect ("attended again", Board.Is_Unattended, False);
         Expect ("it stays so", Board.Contents = Words, True);
         Up.Give (Variable, Commands);
         PWM.Run_Transaction;
         Expect
           ("until commands come",
            Board.Contents = To_Data_Area (Transform (Commands)), True);
      end loop;

      --  From power up
      declare
         New_Board : URV.PWM_Boards.Board;
      begin
         for Tick in 1 .. 4 * Hold_Ticks loop
            New_Board.Tick;
         end loop;
         Expect ("without a first write", New_Board.Contents = Safe_Area,
                 True);
      end;
   end Hold_Timer;

   procedure Marked_Commands is
      Item : Uplink_Buffer := (others => 16#FFF#);
   begin
      --  All words differ from the present ones, with switches on.
      Variable.Reset;
      Errors.Clear;
      for Error in Word range 0 .. 16#1F# loop
         Board.Write (Foreign);
         Item (Error_Status) := Error;
         Up.Give (Variable, Item);
         PWM.Run_Transaction;
         if Error mod 2 = 1 then
            Expect
              ("old ones move nothing", Board.Contents = Foreign, True);
         else
            Expect
              ("fresh ones do",
               Board.Contents = To_Data_Area (Transform (Item)), True);
         end if;
         Expect_Errors ("new commands, marked or not", Errors, None);
      end loop;
   end Marked_Commands;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "PWM-1 without new commands the board is left alone",
         The_Task'Access);
      Add
        (Suite, "SAF-3 D-14 commands that are marked as old move nothing",
         Marked_Commands'Access);
      Add (Suite, "SAF-11 without a controller the outputs are safe in 0.5 s",
           Hold_Timer'Access);
      Add
        (Suite, "SAF-1 D-13 neutral commands are the safe outputs",
         Neutral_All'Access);
      Add
        (Suite, "PWM-2 D-2 each servo follows its command and no other",
         Each_Command'Access);
      Add
        (Suite, "D-10 switch n is bit n - 1, switch 8 sets the flaps too",
         Every_Switch'Access);
      Add (Suite, "D-8 a switch is on from 0800h upward", Threshold'Access);
      Add
        (Suite, "D-11 a word above 0FFFh drives its servos to 0FFFh",
         Too_Large'Access);
      Add
        (Suite, "PWM-2 each output is read from its channel",
         Read_Back'Access);
      Add (Suite, "PWM-2 the error word reaches no servo", Error_Word'Access);
   end Add_To;

end PWM_Tests;
