--  SPDX-License-Identifier: Apache-2.0

--  What --orbit-after and --terminate-after say: how long after the last
--  uplink the aircraft begins its orbit, and how long after it its flight is
--  terminated (EXT-5). They are the times that the ground may set, too, in
--  the same ranges (URV.Configurations).

with URV.Configurations; use URV.Configurations;
with URV.Law_Gains;
with URV.Link_Loss;

package Host.Loss_Times is

   --  In tenths of a second.
   type Pair is record
      Orbit  : Orbit_Tenths :=
        URV.Law_Gains.Orbit_After / Frames_Per_Tenth;
      Finish : End_Tenths :=
        URV.Law_Gains.Terminate_After / Frames_Per_Tenth;
   end record;

   --  For texts that explain them: 0.1 s, "1 to 60".
   Orbit_Range  : constant String := "1 to 60";
   Finish_Range : constant String := "2 to 300";

   --  Raise Bad_Input.

   procedure Read_Orbit (Value : String; Item : in out Pair);

   procedure Read_Finish (Value : String; Item : in out Pair);

   --  All options are read. Times are of no use without the laws, and the
   --  end comes after the orbit's beginning.
   procedure Check (Item : Pair; Is_Given, Has_Laws : Boolean);

   function Frames_Of (Item : Pair) return URV.Link_Loss.Times;

end Host.Loss_Times;
