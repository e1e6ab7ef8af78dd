--  SPDX-License-Identifier: Apache-2.0

with Expectations;       use Expectations;

package body Link_Rig is

   function Peer (Of_Station : Station) return Station is
     (if Of_Station = Ground then Aircraft else Ground);

   --  State of the random errors, and the number of characters that pass
   --  unchanged before the next one.
   type Random_State is mod 2 ** 32;
   Drops : Random_State := 1;
   Dry   : Natural      := 0;

   --  The distance of the tried cases.
   Spacing : constant Positive := (if Contracts_Are_Executed then 7 else 1);

   --  Every byte differs from its neighbours.
   function Block (Mark : Byte) return Block_Data;

   --  Records a character in the trace.
   procedure Note (This : in out Link; Sender : Station);

   --  Delivers a sender's character to the other station, if it arrives, and
   --  before it any character that the line has added.
   procedure Deliver
     (This   : in out Link;
      Sender : Station;
      Sent   : Coming;
      Fault  : Fault_Procedure);

   function Block (Mark : Byte) return Block_Data is
   begin
      return Result : Block_Data do
         for I in Result'Range loop
            Result (I) := Mark + 7 * Byte (I - 1);
         end loop;
      end return;
   end Block;

   procedure Note (This : in out Link; Sender : Station) is
   begin
      This.Sent (Sender) := This.Sent (Sender) + 1;
      if This.Turns > 0 and then This.Trace (This.Turns).Sender = Sender then
         This.Trace (This.Turns).Length := This.Trace (This.Turns).Length + 1;
      elsif This.Turns < Longest_Trace then
         This.Turns := This.Turns + 1;
         This.Trace (This.Turns) := (Sender, 1);
      end if;
   end Note;

   function Slow_Link (One_Way : Line_Time; Told : Boolean := True)
     return Link
   is
      Round_Trip : constant Round_Trip_Time :=
        (if Told then 2 * Round_Trip_Time (One_Way) else 0);
   begin
      return Result : Link do
         Result.One_Way := One_Way;
         Set_Round_Trip (Result.Ground_Board, Round_Trip);
         Set_Round_Trip (Result.Aircraft_Board, Round_Trip);
      end return;
   end Slow_Link;

   procedure Deliver
     (This   : in out Link;
      Sender : Station;
      Sent   : Coming;
      Fault  : Fault_Procedure)
   is
      procedure Hear (Heard : Byte; Parity_Error : Boolean := False);

      procedure Hear (Heard : Byte; Parity_Error : Boolean := False) is
      begin
         if Sender = Ground then
            Accept_Character (This.Aircraft_Board, Heard, Parity_Error);
         else
            Accept_Character (This.Ground_Board, Heard, Parity_Error);
         end if;
      end Hear;

      What : Arrival := Whole;
      Mask : Byte    := 0;
   begin
      if This.Added (Sender).Is_There then
         This.Added (Sender).Is_There := False;
         Hear (This.Added (Sender).Data);
      end if;
      if not Sent.Is_There then
         return;
      end if;
      if Fault /= null then
         Fault (Sender, Sent.Number, What, Mask);
      end if;
      case What is
         when Whole      => Hear (Sent.Data);
         when Changed    => Hear (Sent.Data xor Mask);
         when Odd_Parity => Hear (Sent.Data xor Mask, Parity_Error => True);
         when Lost       => null;
         when Doubled    =>
            Hear (Sent.Data);
            This.Added (Sender) := (True, Sent.Data xor Mask);
      end case;
   end Deliver;

   procedure Run
     (This  : in out Link;
      Times : Natural;
      Fault : Fault_Procedure := null)
   is
      type Outputs is array (Station) of Byte;
      type Output_Flags is array (Station) of Boolean;
      Data : Outputs;
      Send : Output_Flags;
   begin
      for Time in 1 .. Times loop
         Next_Character
           (This.Ground_Board, Send (Ground), Data (Ground));
         Next_Character
           (This.Aircraft_Board, Send (Aircraft), Data (Aircraft));
         Elapse (This.Ground_Board, 1);
         Elapse (This.Aircraft_Board, 1);
         for Sender in Station loop
            if Send (Sender) then
               Note (This, Sender);
            end if;
            declare
               Line : Coming_List renames This.On_Its_Way (Sender);
            begin
               Line (This.One_Way) :=
                 (Send (Sender), Positive'Max (1, This.Sent (Sender)),
                  Data (Sender));
               Deliver (This, Sender, Line (0), Fault);
               for Place in Line_Time range 1 .. Line_Time'Last loop
                  Line (Place - 1) := Line (Place);
               end loop;
               Line (Line_Time'Last) := (others => <>);
            end;
         end loop;
      end loop;
   end Run;

   procedure Give (This : in out Link; From : Station; Mark : Byte) is
      Unused_Overwrote : Boolean;
   begin
      This.Given (From) := Mark;
      if From = Ground then
         Put (This.Ground_Board, Block (Mark), Unused_Overwrote);
      else
         Put (This.Aircraft_Board, Block (Mark), Unused_Overwrote);
      end if;
   end Give;

   procedure Take (This : in out Link; At_Station : Station; Mark : out Byte)
   is
      From   : constant Station := Peer (At_Station);
      Length : constant Byte_Index :=
        (if At_Station = Ground then Downlink_Length else Uplink_Length);

      Data, Expected : Block_Data;
      Fresh, Ever    : Boolean;
   begin
      if At_Station = Ground then
         Take (This.Ground_Board, Data, Fresh, Ever);
      else
         Take (This.Aircraft_Board, Data, Fresh, Ever);
      end if;

      Mark := 0;
      if Fresh then
         Expect ("a fresh block without any ever received", Ever, True);
         Mark     := Data (1);
         Expected := Block (Mark);
         Expect
           ("a wrong block",
            (for some I in 1 .. Length => Data (I) /= Expected (I)), False);
         Expect
           ("block" & Mark'Image & " is older than the one before,"
            & This.Came_Out (From)'Image,
            Mark < This.Came_Out (From), False);
         Expect
           ("block" & Mark'Image & " was not given yet",
            Mark > This.Given (From), False);
         This.Came_Out (From) := Mark;
      end if;
   end Take;

   procedure Fly
     (This   : in out Link;
      Frames : Positive;
      First  : Byte;
      Phase  : Natural;
      Fault  : Fault_Procedure := null)
   is
      Unused : Byte;
   begin
      for Number in 0 .. Frames - 1 loop
         Give (This, Ground, First + Byte (Number));
         Run (This, Phase, Fault);
         Give (This, Aircraft, First + Byte (Number));
         Take (This, Aircraft, Unused);
         Run (This, Frame - Phase, Fault);
         Take (This, Ground, Unused);
      end loop;
   end Fly;

   procedure Start_Rain is
   begin
      Drops := 1;
      Dry   := 0;
   end Start_Rain;

   procedure Rain
     (Sender : Station;
      Number : Positive;
      What   : out Arrival;
      Mask   : out Byte)
   is
      pragma Unreferenced (Sender, Number);
   begin
      What := Whole;
      Mask := 0;
      if Dry > 0 then
         Dry := Dry - 1;
      else
         Drops := 1_664_525 * Drops + 1_013_904_223;
         Dry   := 60 + Natural (Drops / 2 ** 24);
         Mask  := 2 ** Natural (Drops / 2 ** 8 mod 8);
         What  := Arrival'Val (1 + Drops / 2 ** 16 mod 4);
      end if;
   end Rain;

   function Is_Tried (Case_Number : Natural) return Boolean is
     (Case_Number mod Spacing = 0);

end Link_Rig;
