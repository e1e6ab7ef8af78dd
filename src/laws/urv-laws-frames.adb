--  SPDX-License-Identifier: Apache-2.0

with URV.Laws.Flying; use URV.Laws.Flying;

package body URV.Laws.Frames with SPARK_Mode is

   procedure Observe
     (This     : in out Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Seen     : out Observation)
   is
      Had_Height : constant Boolean := This.Checks (Altitude).Is_Valid;
      Height     : Level;
   begin
      Seen.Was := This.Flown;
      This.Link := Link_Loss.Next
        (This.Link, not Is_Old (Commands), Is_On (Commands (Switch_7)), By);
      if not Is_Old (Commands) then
         This.Heard := Commands;
      end if;
      Sensor_Checks.Advance (This.Checks, Sensors);
      Height := Level_Of (Word_Of (This.Checks, Altitude));
      if not Had_Height then
         This.Smoothed := Height * 1_000;
      end if;
      Seen.Rising := Climb_Rate (This.Smoothed, Height);
      This.Smoothed := Next_Smooth (This.Smoothed, Height);
      if This.Link.State not in Lost then
         This.Is_Flying := not Is_On_Ground (This.Checks);
      end if;

      --  The disconnect has priority over all else.
      This.Flown :=
        (if Is_Disconnected (Commands) then All_Direct
         else Allowed
           (Wanted (This.Link.State, This.Heard, This.Is_Flying),
            This.Checks));
   end Observe;

   procedure Steer
     (This     : in out Memory;
      Commands : Uplink_Buffer;
      Seen     : Observation;
      Sticks   : Stick_Inputs;
      Extra    : Command_Inputs;
      Table    : Table_Number := 0)
   is
      Input : Flying.Sticks;
   begin
      if Is_Disconnected (Commands) or else This.Link.State = Waiting then
         This.Is_Stick := (Axis => True);
         Input := Sticks_Of (This.Heard, Linked, Sticks);
      else
         Input := Sticks_Of (This.Heard, This.Link.State, Sticks);
      end if;
      Fly
        (This, Seen.Was, Readings_Of (This.Checks), Input, Seen.Rising,
         Gains_Of (Table), Extra);
   end Steer;

   function Next
     (This     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number   := 0;
      Sticks   : Stick_Inputs   := No_Sticks;
      Extra    : Command_Inputs := No_Commands) return Memory
   is
      Seen : Observation;
   begin
      return After : Memory := This do
         Observe (After, Commands, Sensors, By, Seen);
         Steer (After, Commands, Seen, Sticks, Extra, Table);
      end return;
   end Next;

end URV.Laws.Frames;
