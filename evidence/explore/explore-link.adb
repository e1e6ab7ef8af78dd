--  SPDX-License-Identifier: Apache-2.0

with Ada.Containers.Vectors;
with Ada.Text_IO;
with Ada.Unchecked_Deallocation;
with Explore.Aircraft_Sides;
with Explore.Ground_Sides;
with Interfaces; use Interfaces;

package body Explore.Link is

   package Ground renames Explore.Ground_Sides;
   package Aircraft renames Explore.Aircraft_Sides;

   type Pair is record
      Ground   : Side;
      Aircraft : Side;
   end record;

   package Pair_Vectors is new Ada.Containers.Vectors (Natural, Pair);

   --  How far it is from a state to the end of every way: Unknown, being
   --  looked at, or one more than the distance.
   type Distance is range 0 .. 2 ** 16 - 1 with Size => 16;
   Unknown    : constant Distance := 0;
   On_The_Way : constant Distance := Distance'Last;

   Calm     : Pair_Vectors.Vector;
   Way_Gone : Pair_Vectors.Vector;

   type Flags is array (Long_Long_Integer range <>) of Boolean with Pack;
   type Flags_Access is access Flags;
   Is_Calm : Flags_Access;

   --  How many sides there are of either that faults may lead to.
   Ups, Downs : Side := 0;

   --  And how many there is room for. States found later receive a message
   --  from its first character on, after the last fault.
   More                 : constant := 6_000;
   Ups_Room, Downs_Room : Side := 0;

   function Place (Item : Pair) return Long_Long_Integer is
     (Long_Long_Integer (Item.Ground) * Long_Long_Integer (Downs_Room)
      + Long_Long_Integer (Item.Aircraft));

   --  The pairs of which both sides are quiet.
   procedure Find_Calm;

   procedure Find_Calm is
   begin
      Is_Calm := new Flags
        (0 .. Long_Long_Integer (Ups_Room) * Long_Long_Integer (Downs_Room)
              - 1);
      Is_Calm.all := (others => False);
      for Up in 0 .. Ups - 1 loop
         if Ground.Is_Quiet (Up) then
            for Down in 0 .. Downs - 1 loop
               if Aircraft.Is_Quiet (Down) then
                  Is_Calm (Place ((Up, Down))) := True;
                  Calm.Append (Pair'(Up, Down));
               end if;
            end loop;
         end if;
      end loop;
   end Find_Calm;

   procedure Find_Quiet (Result : out Findings) is
      type Distances is array (Long_Long_Integer range <>) of Distance;
      type Distances_Access is access Distances;
      procedure Free is new Ada.Unchecked_Deallocation
        (Distances, Distances_Access);
      Known  : Distances_Access;
      Length : Distance;

      procedure Go (From : Pair; Far : out Distance);

      procedure Go (From : Pair; Far : out Distance) is
         Here       : Distance renames Known (Place (From));
         Most       : Distance := 1;
         Beyond     : Distance;
         G, H, A, B : Natural;
      begin
         if Here = On_The_Way then
            Result.Ends_Always := False;
            Way_Gone.Append (From);
         elsif Here = Unknown then
            Result.States := Result.States + 1;
            if Is_Calm (Place (From)) then
               Here := 1;
               Far := Here;
               return;
            end if;

            Here := On_The_Way;
            Ground.Step
              (From.Ground, Aircraft.On_Line (From.Aircraft), Does_Either,
               G, H);
            Aircraft.Step
              (From.Aircraft, Ground.On_Line (From.Ground), Does_Either,
               A, B);
            for I in G .. H loop
               for J in A .. B loop
                  Result.Transitions := Result.Transitions + 1;
                  Go ((Ground.Nth (I).To, Aircraft.Nth (J).To), Beyond);
                  if Beyond = On_The_Way then
                     Way_Gone.Append (From);
                     Far := On_The_Way;
                     return;
                  end if;
                  Most := Distance'Max (Most, Beyond);
               end loop;
            end loop;
            Here := Most + 1;
         end if;
         Far := Here;
      end Go;
   begin
      Result := (others => <>);
      Way_Gone.Clear;
      Ups := Side (Ground.Sides_Found);
      Downs := Side (Aircraft.Sides_Found);
      Ups_Room := Ups + More;
      Downs_Room := Downs + More;
      Known := new Distances
        (0 .. Long_Long_Integer (Ups_Room) * Long_Long_Integer (Downs_Room)
              - 1);
      Known.all := (others => Unknown);
      Find_Calm;
      Search :
      for Up in 0 .. Ups - 1 loop
         for Down in 0 .. Downs - 1 loop
            Go ((Up, Down), Length);
            exit Search when not Result.Ends_Always;
            Result.Worst := Natural'Max (Result.Worst, Natural (Length) - 1);
         end loop;
      end loop Search;
      Free (Known);

      if Side (Ground.Sides_Found) > Ups_Room
        or else Side (Aircraft.Sides_Found) > Downs_Room
      then
         raise Program_Error with "there are more sides than there is room";
      end if;
   end Find_Quiet;

   function Calm_Pairs return Natural is (Natural (Calm.Length));

   procedure Find_Delivery (Way : Direction; Result : out Findings) is

      Frame : constant Positive := Explore.Frame;
      subtype Moment is Natural range 0 .. Frame - 1;

      --  The states with their distances, by a hash of the state: the
      --  distance in the low 16 bits, the state above. No state is 0. Both
      --  controllers' frames are as long, so how far they are apart stays as
      --  it is: states of another distance are searched by themselves, and
      --  these few stay in the processor's caches.
      type Known_States is array (Unsigned_64 range <>) of Unsigned_64;
      type Known_States_Access is access Known_States;
      Nothing : constant Unsigned_64 := 0;
      Bits    : Natural := 17;
      Used    : Long_Long_Integer := 0;
      Known   : Known_States_Access :=
        new Known_States'(0 .. 2 ** Bits - 1 => Nothing);

      procedure Free (Item : in out Known_States_Access);

      function Spot (State : Unsigned_64) return Unsigned_64;

      procedure Set (State : Unsigned_64; Far : Distance);

      --  Until then the ground's, and the aircraft's controller puts its
      --  next block. Has_Come: the message that waits to be judged has the
      --  block that is followed.
      procedure Go
        (From                 : Pair;
         Until_Up, Until_Down : Moment;
         Has_Come             : Boolean;
         Far                  : out Distance);

      procedure Free (Item : in out Known_States_Access) is
         procedure Release is new Ada.Unchecked_Deallocation
           (Known_States, Known_States_Access);
      begin
         Release (Item);
      end Free;

      function Spot (State : Unsigned_64) return Unsigned_64 is
         Mask   : constant Unsigned_64 := 2 ** Bits - 1;
         Result : Unsigned_64 :=
           Shift_Right (State * 16#9E37_79B9_7F4A_7C15#, 64 - Bits);
      begin
         while Known (Result) /= Nothing
           and then Shift_Right (Known (Result), 16) /= State
         loop
            Result := (Result + 1) and Mask;
         end loop;
         return Result;
      end Spot;

      procedure Set (State : Unsigned_64; Far : Distance) is
         At_Spot : Unsigned_64 := Spot (State);
         Old     : Known_States_Access;
      begin
         if Known (At_Spot) = Nothing then
            Used := Used + 1;
            if Used * 4 > Known'Length * 3 then
               Old := Known;
               Bits := Bits + 1;
               Known := new Known_States'(0 .. 2 ** Bits - 1 => Nothing);
               for Item of Old.all loop
                  if Item /= Nothing then
                     Known (Spot (Shift_Right (Item, 16))) := Item;
                  end if;
               end loop;
               Free (Old);
               At_Spot := Spot (State);
            end if;
         end if;
         Known (At_Spot) := Shift_Left (State, 16) or Unsigned_64 (Far);
      end Set;

      procedure Go
        (From                 : Pair;
         Until_Up, Until_Down : Moment;
         Has_Come             : Boolean;
         Far                  : out Distance)
      is
         State      : constant Unsigned_64 :=
           ((Unsigned_64 (From.Ground) * 2 ** 16
             + Unsigned_64 (From.Aircraft)) * 2 ** 8
            + Unsigned_64 (Until_Up)) * 2
           + Boolean'Pos (Has_Come) + 1;
         At_Spot    : constant Unsigned_64 := Spot (State);
         G, H, A, B : Natural;
         Most       : Distance := 0;
         Beyond     : Distance;
         Comes      : Boolean;
      begin
         if Known (At_Spot) /= Nothing then
            Far := Distance (Known (At_Spot) and 16#FFFF#);
            if Far = On_The_Way then
               Result.Ends_Always := False;
               Way_Gone.Append (From);
            end if;
            return;
         end if;

         Result.States := Result.States + 1;
         Set (State, On_The_Way);
         Ground.Step
           (From.Ground, Aircraft.On_Line (From.Aircraft),
            (if Until_Up > 0 then Waits
             elsif Way = Uplink then Puts_Fresh else Puts_Old),
            G, H);
         Aircraft.Step
           (From.Aircraft, Ground.On_Line (From.Ground),
            (if Until_Down > 0 then Waits
             elsif Way = Downlink then Puts_Fresh else Puts_Old),
            A, B);
         Comes :=
           (if Way = Uplink then Ground.Ends_Block (From.Ground, True)
            else Aircraft.Ends_Block (From.Aircraft, True));
         for I in G .. H loop
            for J in A .. B loop
               Result.Transitions := Result.Transitions + 1;
               if (Comes or else Has_Come)
                 and then (if Way = Uplink then Aircraft.Nth (J).Good
                           else Ground.Nth (I).Good)
               then
                  Beyond := 1;
               else
                  Go
                    ((Ground.Nth (I).To, Aircraft.Nth (J).To),
                     (Until_Up - 1) mod Frame,
                     (Until_Down - 1) mod Frame,
                     (Comes or else Has_Come)
                     and then
                       (if Way = Uplink
                        then Aircraft.Waits_At_End (Aircraft.Nth (J).To)
                        else Ground.Waits_At_End (Ground.Nth (I).To)),
                     Beyond);
               end if;
               if Beyond = On_The_Way then
                  Way_Gone.Append (From);
                  Far := On_The_Way;
                  return;
               end if;
               Most := Distance'Max (Most, Beyond);
            end loop;
         end loop;
         Far := Most + 1;
         Set (State, Far);
      end Go;

      Length : Distance;
   begin
      Result := (others => <>);
      Way_Gone.Clear;
      Search :
      for Apart in Moment loop
         Known.all := (others => Nothing);
         Used := 0;
         for Item of Calm loop
            for Until_Up in Moment loop
               Go (Item, Until_Up, (Until_Up + Apart) mod Frame, False,
                   Length);
               exit Search when not Result.Ends_Always;
               Result.Worst :=
                 Natural'Max (Result.Worst, Natural (Length) - 1);
            end loop;
         end loop;
      end loop Search;
      Free (Known);
   end Find_Delivery;

   procedure Print_Way is
      use Ada.Text_IO;
   begin
      for Item of reverse Way_Gone loop
         Put_Line
           ("   " & Ground.Image (Item.Ground) & " | "
            & Aircraft.Image (Item.Aircraft));
      end loop;
   end Print_Way;

end Explore.Link;
