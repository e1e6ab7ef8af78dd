--  SPDX-License-Identifier: Apache-2.0

with Host.Runway;

package body Sim.Circuit_Quality is

   Second : constant Long_Float := Long_Float (Microseconds_Per_Second);

   --  Above this height the aircraft has flown; it is at rest when no faster
   --  than this for a frame.
   Flown_Above   : constant Long_Float := 50.0;   --  ft
   Slower_Than   : constant Long_Float := 0.3;    --  ft/s
   Frame_Seconds : constant Long_Float :=
     Long_Float (Major_Frame) / Second;

   --  Sink is the hardest of all touchdowns; each bounce adds one. The place
   --  is that of the first.
   type Observations is record
      Last          : Flight_State;
      Has_Lifted    : Boolean      := False;
      Lift_Off_East : Long_Float   := 0.0;
      Highest       : Long_Float   := 0.0;
      Has_Flown     : Boolean      := False;
      Touchdowns    : Natural      := 0;
      Sink          : Long_Float   := 0.0;
      North, East   : Long_Float   := 0.0;
      Airspeed      : Long_Float   := 0.0;
      Is_At_Rest    : Boolean      := False;
      Stop_Time     : Microseconds := 0;
   end record;

   Seen : Observations;

   procedure Start is
   begin
      Seen := (others => <>);
   end Start;

   procedure Observe (Time : Microseconds; Truth : Flight_State) is
      Before : Flight_State renames Seen.Last;
      Moved  : constant Long_Float :=
        Long_Float'Max
          (abs (Truth.North - Before.North), abs (Truth.East - Before.East));
      Is_At_Rest : Boolean;
   begin
      if Before.Wheels > 0.0 and then Truth.Wheels = 0.0
        and then not Seen.Has_Flown
      then
         Seen.Has_Lifted    := True;
         Seen.Lift_Off_East := Truth.East;
      end if;
      Seen.Highest   := Long_Float'Max (Seen.Highest, Truth.Altitude);
      Seen.Has_Flown := Seen.Has_Flown or else Truth.Altitude > Flown_Above;

      if Seen.Has_Flown and then Before.Wheels = 0.0
        and then Truth.Wheels > 0.0
      then
         if Seen.Touchdowns = 0 then
            Seen.North    := Truth.North;
            Seen.East     := Truth.East;
            Seen.Airspeed := Truth.Airspeed;
         end if;
         Seen.Touchdowns := Seen.Touchdowns + 1;
         Seen.Sink       := Long_Float'Max (Seen.Sink, -Before.Climb);
      end if;

      Is_At_Rest :=
        Seen.Touchdowns > 0 and then Truth.Wheels > 0.0
        and then not Truth.Crashed
        and then Moved < Slower_Than * Frame_Seconds;
      if Is_At_Rest and then not Seen.Is_At_Rest then
         Seen.Stop_Time := Time;
      end if;
      Seen.Is_At_Rest := Is_At_Rest;
      Seen.Last   := Truth;
   end Observe;

   procedure Report (To : in out Summary.Result) is

      procedure Add (Name : String; Value : Long_Float);
      procedure Add (Name : String; Value : Boolean);

      procedure Add (Name : String; Value : Long_Float) is
      begin
         Summary.Add_Quality (To, Name, Value);
      end Add;

      procedure Add (Name : String; Value : Boolean) is
      begin
         Summary.Add_Quality (To, Name, Value);
      end Add;

      Now : Flight_State renames Seen.Last;
   begin
      Summary.Name_Quality (To, "circuit");
      if Seen.Has_Lifted then
         Add ("lift_off_along_ft", Seen.Lift_Off_East);
      end if;
      Add ("highest_ft", Seen.Highest);
      Add ("touchdowns", Long_Float (Seen.Touchdowns));
      if Seen.Touchdowns > 0 then
         Add ("touchdown_sink_ft_s", Seen.Sink);
         Add ("touchdown_offset_ft", Seen.North);
         Add ("touchdown_along_ft", Seen.East);
         Add ("touchdown_airspeed_kt", Seen.Airspeed);
      end if;
      Add ("stopped_on_runway",
           Seen.Is_At_Rest and then Runway.Is_On (Now.North, Now.East));
      if Seen.Is_At_Rest then
         Add ("stop_offset_ft", Now.North);
         Add ("stop_along_ft", Now.East);
         Add ("stopped_at_s", Long_Float (Seen.Stop_Time) / Second);
      end if;
      Add ("crashed", Now.Crashed);
   end Report;

end Sim.Circuit_Quality;
