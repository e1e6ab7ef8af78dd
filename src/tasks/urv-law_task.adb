--  SPDX-License-Identifier: Apache-2.0

with URVOS;        use URVOS;
with URV.Allocation; use URV.Allocation;
with URV.Buffers;  use URV.Buffers;
with URV.Configurations; use URV.Configurations;
with URV.Engine_Monitor;
with URV.Errors;   use URV.Errors;
with URV.Law_Units; use URV.Law_Units;
with URV.Laws;     use URV.Laws;
with URV.Link_Loss; use URV.Link_Loss;
with URV.Routing;
with URV.Sensor_Checks; use URV.Sensor_Checks;
with URV.Surface_Monitor; use URV.Surface_Monitor;
with URV.Surfaces; use URV.Surfaces;

package body URV.LAW_Task with SPARK_Mode is

   --  What has changed is worth a line in the log.
   procedure Report (Before, After : Memory)
   with Global => (In_Out => Errors);

   procedure Report (Before, After : Memory) is
   begin
      if After.Link.State /= Before.Link.State
        and then Before.Link.State /= Waiting
      then
         Errors.Report
           (Link_Loss_State, Word (Link_State'Pos (After.Link.State)));
      end if;

      for Sensor in Sensor_Item loop
         if Before.Checks (Sensor).Is_Valid
           and then not After.Checks (Sensor).Is_Valid
         then
            Errors.Report
              (Sensor_Not_Valid, Word (Sensor_Item'Pos (Sensor) + 1));
         end if;
      end loop;
   end Report;

   --  The engine is looked at, whose throttle was given Power.
   function Engine_After
     (Item   : Engine_Monitor.Monitor;
      Power  : Lever;
      Checks : Check_Table;
      Is_Old : Boolean) return Engine_Monitor.Monitor
   is
     (Engine_Monitor.Next
        (Item, Power,
         Speed    => Level_Of (Word_Of (Checks, RPM)),
         Airspeed => Level_Of (Word_Of (Checks, Airspeed)),
         Is_Known => not Is_Old
           and then Checks (RPM).Is_Valid
           and then Checks (Airspeed).Is_Valid))
   with Global => null;

   --  Watches the surfaces and the engine, whose servos will be given what the
   --  PWM task makes of the commands.
   procedure Watch_Surfaces
     (Sensors  : Downlink_Buffer;
      Checks   : Check_Table;
      Commands : Uplink_Buffer;
      By_Law   : Boolean)
   with Global => (In_Out => (Surface_Memory, Surface_Health, Errors));

   procedure Watch_Surfaces
     (Sensors  : Downlink_Buffer;
      Checks   : Check_Table;
      Commands : Uplink_Buffer;
      By_Law   : Boolean)
   is
      Before  : constant Monitor := Surface_Memory.Contents;
      Watched : constant Monitor := Surface_Monitor.Next (Before, Sensors);
      Now     : constant Health  :=
        Told_Of
          ((Failed => Watched.Failed, Places => Watched.Places), By_Law);
      Engine  : constant Engine_Monitor.Monitor :=
        Engine_After
          (Before.Engine, Before.Power, Checks, Routing.Is_Old (Sensors));
   begin
      for Item in Surface loop
         if Watched.Failed (Item) and then not Before.Failed (Item) then
            Errors.Report
              (Surface_Failed,
               Word (Sensor_Item'Pos (Sensor_Of (Item)) + 1));
         end if;
      end loop;
      if Engine.Failed and then not Before.Engine.Failed then
         Errors.Report (Surface_Failed, Word (Sensor_Item'Pos (RPM) + 1));
      end if;
      Surface_Health.Write (Now);
      Surface_Memory.Write
        (With_Engine
           ((if Routing.Is_Old (Commands) then With_None_Sent (Watched)
             else With_Sent (Watched, Demands_Of (Servos (Commands, Now)))),
            Engine,
            (if Routing.Is_Old (Commands) then Before.Power
             else Level_Of (Commands (Throttle)))));
   end Watch_Surfaces;

   --  A configuration that has come is taken or refused.
   procedure Take_Configuration (Flown : Memory)
   with
     Global =>
       (Input  => Law_Settings,
        In_Out => (Configuration_Variable, Law_Configured, Errors));

   procedure Take_Configuration (Flown : Memory) is
      Set   : constant Settings := Law_Settings.Contents;
      Now   : constant Setting  := Law_Configured.Contents;
      Block : Uplink_Buffer;
      Fresh : Boolean;
      What  : Answer;
   begin
      Configuration_Variable.Receive (Block, Fresh);
      if Fresh then
         What := Answer_To (Block, Set, Flown);
         if What in Refused then
            Errors.Report
              (Configuration_Refused, Word (Answer'Pos (What)));
         else
            Law_Configured.Write
              (Configurations.After (Now, Block, Set, Flown));
         end if;
      end if;
   end Take_Configuration;

   --  What the laws fly with.
   procedure Look_Up (Set : out Settings)
   with Global => (Input => (Law_Settings, Law_Configured));

   procedure Look_Up (Set : out Settings) is
      Usual : constant Settings := Law_Settings.Contents;
      Now   : constant Setting  := Law_Configured.Contents;
   begin
      Set := In_Force (Usual, Now);
   end Look_Up;

   procedure Run_Transaction is
      Set      : Settings;
      Before   : constant Memory   := Law_Memory.Contents;
      After    : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      Fresh    : Boolean;
      Success  : Boolean;
   begin
      Take_Configuration (Before);
      Look_Up (Set);
      Sensors_Variable.Receive (Sensors, Fresh);
      if not Fresh then
         Sensors := Routing.As_Old (Sensors);
         if Set.On then
            Errors.Report (No_Image, No_Image_For_Laws);
         end if;
      end if;

      Commands_Variable.Receive (Commands, Fresh);
      if Set.On then
         if not Fresh then
            Commands := Routing.As_Old (Commands);
            Errors.Report (No_Commands, 0);
         end if;
         After := Next (Before, Commands, Sensors, Set.By, Set.Table);
         Report (Before, After);
         Law_Memory.Write (After);
         Commands := Output (After, Commands);
         Watch_Surfaces
           (Sensors, After.Checks, Commands, not Is_All_Stick (After));
      else
         Surface_Health.Write (All_Well);
      end if;

      if Set.On or else Fresh then
         PWM_Variable.Send (Commands, Success);
         if not Success then
            Errors.Report (Commands_Not_Consumed, 0);
         end if;
      end if;
   end Run_Transaction;

end URV.LAW_Task;
