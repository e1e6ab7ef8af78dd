--  SPDX-License-Identifier: Apache-2.0

--  The values of --orbit-after and --terminate-after: the times from the last
--  uplink to the orbit and to the termination of the flight (EXT-5, FRM-7).
--  The ground may set the same times, in the same ranges (URV.Configurations).

with URV.Configurations; use URV.Configurations;
with URV.Frame_Times;    use URV.Frame_Times;
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

   --  For explanations: 0.1 s, "1 to 60".
   Orbit_Range  : constant String := "1 to 60";
   Finish_Range : constant String := "2 to 300";

   --  These raise Bad_Input.

   procedure Read_Orbit (Value : String; Item : in out Pair);

   procedure Read_Finish (Value : String; Item : in out Pair);

   --  Checks the times after all options are read: they need the laws, and the
   --  termination must come after the orbit.
   procedure Check (Item : Pair; Is_Given, Has_Laws : Boolean);

   function Frames_Of (Item : Pair) return URV.Link_Loss.Times;

end Host.Loss_Times;
