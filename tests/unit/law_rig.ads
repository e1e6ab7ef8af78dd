--  SPDX-License-Identifier: Apache-2.0

--  A common basis for tests of the control laws: an undisturbed flight, and
--  the aircraft's LAW task in it.

with URV.Buffers; use URV.Buffers;

package Law_Rig is

   --  Level at 1000 ft and 70 kt, sticks at rest.

   Level : constant Downlink_Buffer :=
     (Altitude     => 2_000,
      Airspeed     => 2_240,
      RPM          => 2_500,
      Error_Status => No_Error,
      others       => Neutral_Value);

   Sticks : constant Uplink_Buffer :=
     (Throttle     => 2_048,
      Brake        => Neutral_Value,
      Switch_Item  => 0,
      Error_Status => No_Error,
      others       => Neutral_Value);

   --  Runs the task for this number of frames with the laws on; then they are
   --  off.
   procedure Fly
     (Frames   : Positive;
      Sensors  : Downlink_Buffer := Level;
      Commands : Uplink_Buffer   := Sticks);

end Law_Rig;
