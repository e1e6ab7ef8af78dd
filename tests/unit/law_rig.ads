--  SPDX-License-Identifier: Apache-2.0

--  A common basis for tests of the control laws: an undisturbed flight, and
--  the aircraft's LAW task in it.

with URVOS;          use URVOS;
with URV.Buffers;    use URV.Buffers;
with URV.Test_Cards; use URV.Test_Cards;

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

   --  A switch is on.
   On_Word : constant Word := 16#FFF#;

   --  A doublet of both elevators, 100 words for 0.4 s to either side.
   Doublet_Card : constant Card :=
     (Head      => 1 * 256 + Card_Kind'Pos (Doublet),
      Surfaces  => 2 ** Test_Surface'Pos (Left_Elevator)
                   + 2 ** Test_Surface'Pos (Right_Elevator),
      Amplitude => 100,
      Time      => 40,
      First     => 0,
      Last      => 0,
      Attitude  => 45 + 64 * 30,
      Airflow   => 12 + 64 * 10,
      Slowest   => 55 * 32,
      Fastest   => 100 * 32,
      Lowest    => 600);

   --  Runs the task for this number of frames with the laws on; then they are
   --  off.
   procedure Fly
     (Frames   : Positive;
      Sensors  : Downlink_Buffer := Level;
      Commands : Uplink_Buffer   := Sticks);

end Law_Rig;
