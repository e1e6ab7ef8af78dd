--  SPDX-License-Identifier: Apache-2.0

with Checks;             use Checks;
with Expectations;       use Expectations;
with Law_Rig;            use Law_Rig;
with MCS;
with Task_Rig;           use Task_Rig;
with URVOS;              use URVOS;
with URV.Allocation;     use URV.Allocation;
with URV.Buffers;        use URV.Buffers;
with URV.Card_Blocks;
with URV.Configurations;
with URV.Errors;         use URV.Errors;
with URV.Frame_Times;    use URV.Frame_Times;
with URV.Law_Inputs;
with URV.LAW_Steps;      use URV.LAW_Steps;
with URV.Laws;           use URV.Laws;
with URV.Link_Loss;      use URV.Link_Loss;
with URV.PWM_Transform;  use URV.PWM_Transform;
with URV.Sensor_Checks;  use URV.Sensor_Checks;
with URV.Surface_Monitor;
with URV.Surfaces;       use type URV.Surfaces.Surface_Demands;
with URV.Test_Cards;     use URV.Test_Cards;
with URV.Test_Inputs;    use URV.Test_Inputs;
with URV.Test_Runs;      use URV.Test_Runs;

separate (Law_Suite)
package body LAW_Task_Tests is

   --  The tests, in order.
   procedure Sensor_Told_Once;
   procedure Not_Consumed;
   procedure Surface_Told_By_Sensor;
   procedure End_Of_Card_Told;
   procedure Input_Withdrawn;
   procedure Engine_Needs_Both;
   procedure Words_As_Sent;
   procedure Configured_At_Once;

   --  A doublet in slot 3, 0.1 s to either side, without limits.
   Free_Card : constant Card :=
     (Doublet_Card with delta
        Head     => 3 * 256 + Card_Kind'Pos (Doublet),
        Time     => 10,
        Attitude => 63 + 64 * 63,
        Airflow  => 63 + 64 * 63,
        Slowest  => 0,
        Fastest  => 4_095,
        Lowest   => 0);

   Stick_Card : constant Card :=
     (Free_Card with delta Surfaces => Stick_Place + 4);

   Switched : constant Uplink_Buffer :=
     (Sticks with delta Switch_5 => On_Word);

   Laws_On : constant Settings := (Laws_Off with delta On => True);

   --  All messages came in this frame except a block.
   Usual_Inputs : constant Inputs :=
     (Block        => Neutral_Uplink,
      Has_Block    => False,
      Sensors      => Level,
      Has_Sensors  => True,
      Commands     => Sticks,
      Has_Commands => True);

   --  The commands as they are.
   Usual_Flight : constant Flight :=
     (Message => Sticks,
      Is_Sent => True,
      By_Law  => False,
      By_Card => False,
      Sticks  => URV.Law_Inputs.No_Sticks);

   type Command_List is array (Positive range <>) of Uplink_Buffer;

   procedure Clear;

   procedure Clear is
   begin
      MCS.Reset_Variables;
      MCS.Law_Settings.Write (Laws_Off);
      MCS.Errors.Clear;
   end Clear;

   procedure Sensor_Told_Once is
   begin
      for Which in Sensor_Item loop
         Clear;
         Fly (100);
         Expect_Errors ("all is well", MCS.Errors, None);
         Fly (2, (Level with delta Which => Word'Last));
         Expect_Errors (Which'Image & ", two bad", MCS.Errors, None);
         Fly (1, (Level with delta Which => Word'Last));
         Expect_Errors
           (Which'Image & ", three", MCS.Errors, (1 => Sensor_Not_Valid),
            Detail => Word (Sensor_Item'Pos (Which) + 1));
         Fly (5, (Level with delta Which => Word'Last));
         Expect
           (Which'Image & ", more of them",
            Logs.History_Of (MCS.Errors.Contents, Sensor_Not_Valid)
              .Occurrences = 0,
            True);
      end loop;
   end Sensor_Told_Once;

   procedure Not_Consumed is
      Newer   : constant Uplink_Buffer :=
        (Neutral_Uplink with delta Throttle => 1_234);
      Success : Boolean;
      Item    : Uplink_Buffer;
      Fresh   : Boolean;
   begin
      Clear;
      for Commands of Command_List'(Neutral_Uplink, Newer) loop
         Expect_Errors ("so far", MCS.Errors, None);
         MCS.Commands_Variable.Send (Commands, Success);
         MCS.LAW.Run_Transaction;
      end loop;
      Expect_Errors
        ("nobody took the first", MCS.Errors, (1 => Commands_Not_Consumed));
      MCS.PWM_Variable.Receive (Item, Fresh);
      Expect ("the newer stands", Item (Throttle), 1_234);
   end Not_Consumed;

   procedure Surface_Told_By_Sensor is

      --  Expects that only the failure of this sensor's servo is told.
      procedure Expect_Told (Which : Sensor_Item; Value : Word);

      procedure Expect_Told (Which : Sensor_Item; Value : Word) is
      begin
         --  The bounds of a slow servo narrow.
         Clear;
         Fly (80 * Frames_Per_Tenth);
         Expect_Errors ("all is well", MCS.Errors, None);
         Fly
           (20 * Frames_Per_Tenth, (Level with delta Which => Value));
         Expect_Errors
           (Which'Image, MCS.Errors, (1 => Surface_Failed),
            Detail => Word (Sensor_Item'Pos (Which) + 1));
      end Expect_Told;

   begin
      for Which in URV.Surfaces.Surface loop
         Expect_Told
           (URV.Surfaces.Sensor_Of (Which), Neutral_Value + 150);
      end loop;
      Expect_Told (RPM, Level (RPM) - 500);
   end Surface_Told_By_Sensor;

   procedure End_Of_Card_Told is
      Success : Boolean;
   begin
      Clear;
      Fly (2 * Frames_Per_Second);
      MCS.Configuration_Variable.Send
        (URV.Card_Blocks.Block_Of (Free_Card), Success);
      Fly (1);
      Fly (3, Commands => Switched);
      Expect
        ("it runs", Word (MCS.Law_Memory.Cards.Running), 3);
      Expect_Errors ("so far", MCS.Errors, None);
      Fly (1);
      Expect_Errors
        ("slot and reason", MCS.Errors, (1 => Card_Ended),
         Detail => 3 * 16 + Verdict'Pos (Switched_Off));
   end End_Of_Card_Told;

   procedure Input_Withdrawn is

      --  The servos have the words of the last frame with commands that were
      --  not old.
      procedure Expect_Withdrawn (What : String; Source : Card);

      procedure Expect_Withdrawn (What : String; Source : Card) is
         Item   : Kept := At_Start;
         Words  : PWM_Buffer := Transform (Sticks);
         Moved  : Boolean := False;
         Result : Decision;

         procedure Fly_One (Got : Inputs);

         procedure Fly_One (Got : Inputs) is
         begin
            Decide (Item, Laws_On, Got, Result);
            if not Is_Old (Result.Flown.Message) then
               Words := With_Inputs
                 (Servos (Result.Flown.Message, Result.Reported),
                  Result.Added);
            end if;
         end Fly_One;

      begin
         for Frame in 1 .. 2 * Frames_Per_Second loop
            Fly_One (Usual_Inputs);
         end loop;
         Fly_One
           ((Usual_Inputs with delta
               Block     => URV.Card_Blocks.Block_Of (Source),
               Has_Block => True));
         Fly_One ((Usual_Inputs with delta Commands => Switched));
         Expect
           (What & " runs", Is_Running (Item.Cards.Run), True);

         --  The card ends in a gap of the commands.
         for Frame in 1 .. 4 * Frames_Per_Tenth loop
            Fly_One
              ((Usual_Inputs with delta
                  Commands => Switched, Has_Commands => False));
            Moved := Moved or else Words /= Transform (Switched);
         end loop;
         Expect (What & " has moved words", Moved, True);
         Expect
           (What & " is complete", Item.Cards.Run.Reason = Complete, True);
         Expect
           (What & ": still linked", Item.Flown.Link.State = Linked, True);
         Expect
           (What & ": no input remains at the servos",
            Words = Transform (Switched), True);
      end Expect_Withdrawn;

   begin
      Expect_Withdrawn ("at the servos", Free_Card);
      Expect_Withdrawn ("at the stick", Stick_Card);
   end Input_Withdrawn;

   procedure Engine_Needs_Both is

      --  Watches an engine that does not follow its throttle.
      procedure Expect_Told (What : String; Checks : Check_Table;
                             Is_Told : Boolean);

      procedure Expect_Told (What : String; Checks : Check_Table;
                             Is_Told : Boolean)
      is
         Watched : URV.Surface_Monitor.Monitor :=
           (Engine => (Has_Moved => True, others => <>),
            Power  => 4_095,
            others => <>);
         Unused_Reported : Health;
      begin
         for Frame in 1 .. 10 * Frames_Per_Second loop
            Watch
              (Watched, Checks,
               (Usual_Flight with delta
                  Message => (Sticks with delta Throttle => 4_095)),
               Nothing_Added, Usual_Inputs, Unused_Reported);
         end loop;
         Expect (What, Watched.Engine.Failed, Is_Told);
      end Expect_Told;

      Sound : constant Check_Table :=
        (for Item in Sensor_Item =>
           (Is_Valid => True,
            Used     => (if Item = RPM then 1_140 else Level (Item)),
            others   => <>));
   begin
      for Which in Sensor_Item loop
         Expect_Told
           ("without " & Which'Image,
            (Sound with delta
               Which => (Sound (Which) with delta Is_Valid => False)),
            Is_Told => Which not in RPM | Airspeed);
      end loop;
   end Engine_Needs_Both;

   procedure Words_As_Sent is
      use type URV.Surfaces.Surface;

      Got      : constant Inputs :=
        (Usual_Inputs with delta
           Sensors =>
             (Level with delta Left_Aileron => Neutral_Value + 600));
      Failed   : constant URV.Surfaces.Surface_Flags :=
        (for Which in URV.Surfaces.Surface =>
           Which = URV.Surfaces.Left_Aileron);
      Now      : constant Health :=
        (Failed => Failed, Places => URV.Surfaces.Places_Of (Got.Sensors));
      Alone    : constant PWM_Buffer := Transform (Sticks);
      Helped   : constant PWM_Buffer := Servos (Sticks, Now);
      Added    : constant Increments :=
        (Nothing_Added with delta Left_Elevator => 77);
      Watched  : URV.Surface_Monitor.Monitor;
      Reported : Health;
   begin
      --  The monitor takes the words that the servos get: with the help of
      --  other surfaces while a law flies, and without it otherwise.
      Expect ("help makes a difference", Alone = Helped, False);
      for By_Law in Boolean loop
         Watched := (Failed => Failed, others => <>);
         Watch
           (Watched, At_Start.Flown.Checks,
            (Usual_Flight with delta By_Law => By_Law), Added, Got,
            Reported);
         Expect
           ("reported by law " & By_Law'Image,
            Reported = (if By_Law then Now else All_Well), True);
         Expect
           ("words by law " & By_Law'Image,
            Watched.Sent = URV.Surfaces.Demands_Of
              (With_Inputs ((if By_Law then Helped else Alone), Added)),
            True);
      end loop;
   end Words_As_Sent;

   procedure Configured_At_Once is
      use URV.Configurations;
      Item   : Kept := At_Start;
      Result : Decision;
   begin
      --  On the ground the link is lost for two seconds. With the new times
      --  the frame that brings them leads to the next state.
      Item.Flown.Link :=
        (State  => Holding,
         Silent => 20 * Frames_Per_Tenth,
         others => 0);
      Decide
        (Item, Laws_On,
         (Usual_Inputs with delta
            Block        => Block_Of
              (Configuration'
                 (Serial     => 7,
                  Gains      => 0,
                  Orbit_From => 15,
                  End_From   => 3_000)),
            Has_Block    => True,
            Has_Commands => False),
         Result);
      Expect
        ("taken", Result.Reply = URV.Configurations.Taken, True);
      Expect
        ("in the same frame", Item.Flown.Link.State = Orbiting, True);
   end Configured_At_Once;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "EXT-3 an invalid sensor is reported once, by number",
         Sensor_Told_Once'Access);
      Add
        (Suite, "MBX-2 commands that PWM does not take are reported",
         Not_Consumed'Access);
      Add
        (Suite, "EXT-6 a failed servo is reported by its sensor's number",
         Surface_Told_By_Sensor'Access);
      Add
        (Suite, "FTI-5 the end of a card is reported by its own slot",
         End_Of_Card_Told'Access);
      Add
        (Suite, "FTI-5 an input returns to 0 in a gap of the commands",
         Input_Withdrawn'Access);
      Add
        (Suite, "EXT-6 an engine is judged by valid speeds only",
         Engine_Needs_Both'Access);
      Add
        (Suite, "EXT-6 the monitor has the words that the servos get",
         Words_As_Sent'Access);
      Add
        (Suite, "EXT-2 a configuration is used in the frame that brings it",
         Configured_At_Once'Access);
   end Add_To;

end LAW_Task_Tests;
