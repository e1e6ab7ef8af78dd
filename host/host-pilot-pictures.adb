--  SPDX-License-Identifier: Apache-2.0

with Host.Runway;

package body Host.Pilot.Pictures is

   Interval : constant Long_Float :=
     Long_Float (Major_Frame) / Long_Float (Microseconds_Per_Second);

   Feet_Per_Second_Per_Knot : constant Long_Float := 1.687_81;
   Gravity                  : constant Long_Float := 32.174;   --  ft/s2

   --  The share of a difference that is accepted: per second from the
   --  altimeter for height and climb; per look for heading, place and wind.
   Height_Share  : constant Long_Float := 1.4;
   Climb_Share   : constant Long_Float := 1.0;
   Heading_Share : constant Long_Float := 0.10;
   Place_Share   : constant Long_Float := 0.25;
   Wind_Share    : constant Long_Float := 0.04;

   --  Readings that make the zero; then it is fixed.
   Enough : constant := 100;

   --  The same angle, from -180 up to 180 degrees.
   function Nearest (Angle : Long_Float) return Long_Float is
     (Angle - 360.0 * Long_Float'Floor ((Angle + 180.0) / 360.0));

   --  For any heading.
   function East_Share (Heading : Long_Float) return Long_Float;
   function North_Share (Heading : Long_Float) return Long_Float is
     (East_Share (Heading + 90.0));

   function East_Share (Heading : Long_Float) return Long_Float is
      Angle : constant Long_Float := Nearest (Heading);
   begin
      return
        (if Angle > 90.0 then Sine (180.0 - Angle)
         elsif Angle < -90.0 then -Sine (180.0 + Angle)
         else Sine (Angle));
   end East_Share;

   procedure Start (Made : out Picture) is
   begin
      Made := (Heading => Runway.Heading, others => <>);
   end Start;

   procedure Set_Zero (Known : in out Picture; Now : Reading) is
   begin
      if Known.Zeroed < Enough then
         Known.Zeroed := Known.Zeroed + 1;
         Known.Zero   :=
           Known.Zero
           + (Now.Altitude - Known.Zero) / Long_Float (Known.Zeroed);
      end if;
      Known.Height := 0.0;
      Known.Climb  := 0.0;
   end Set_Zero;

   procedure Dead_Reckon
     (Known     : in out Picture;
      Now       : Reading;
      On_Wheels : Boolean)
   is
      Upward : constant Long_Float :=
        Gravity * (Now.Load * Cosine (Now.Bank) * Cosine (Now.Pitch) - 1.0);
      Higher : constant Long_Float :=
        Now.Altitude - Known.Zero - Known.Height;
      Drift   : constant Long_Float := (if On_Wheels then 0.0 else 1.0);
      Course  : Long_Float;
   begin
      Known.Height :=
        Known.Height + (Known.Climb + Height_Share * Higher) * Interval;
      Known.Climb :=
        Known.Climb + (Upward + Climb_Share * Higher) * Interval;

      Known.Turn    := Turn_Rate (Now);
      Known.Heading := Known.Heading + Known.Turn * Interval;

      --  In a slip the track differs from the heading.
      Course := Known.Heading + Drift * Now.Beta;
      Known.Speed   :=
        Long_Float'Max (0.0, Now.Airspeed) * Feet_Per_Second_Per_Knot;
      Known.North_Speed :=
        Known.Speed * North_Share (Course) + Drift * Known.Wind_North;
      Known.East_Speed :=
        Known.Speed * East_Share (Course) + Known.Wind_East;
      Known.North := Known.North + Known.North_Speed * Interval;
      Known.East  := Known.East + Known.East_Speed * Interval;
   end Dead_Reckon;

   procedure Correct
     (Known     : in out Picture;
      Seen      : View;
      On_Wheels : Boolean)
   is
      North : constant Long_Float := Seen.North - Known.North;
      East  : constant Long_Float := Seen.East - Known.East;
   begin
      Known.Heading :=
        Known.Heading
        + Heading_Share * Nearest (Seen.Heading - Known.Heading);
      Known.North := Known.North + Place_Share * North;
      Known.East  := Known.East + Place_Share * East;
      Known.Wind_East := Known.Wind_East + Wind_Share * East;
      if not On_Wheels then
         Known.Wind_North := Known.Wind_North + Wind_Share * North;
      end if;
   end Correct;

end Host.Pilot.Pictures;
