--  SPDX-License-Identifier: Apache-2.0

with URV.Laws.Flying; use URV.Laws.Flying;

package body URV.Laws with SPARK_Mode is

   procedure Advance
     (This     : in out Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number := 0)
   is
      Was         : constant Modes   := This.Flown;
      Had_Height  : constant Boolean := This.Checks (Altitude).Is_Valid;
      Is_Cut      : constant Boolean := Is_Disconnected (Commands);
      Measured    : Readings;
      Input : Sticks;
      Rising      : Number;
   begin
      This.Link := Link_Loss.Next
        (This.Link, not Is_Old (Commands), Is_On (Commands (Switch_7)), By);
      if not Is_Old (Commands) then
         This.Heard := Commands;
      end if;
      Sensor_Checks.Advance (This.Checks, Sensors);
      Measured := Readings_Of (This.Checks);
      if not Had_Height then
         This.Smoothed := Measured.Altitude * 1_000;
      end if;
      Rising := Climb_Rate (This.Smoothed, Measured.Altitude);
      This.Smoothed := Next_Smooth (This.Smoothed, Measured.Altitude);
      if This.Link.State not in Lost then
         This.Is_Flying := not Is_On_Ground (This.Checks);
      end if;

      This.Flown :=
        (if Is_Cut then All_Direct
         else Allowed
           (Wanted (This.Link.State, This.Heard, This.Is_Flying),
            This.Checks));

      --  The disconnect has priority over all else.
      if Is_Cut or else This.Link.State = Waiting then
         This.Is_Stick := (Axis => True);
         Input := Sticks_Of (This.Heard, Linked);
      else
         Input := Sticks_Of (This.Heard, This.Link.State);
      end if;

      Fly (This, Was, Measured, Input, Rising, Gains_Of (Table));
   end Advance;

   function Next
     (This     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number := 0) return Memory
   is
   begin
      return After : Memory := This do
         Advance (After, Commands, Sensors, By, Table);
      end return;
   end Next;

end URV.Laws;
