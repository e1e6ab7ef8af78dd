--  SPDX-License-Identifier: Apache-2.0

with Devices.AD_Board;
with Expectations; use Expectations;
with GSC.Virtual_Time;
with MCS.Virtual_Time;
with Host.Memory_Hardware;

package body Node_Rig is

   --  The lag of the aircraft's clock.
   Lag : constant Clock_Tick := 3;

   --  Makes all conversions that a node requests.
   procedure Convert;

   --  A character time of the line.
   procedure Exchange_Character;

   function Numbered (First : Word) return Channel_Words is
   begin
      return Result : Channel_Words do
         for Number in Channel loop
            Result (Number) := First + Word (Number);
         end loop;
      end return;
   end Numbered;

   function CORE_Of (Node : Station) return Memory is
     (case Node is
         when Ground   => GSC.CORE_Memory.Contents,
         when Aircraft => MCS.CORE_Memory.Contents);

   function Log_Of (Node : Station) return Error_Log is
     (case Node is
         when Ground   => GSC.Errors.Contents,
         when Aircraft => MCS.Errors.Contents);

   procedure Switch_On (Processors : Processor_Number := 1) is
   begin
      Host.Memory_Hardware.Repair (1);
      Host.Memory_Hardware.Repair (2);
      Now         := 0;
      Link_Is_Cut := False;
      MCS_Stalls  := False;
      Console     := (others => 16#800#);
      Sensors     := (others => 16#800#);
      for Switch in Switch_Item loop
         Console (Channel (Switch_Item'Pos (Switch))) := 0;
      end loop;
      GSC.Virtual_Time.Start (Starts.Cold_Start, 0);
      GSC.Telemetry_Board.Start;
      MCS.Virtual_Time.Start (Starts.Cold_Start, 0, Processors);
      MCS.Telemetry_Board.Start;
   end Switch_On;

   function Clock_Of (Node : Station) return Clock_Tick is
     (case Node is
         when Ground   => Now,
         when Aircraft => Tick'Max (Now, Lag) - Lag);

   procedure Start_Again
     (Node : Station; Condition : Starts.Start_Condition)
   is
      use type Starts.Start_Condition;
   begin
      case Node is
         when Ground =>
            if Condition = Starts.Warm_Reset then
               GSC.Telemetry_Board.Start;
            end if;
            GSC.Virtual_Time.Start (Condition, Clock_Of (Ground));
         when Aircraft =>
            if Condition = Starts.Warm_Reset then
               MCS.Telemetry_Board.Start;
            end if;
            MCS.Virtual_Time.Start (Condition, Clock_Of (Aircraft));
      end case;
   end Start_Again;

   procedure Convert is
      Wanted    : Boolean;
      Interrupt : Boolean;
      Number    : Devices.AD_Board.Channel_Number;
   begin
      loop
         GSC.AD_Board.Take_Start (Wanted, Number);
         exit when not Wanted;
         GSC.AD_Board.Finish (Console (Channel (Number)), Interrupt);
         if Interrupt then
            GSC.ADINT.Handle_Interrupt;
         end if;
      end loop;
      while not MCS_Stalls loop
         MCS.AD_Board.Take_Start (Wanted, Number);
         exit when not Wanted;
         MCS.AD_Board.Finish (Sensors (Channel (Number)), Interrupt);
         if Interrupt then
            MCS.ADINT.Handle_Interrupt;
         end if;
      end loop;
   end Convert;

   procedure Exchange_Character is
      Up, Down           : Byte;
      Up_Sent, Down_Sent : Boolean;
      Unused_Time        : Telemetry.Character_Times;
      Unused_Flag        : Boolean;
   begin
      GSC.Telemetry_Board.Next_Character (1, Up_Sent, Up, Unused_Time);
      MCS.Telemetry_Board.Next_Character (1, Down_Sent, Down, Unused_Time);
      Silence := (if Up_Sent or Down_Sent then 0 else Silence + 1);
      if Up_Sent and not Link_Is_Cut then
         MCS.Telemetry_Board.Accept_Character (0, Up, False, Unused_Flag);
      end if;
      if Down_Sent and not Link_Is_Cut then
         GSC.Telemetry_Board.Accept_Character (0, Down, False, Unused_Flag);
      end if;
   end Exchange_Character;

   procedure Clock_Tick_Of_Both is
      Characters : constant :=
        Microseconds_Per_Tick / Telemetry.Microseconds_Per_Character;
   begin
      Now := Advanced (Now);
      GSC.Virtual_Time.Clock_Interrupt (Now);
      if Now >= Lag then
         MCS.Virtual_Time.Clock_Interrupt (Now - Lag);
      end if;
      Convert;
      for Time in 1 .. Characters loop
         Exchange_Character;
      end loop;
   end Clock_Tick_Of_Both;

   procedure Fly (Frames : Positive) is
   begin
      for Ticks in 1 .. Ticks_Per_Major_Frame * Frames loop
         Clock_Tick_Of_Both;
      end loop;
   end Fly;

   procedure Expect_Commands (What : String; First, Error : Word) is
      Ground   : constant Memory := CORE_Of_GSC;
      Aircraft : constant Memory := CORE_Of_MCS;
      Expected : Word;
   begin
      for Item in Uplink_Item loop
         Expected :=
           (if Item = Error_Status then Error
            else First + Word (Uplink_Item'Pos (Item)));
         Expect
           (What & ", GSC CORE " & Item'Image, Ground.Uplink (Item),
            Expected);
         Expect
           (What & ", MCS CORE " & Item'Image, Aircraft.Uplink (Item),
            Expected);
      end loop;
   end Expect_Commands;

   procedure Expect_Sensors (What : String; First, Error : Word) is
      Ground   : constant Memory := CORE_Of_GSC;
      Aircraft : constant Memory := CORE_Of_MCS;
      Expected : Word;
   begin
      for Item in Downlink_Item loop
         Expected :=
           (if Item = Error_Status then Error
            else First + Word (Downlink_Item'Pos (Item)));
         Expect
           (What & ", MCS CORE " & Item'Image,
            Aircraft.Downlink (Item), Expected);
         Expect
           (What & ", GSC CORE " & Item'Image, Ground.Downlink (Item),
            Expected);
      end loop;
   end Expect_Sensors;

end Node_Rig;
