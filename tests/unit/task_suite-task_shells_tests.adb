--  SPDX-License-Identifier: Apache-2.0

with Checks;              use Checks;
with Devices.PWM_Board;   use Devices.PWM_Board;
with Expectations;        use Expectations;
with GSC;
with Law_Rig;             use Law_Rig;
with MCS;
with Task_Rig;            use Task_Rig;
with URVOS;               use URVOS;
with URV.Allocation;      use URV.Allocation;
with URV.Buffers;         use URV.Buffers;
with URV.Configurations;  use URV.Configurations;
with URV.Errors;          use URV.Errors;
with URV.LAW_Steps;       use URV.LAW_Steps;
with URV.Laws;            use URV.Laws;
with URV.Log_Pieces;      use URV.Log_Pieces;
with URV.PWM_Layout;
with URV.PWM_Transform;   use URV.PWM_Transform;
with URV.Routing;         use URV.Routing;
with URV.Spare_Bits; use URV.Spare_Bits;
with URV.Surface_Monitor; use URV.Surface_Monitor;
with URV.Surfaces;        use URV.Surfaces;
with URV.Test_Inputs;     use type URV.Test_Inputs.Increments;
with URV.Test_Runs;       use type URV.Test_Runs.Aboard;

separate (Task_Suite)
package body Task_Shells_Tests is

   --  The tests, in order.
   procedure MDCIN_Keeps_Commands;
   procedure GDCIN_Keeps_Sensors;
   procedure MDCOUT_Gives_Sensors;
   procedure LAW_Does_As_Decided;
   procedure PWM_Uses_The_Health;

   --  Clears both nodes' variables, logs and status.
   procedure Clear;

   procedure Clear is
   begin
      MCS.Reset_Variables;
      MCS.Law_Settings.Write (Laws_Off);
      MCS.Errors.Clear;
      MCS.Status.Write (No_Error);
      MCS.Log_Sender.Progress.Write ((others => <>));
      GSC.Reset_Variables;
      GSC.Errors.Clear;
      GSC.Status.Write (No_Error);
      GSC.Log_Receiver.Incoming.Write ((others => <>));
   end Clear;

   --  MDCIN

   procedure MDCIN_Keeps_Commands is
      Other : constant Uplink_Buffer :=
        (Uplink_Of (16#F000#) with delta
           Roll => 16#600#, Error_Status => Other_Kind);

      --  Expects that a block of another kind comes and these commands are
      --  passed on.
      procedure Expect_Kept (What : String; Kept : Uplink_Buffer);

      procedure Expect_Kept (What : String; Kept : Uplink_Buffer) is
      begin
         Up.Give (MCS.TELIN_Variable, Other);
         MCS.MDCIN.Run_Transaction;
         Expect_Buffer
           (What & ", CORE", Up.Taken ("to CORE", MCS.Uplink_Variable),
            As_Old (Kept));
         Expect_Buffer
           (What & ", laws", Up.Taken ("to LAW", MCS.Commands_Variable),
            As_Old (Kept));
      end Expect_Kept;

      Unused : Uplink_Buffer;
   begin
      Clear;
      Expect_Kept ("nothing yet", Neutral_Uplink);
      Up.Give (MCS.TELIN_Variable, Uplink_Of (16#100#));
      MCS.MDCIN.Run_Transaction;
      Unused := Up.Taken ("commands", MCS.Uplink_Variable);
      Unused := Up.Taken ("commands", MCS.Commands_Variable);

      --  Other uses of the variables do not change the task's own message.
      Up.Give (MCS.Uplink_Variable, Uplink_Of (16#700#));
      Unused := Up.Taken ("a stranger's", MCS.Uplink_Variable);
      Expect_Kept ("another kind", Uplink_Of (16#100#));
      Expect_Kept ("again", Uplink_Of (16#100#));
      MCS.Restart_Variables;
      Expect_Kept ("after a warm start", Uplink_Of (16#100#));
      MCS.Reset_Variables;
      Expect_Kept ("after a cold start", Neutral_Uplink);
   end MDCIN_Keeps_Commands;

   --  GDCIN

   procedure GDCIN_Keeps_Sensors is
      Other : constant Downlink_Buffer :=
        (Downlink_Of (16#300#) with delta Error_Status => 16#0050#);
      First : constant Downlink_Buffer :=
        (Downlink_Of (16#100#) with delta Error_Status => 16#1074#);

      procedure Expect_Kept (What : String; Kept : Downlink_Buffer);

      procedure Expect_Kept (What : String; Kept : Downlink_Buffer) is
      begin
         Down.Give (GSC.TELIN_Variable, Other);
         GSC.GDCIN.Run_Transaction;
         Expect_Buffer
           (What, Framed.Taken (What, GSC.Downlink_Variable).Words,
            As_Old (Kept));
         Expect_Errors
           (What, GSC.Errors, (1 => Unknown_Code), Detail => 16#500#);
      end Expect_Kept;

      Unused : Downlink_Buffer;
   begin
      Clear;
      Expect_Kept ("nothing yet", Neutral_Downlink);
      Down.Give (GSC.TELIN_Variable, First);
      GSC.GDCIN.Run_Transaction;
      Unused := Framed.Taken ("sensors", GSC.Downlink_Variable).Words;
      Framed.Give (GSC.Downlink_Variable, Framed_Of (16#700#));
      Unused := Framed.Taken ("a stranger's", GSC.Downlink_Variable).Words;

      --  Its fragment of the log is neither kept with it nor taken again.
      Expect_Kept
        ("another kind", (First with delta Error_Status => 16#4#));
      Expect
        ("one fragment", Word (GSC.Log_Receiver.Incoming.Contents.Got), 1);
      GSC.Restart_Variables;
      Expect_Kept
        ("after a warm start", (First with delta Error_Status => 16#4#));
      GSC.Reset_Variables;
      Expect_Kept ("after a cold start", Neutral_Downlink);
   end GDCIN_Keeps_Sensors;

   --  MDCOUT

   procedure MDCOUT_Gives_Sensors is
      Item : Downlink_Buffer;
   begin
      Clear;
      MCS.Errors.Report (No_Input, 0);
      MCS.Status.Write (16#8#);
      for Frame in 1 .. 2 loop
         if Frame = 1 then
            Images.Give (MCS.AD_Variable, Image_Of (16#100#, Error => 16#4#));
         end if;
         MCS.MDCOUT.Run_Transaction (Now => 0);
         Item := Framed.Taken ("to CORE", MCS.Downlink_Variable).Words;
         Expect ("sensors", Item (Altitude), Downlink_Of (16#100#) (Altitude));
         Expect
           ("flags", Item (Error_Status),
            (if Frame = 1 then 16#C# else 16#C# or Stale_Data));
         Expect_Buffer
           ("the laws have what CORE has",
            Down.Taken ("to LAW", MCS.Sensors_Variable), Item);
         Item (Error_Status) := With_Piece
           (Item (Error_Status), (if Frame = 1 then 16#107# else 16#200#));
         Expect_Buffer
           ("down, with a fragment",
            Sensors_In (Down.Taken ("to TELOUT", MCS.TELOUT_Variable)), Item);
      end loop;
   end MDCOUT_Gives_Sensors;

   --  LAW

   procedure LAW_Does_As_Decided is
      Block : constant Uplink_Buffer := Block_Of
        ((Serial => 5, Gains => 1, Orbit_From => 20, End_From => 90));
      Sticks_Off : constant Uplink_Buffer :=
        (Sticks with delta Roll => 1_111, Switch_2 => 16#FFF#);
      Banked : constant Downlink_Buffer :=
        (Level with delta Roll_Attitude => 2_400, Left_Aileron => 3_000);

      procedure Expect_Reported
        (What : String; Kind : Error_Kind; Is_There : Boolean; Detail : Word);

      procedure Expect_Reported
        (What : String; Kind : Error_Kind; Is_There : Boolean; Detail : Word)
      is
         Found : constant Logs.History :=
           Logs.History_Of (MCS.Errors.Contents, Kind);
      begin
         Expect
           (What & ": " & Kind'Image, Found.Occurrences,
            (if Is_There then 1 else 0));
         Expect
           (What & ": detail of " & Kind'Image, Found.Last_Detail,
            (if Is_There then Detail else 0));
      end Expect_Reported;

      --  Runs one frame with these inputs.
      procedure Expect_As_Decided
        (On, Has_Block, Has_Sensors, Has_Commands : Boolean);

      procedure Expect_As_Decided
        (On, Has_Block, Has_Sensors, Has_Commands : Boolean)
      is
         What   : constant String :=
           "laws " & On'Image & ", block " & Has_Block'Image & ", sensors "
           & Has_Sensors'Image & ", commands " & Has_Commands'Image;
         Usual  : constant Settings := (Laws_Off with delta On => On);
         Memory : Kept;
         Result : Decision;
         Item   : Uplink_Buffer;
         Fresh  : Boolean;
      begin
         Clear;
         Fly (60, Level);
         MCS.Law_Settings.Write (Usual);
         MCS.Errors.Clear;
         Memory := MCS.Law_Memory.Contents;
         Up.Give (MCS.Configuration_Variable, Block);
         Down.Give (MCS.Sensors_Variable, Banked);
         Up.Give (MCS.Commands_Variable, Sticks_Off);
         if not Has_Block then
            Item := Up.Taken ("block", MCS.Configuration_Variable);
         end if;
         if not Has_Sensors then
            Expect
              ("sensors",
               Down.Taken ("sensors", MCS.Sensors_Variable) (Altitude),
               2_000);
         end if;
         if not Has_Commands then
            Item := Up.Taken ("commands", MCS.Commands_Variable);
         end if;
         Decide
           (Memory, Usual,
            (Block, Has_Block, Banked, Has_Sensors, Sticks_Off,
             Has_Commands),
            Result);
         MCS.LAW.Run_Transaction;

         Expect
           (What & ": memory",
            MCS.Law_Memory.Contents.Flown = Memory.Flown, True);
         Expect
           (What & ": configuration",
            MCS.Law_Memory.Contents.Set = Memory.Set, True);
         Expect
           (What & ": configuration is taken",
            MCS.Law_Memory.Contents.Set.Is_Set, On and Has_Block);
         Expect
           (What & ": surfaces",
            MCS.Law_Memory.Contents.Watched = Memory.Watched, True);
         Expect
           (What & ": health",
            MCS.Surface_Health.Contents = Result.Reported, True);
         Expect
           (What & ": cards",
            MCS.Law_Memory.Contents.Cards = Memory.Cards, True);
         Expect
           (What & ": inputs", MCS.Test_Added.Contents = Result.Added, True);
         MCS.PWM_Variable.Look (Item, Fresh);
         Expect (What & ": sent", Fresh, On or Has_Commands);
         Expect (What & ": as decided", Fresh, Result.Flown.Is_Sent);
         if Fresh then
            Expect_Buffer (What & ": message", Item, Result.Flown.Message);
         end if;
         Expect_Reported
           (What, Configuration_Refused, not On and Has_Block,
            Answer'Pos (No_Laws));
         Expect_Reported
           (What, No_Image, On and not Has_Sensors, No_Image_For_Laws);
         Expect_Reported (What, No_Commands, On and not Has_Commands, 0);
      end Expect_As_Decided;
   begin
      for On in Boolean loop
         for Has_Block in Boolean loop
            for Has_Sensors in Boolean loop
               for Has_Commands in Boolean loop
                  Expect_As_Decided
                    (On, Has_Block, Has_Sensors, Has_Commands);
               end loop;
            end loop;
         end loop;
      end loop;
   end LAW_Does_As_Decided;

   --  PWM

   procedure PWM_Uses_The_Health is
      Reported : constant Health :=
        (Failed => (URV.Surfaces.None with delta Left_Aileron => True),
         Places => (Left_Aileron => 500, others => 0));
   begin
      for Is_Well in Boolean loop
         Clear;
         MCS.Surface_Health.Write (if Is_Well then All_Well else Reported);
         Up.Give (MCS.PWM_Variable, Sticks);
         MCS.PWM.Run_Transaction;
         Expect
           ("well " & Is_Well'Image,
            MCS.PWM_Board.Contents =
              URV.PWM_Layout.To_Data_Area
                (if Is_Well then Transform (Sticks)
                 else Servos (Sticks, Reported)),
            True);
      end loop;
      Expect
        ("that makes a difference",
         Transform (Sticks) = Servos (Sticks, Reported), False);
   end PWM_Uses_The_Health;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "MDI-1 SET-2 MDCIN keeps its last output until a cold start",
         MDCIN_Keeps_Commands'Access);
      Add
        (Suite, "GDI-1 SET-2 GDCIN keeps its last output until a cold start",
         GDCIN_Keeps_Sensors'Access);
      Add
        (Suite, "MDO-1 SET-2 the laws have CORE's sensors, TELOUT the log's",
         MDCOUT_Gives_Sensors'Access);
      Add
        (Suite, "EXT-3 SET-2 LAW writes, sends and reports as decided",
         LAW_Does_As_Decided'Access);
      Add
        (Suite, "EXT-6 SET-2 PWM makes the words with the surfaces' health",
         PWM_Uses_The_Health'Access);
   end Add_To;

end Task_Shells_Tests;
