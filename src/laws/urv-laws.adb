--  SPDX-License-Identifier: Apache-2.0

with URV.Laws.Flying; use URV.Laws.Flying;

package body URV.Laws with SPARK_Mode is

   function Next
     (This     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number := 0) return Memory
   is
      Checks : constant Check_Table :=
        Sensor_Checks.Next (This.Checks, Sensors);
      Heard  : constant Uplink_Buffer :=
        (if Is_Old (Commands) then This.Heard else Commands);
      After  : Memory := This;
      Now    : Readings;
      Input  : Sticks;
      Rising : Number;
   begin
      After.Link := Link_Loss.Next
        (This.Link, not Is_Old (Commands), Is_On (Commands (Switch_7)), By);
      After.Heard := Heard;
      After.Checks := Checks;
      Now := Readings_Of (Checks);
      if not This.Checks (Altitude).Is_Valid then
         After.Smoothed := Now.Altitude * 1_000;
      end if;
      Rising := Climb_Rate (After.Smoothed, Now.Altitude);
      After.Smoothed := Next_Smooth (After.Smoothed, Now.Altitude);
      if After.Link.State not in Lost then
         After.Is_Flying := not Is_On_Ground (Checks);
      end if;

      After.Flown :=
        (if Is_Disconnected (Commands) then All_Direct
         else Allowed
           (Wanted (After.Link.State, Heard, After.Is_Flying), Checks));

      --  The disconnect has priority over all else.
      if Is_Disconnected (Commands) or else After.Link.State = Waiting then
         After.Is_Stick := (Axis => True);
         Input := Sticks_Of (Heard, Linked);
      else
         Input := Sticks_Of (Heard, After.Link.State);
      end if;

      Fly (After, This.Flown, Now, Input, Rising, Gains_Of (Table));
      pragma Assert
        (Word_Of (After.Checks, Roll_Attitude) =
           Word_Of (Checks, Roll_Attitude)
         and then Word_Of (After.Checks, Pitch_Attitude) =
           Word_Of (Checks, Pitch_Attitude));
      return After;
   end Next;

end URV.Laws;
